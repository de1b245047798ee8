/* wire_rig - see wire_rig.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/wire_rig.h"

#include <stdlib.h>
#include <string.h>

static int is_of_some_frame(const wire_rig *r, uint32_t at, const uint8_t *row, uint32_t bytes) {
    for (uint32_t i = r->frames; i > 0; i--) {
        if (memcmp(r->shown[i - 1] + at, row, bytes) == 0) {
            return 1;
        }
    }
    return 0;
}

/* The window of a display controller; counts rows outside and rows
 * that no frame had. */
static void put_row(void *context, unsigned x, unsigned y, unsigned width, const uint8_t *pixels) {
    wire_rig *r = context;
    const uint32_t bytes = wire_row_bytes(r->shape.format, width);
    r->rows++;
    if (x % 16 != 0 || x + width > r->shape.width || y >= r->shape.height) {
        r->wrong_rows++;
        return;
    }
    const uint32_t at = y * r->stride + wire_row_bytes(r->shape.format, x);
    r->wrong_rows += !is_of_some_frame(r, at, pixels, bytes);
    memcpy(r->panel + at, pixels, bytes);
}

void wire_rig_start_host(wire_rig *r) {
    const wire_setup setup = {.role = WIRE_HOST,
                              .caps = {.session = 1000 + ++r->hosts,
                                       .in_bytes = (uint16_t)r->shape.in_bytes,
                                       .out_bytes = (uint16_t)r->shape.out_bytes,
                                       .credits = 16,
                                       .features = WIRE_SENDS}};
    wire_peer_open(&r->host, &setup, r->cable.now_ms);
    wire_frames_out_open(&r->out, &r->host);
    wire_frames_reference(&r->out, r->reference, r->panel_bytes);
}

void wire_rig_start_device(wire_rig *r) {
    const int reads = r->shape.reads;
    const wire_setup setup = {
        .role = WIRE_DEVICE,
        .caps = {.session = 2000 + ++r->devices,
                 .in_bytes = (uint16_t)r->shape.out_bytes,
                 .out_bytes = (uint16_t)r->shape.in_bytes,
                 .width = (uint16_t)r->shape.width,
                 .height = (uint16_t)r->shape.height,
                 .format = (uint8_t)r->shape.format,
                 .credits = (uint8_t)r->shape.credits,
                 .features = (uint8_t)(WIRE_SHOWS | (reads ? WIRE_READS : 0))}};
    const wire_panel panel = {reads ? r->panel : NULL, r->stride, reads ? NULL : put_row, r};
    wire_peer_open(&r->device, &setup, r->cable.now_ms);
    wire_frames_in_open(&r->in, &r->device, &panel);
}

void wire_rig_open(wire_rig *r, rig_shape shape, uint64_t seed) {
    memset(r, 0, sizeof *r);
    r->shape = shape;
    r->stride = wire_row_bytes(shape.format, shape.width);
    r->panel_bytes = r->stride * shape.height;
    r->panel = calloc(1, r->panel_bytes);
    r->reference = calloc(1, r->panel_bytes);
    r->rgb = calloc(3, (size_t)shape.width * shape.height);
    r->spare = calloc(3, (size_t)shape.width * shape.height);
    fake_cable_open(&r->cable, &r->host, &r->device, seed);
    wire_rig_start_host(r);
    wire_rig_start_device(r);
}

void wire_rig_close(wire_rig *r) {
    free(r->panel);
    free(r->reference);
    free(r->rgb);
    free(r->spare);
    for (int i = 0; i < RIG_FRAMES; i++) {
        free(r->shown[i]);
    }
}

static void draw_pixel(wire_rig *r, uint8_t *at, unsigned x, unsigned y, int kind) {
    const unsigned t = r->frames;
    const unsigned ball = (x - 3 * t % 40) * (x - 3 * t % 40) + (y - 9) * (y - 9);
    if (kind == 1) {
        at[0] = at[1] = at[2] = (uint8_t)random_bits(&r->cable.random);
        at[1] ^= (uint8_t)(random_bits(&r->cable.random) & 31);
        return;
    }
    at[0] = (uint8_t)(ball < 60 ? 250 - 3 * ball : 2 * y + t);
    at[1] = (uint8_t)(ball < 60 ? 240 - 3 * ball : 2 * y);
    at[2] = (uint8_t)(ball < 60 ? 90 : 60 + y);
}

void wire_rig_draw(wire_rig *r, int kind) {
    const unsigned width = r->shape.width, height = r->shape.height;
    uint8_t *drawn = r->spare;
    r->spare = r->rgb;
    memcpy(drawn, r->rgb, 3 * (size_t)width * height);
    r->rgb = drawn;
    for (unsigned i = 0; kind == 2 && i < 5; i++) {
        r->rgb[random_below(&r->cable.random, 3 * width * height)] ^= 0xFF;
    }
    for (unsigned y = 0; kind != 2 && y < height; y++) {
        for (unsigned x = 0; x < width; x++) {
            draw_pixel(r, r->rgb + 3 * (y * width + x), x, y, kind);
        }
    }
}

int wire_rig_show(wire_rig *r) {
    if (r->frames == RIG_FRAMES ||
        wire_frames_show(&r->out, r->rgb, 3 * r->shape.width) != WIRE_OK) {
        return 0;
    }
    uint8_t *frame = r->shown[r->frames] = malloc(r->panel_bytes);
    for (unsigned y = 0; y < r->shape.height; y++) {
        wire_row_from_rgb(frame + y * r->stride, r->shape.format,
                          r->rgb + 3 * (size_t)y * r->shape.width, r->shape.width, 0, y);
    }
    r->frames++;
    return 1;
}

int wire_rig_wait(wire_rig *r, uint32_t most) {
    for (uint32_t i = 0; i < most; i++) {
        if (wire_frames_out_done(&r->out)) {
            return (int)i;
        }
        fake_cable_step(&r->cable);
    }
    return -1;
}

uint32_t wire_rig_differences(const wire_rig *r) {
    uint32_t n = 0;
    for (uint32_t i = 0; i < r->panel_bytes; i++) {
        n += r->panel[i] != r->shown[r->frames - 1][i];
    }
    return n;
}

uint32_t wire_rig_strangers(const wire_rig *r) {
    static const uint8_t blank[WIRE_ROW_BYTES_MAX] = {0};
    uint32_t strangers = 0;
    for (unsigned y = 0; y < r->shape.height; y++) {
        for (unsigned x = 0; x < r->shape.width; x += 16) {
            const unsigned width = r->shape.width - x < 16 ? r->shape.width - x : 16;
            const uint32_t bytes = wire_row_bytes(r->shape.format, width);
            const uint32_t at = y * r->stride + wire_row_bytes(r->shape.format, x);
            strangers += !is_of_some_frame(r, at, r->panel + at, bytes) &&
                         memcmp(r->panel + at, blank, bytes) != 0;
        }
    }
    return strangers;
}
