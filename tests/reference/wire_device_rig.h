/* wire_device_rig - a host with a scene, a device that renders it, and the cable between them
 *
 * Include it behind enum { WIDTH, HEIGHT, MEMORY }: pixels of the host's panel, and bytes of the
 * device's memory.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_WIRE_DEVICE_RIG_H
#define REFERENCE_WIRE_DEVICE_RIG_H

#include "platform/wire/wire_device.h"
#include "tests/reference/wire_fake.h"
#include "tests/test.h"

enum { GUARD = 64 };

static struct {
    wire_peer host;
    wire_frames_in frames;
    wire_scene_out scene;
    wire_view_out view;
    wire_blocks_out blocks;
    wire_device device;
    fake_cable cable;
    uint8_t panel[WIDTH * HEIGHT * 3];
    _Alignas(PLT_ALIGN) uint8_t memory[MEMORY + GUARD]; /* nobody writes the guard */
} e;

static const wire_setup host_setup = {.role = WIRE_HOST,
                                      .caps = {.session = 1,
                                               .in_bytes = 64,
                                               .out_bytes = 64,
                                               .width = WIDTH,
                                               .height = HEIGHT,
                                               .format = WIRE_RGB888,
                                               .credits = 16,
                                               .features = WIRE_SHOWS | WIRE_SCENES}};
static const wire_setup device_setup = {
    .role = WIRE_DEVICE,
    .caps = {
        .session = 2, .in_bytes = 64, .out_bytes = 64, .credits = 16, .features = WIRE_RENDERS}};

/* `image` stays where it is. */
static inline void open_rig(const void *image, uint32_t bytes, unsigned packet_side,
                            uint64_t seed) {
    const plt_options options = {
        .packet_side =
            (uint8_t)(PLT_PACKET_SIDE_MAX < packet_side ? PLT_PACKET_SIDE_MAX : packet_side)};
    const wire_panel panel = {e.panel, WIDTH * 3, NULL, NULL};
    memset(&e, 0, sizeof e);
    memset(e.memory + MEMORY, 0x5A, GUARD);
    fake_cable_open(&e.cable, &e.host, &e.device.peer, seed);
    wire_peer_open(&e.host, &host_setup, e.cable.now_ms);
    wire_frames_in_open(&e.frames, &e.host, &panel);
    wire_scene_out_open(&e.scene, &e.host, image, bytes);
    wire_blocks_out_open(&e.blocks, &e.host, image, bytes);
    wire_view_out_open(&e.view, &e.host);
    wire_device_open(&e.device, &device_setup, &options, e.memory, MEMORY, e.cable.now_ms);
}

/* What the engine renders without a wire. */
static inline void render_direct(plt_engine *engine, const wire_view *v,
                                 uint8_t rgb[WIDTH * HEIGHT * 3]) {
    plt_frame frame = {.width = WIDTH, .height = HEIGHT, .shader = v->shader};
    uint32_t pixels = 0;
    memcpy(frame.camera.eye, v->eye, sizeof v->eye);
    memcpy(frame.camera.look, v->look, sizeof v->look);
    memcpy(frame.camera.up, v->up, sizeof v->up);
    frame.camera.tan_half_fov = v->tan_half_fov;
    CHECK(plt_render_begin(engine, &frame) == PLT_OK, "the camera");
    for (int status = PLT_MORE; status > 0;) {
        plt_tile t;
        status = plt_render_step(engine, 10000);
        plt_render_tile(engine, &t);
        for (unsigned y = 0; status == PLT_TILE && y < t.height; y++) {
            memcpy(rgb + 3 * ((t.y + y) * WIDTH + t.x), t.rgb + 3u * y * t.width, 3u * t.width);
            pixels += t.width;
        }
    }
    CHECK(pixels == WIDTH * HEIGHT, "%u pixels rendered", pixels);
}

#endif
