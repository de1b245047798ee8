/* fuzz_wire_peer - a libFuzzer target: any payloads as reports to a display
 *
 *   clang -g -O1 -fsanitize=fuzzer,address,undefined -DPLT_TILE_SIDE=16 -I. \
 *       tests/fuzz/fuzz_wire_peer.c tests/reference/wire_fake.c \
 *       engine/base/crc32.c $(ls platform/wire/[a-z]*.c | grep -v wire/device.c)
 *
 * A session is brought up, then the input is cut into reports whose checksum
 * is made right, so that what is behind it is reached: the parsers of both
 * channels, frames, scene, blocks and keys, at a device or (first byte odd) a host.
 * Promised: no byte outside panel, image and reports; every call ends.
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/wire/report.h"
#include "tests/reference/wire_fake.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { WIDTH = 37, HEIGHT = 21, IMAGE = 1000, BLOCK = 100 };

static unsigned long reports_taken;

typedef struct side {
    wire_peer peer;
    wire_frames_out out;
    wire_frames_in in;
    wire_scene_out scene_out;
    wire_scene_in scene_in;
    wire_view_out view_out;
    wire_view_in view_in;
    wire_blocks_out blocks_out;
    wire_blocks_in blocks_in;
    wire_keys_out keys_out;
    wire_keys_in keys_in;
    uint8_t *panel, *image, *block; /* from malloc, for sanitizers */
} side;

static int no_pump(void *context) {
    (void)context;
    return -1;
}

static void open_side(side *s, unsigned role, unsigned format) {
    const wire_setup setup = {
        .role = (uint8_t)role,
        .caps = {.session = role + 5,
                 .in_bytes = 64,
                 .out_bytes = 64,
                 .width = WIDTH,
                 .height = HEIGHT,
                 .format = (uint8_t)format,
                 .credits = 8,
                 .features = WIRE_SHOWS | WIRE_READS | WIRE_SENDS | WIRE_RENDERS | WIRE_SCENES}};
    const uint32_t stride = wire_row_bytes(format, WIDTH);
    const wire_panel panel = {s->panel = malloc((size_t)stride * HEIGHT), stride, NULL, NULL};
    s->image = calloc(1, IMAGE);
    s->block = malloc(BLOCK);
    memset(s->panel, 0, (size_t)stride * HEIGHT);
    wire_peer_open(&s->peer, &setup, 0);
    wire_frames_out_open(&s->out, &s->peer);
    wire_frames_in_open(&s->in, &s->peer, &panel);
    wire_view_out_open(&s->view_out, &s->peer);
    wire_view_in_open(&s->view_in, &s->peer);
    wire_blocks_in_open(&s->blocks_in, &s->peer, no_pump, NULL);
    wire_keys_out_open(&s->keys_out, &s->peer);
    wire_keys_in_open(&s->keys_in, &s->peer);
    if (role == WIRE_HOST) {
        wire_scene_out_open(&s->scene_out, &s->peer, s->image, IMAGE);
        wire_blocks_out_open(&s->blocks_out, &s->peer, s->image, IMAGE);
    } else {
        wire_scene_in_open(&s->scene_in, &s->peer, s->image, IMAGE);
    }
    wire_block_ask(&s->blocks_in, 3, 200, s->block, BLOCK);
}

static void close_side(side *s) {
    free(s->panel);
    free(s->image);
    free(s->block);
}

/* Seals 58 bytes at most as the next report to `peer`. */
static void deliver(wire_peer *peer, const uint8_t *data, size_t count, uint32_t now) {
    uint8_t *report = calloc(1, 64), answer[64];
    memcpy(report + 5, data, count < 59 ? count : 59);
    const unsigned from = peer->role == WIRE_HOST ? WIRE_DEVICE : WIRE_HOST;
    wire_report_seal(report, 64, from, peer->key, peer->in_number, data[0] & 127, data[0] >> 7);
    reports_taken += (unsigned)wire_on_report(peer, report, 64, now);
    free(report);
    for (int i = 0; i < 20 && wire_next_report(peer, answer, now) > 0; i++) {
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static side host, device;
    static fake_cable cable;
    if (size < 2 || size > 1u << 16) {
        return 0;
    }
    const unsigned format = data[0] / 2 % WIRE_FORMATS;
    memset(&host, 0, sizeof host);
    memset(&device, 0, sizeof device);
    open_side(&host, WIRE_HOST, format);
    open_side(&device, WIRE_DEVICE, format);
    fake_cable_open(&cable, &host.peer, &device.peer, 1);
    cable.now_ms = 0;
    for (int i = 0; i < 20; i++) {
        fake_cable_step(&cable);
    }
    wire_peer *peer = data[0] & 1 ? &host.peer : &device.peer;
    for (size_t at = 1; at < size; at += 59) {
        deliver(peer, data + at, size - at, ++cable.now_ms);
    }
    wire_poll(peer, cable.now_ms + 300);
    close_side(&host);
    close_side(&device);
    return 0;
}
