/* frames - see frames.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/frames.h"

#include <stdlib.h>
#include <string.h>

#include "board/hash.h"

static void paint(frame_result *r, uint8_t *times, const plt_frame *frame, const plt_tile *tile) {
    r->tiles++;
    for (uint32_t y = 0; y < tile->height; y++) {
        for (uint32_t x = 0; x < tile->width; x++) {
            const uint32_t to_x = tile->x + x, to_y = tile->y + y;
            if (to_x >= frame->width || to_y >= frame->height) {
                r->wrong++;
                continue;
            }
            const size_t pixel = (size_t)to_y * frame->width + to_x;
            memcpy(r->rgb + 3 * pixel, tile->rgb + 3 * ((size_t)y * tile->width + x), 3);
            times[pixel]++;
        }
    }
}

static void run(plt_engine *e, const plt_frame *frame, uint32_t visits, frame_result *r,
                uint8_t *times) {
    plt_stats before, after;
    plt_stats_get(e, &before);
    for (int status = PLT_MORE; status != PLT_OK; r->steps++) {
        status = plt_render_step(e, visits);
        plt_stats_get(e, &after);
        if (after.node_visits - before.node_visits > r->most_visits) {
            r->most_visits = after.node_visits - before.node_visits;
        }
        before = after;
        if (status == PLT_TILE) {
            plt_tile tile;
            plt_render_tile(e, &tile);
            paint(r, times, frame, &tile);
        } else if (status != PLT_MORE && status != PLT_OK) {
            r->status = status;
            return;
        }
    }
}

frame_result frame_render(plt_engine *e, const plt_frame *frame, uint32_t visits) {
    frame_result r = {.status = plt_render_begin(e, frame)};
    if (r.status != PLT_OK) {
        return r;
    }
    const size_t pixels = (size_t)frame->width * frame->height;
    uint8_t *times = calloc(pixels, 1);
    r.rgb = calloc(pixels, 3);
    run(e, frame, visits, &r, times);
    for (size_t i = 0; i < pixels; i++) {
        r.wrong += times[i] != 1;
    }
    r.hash = hash_bytes(r.rgb, 3 * pixels);
    free(times);
    return r;
}

uint64_t frame_hash(plt_engine *e, const plt_frame *frame, uint32_t visits) {
    const frame_result r = frame_render(e, frame, visits);
    free(r.rgb);
    return r.status == PLT_OK ? r.hash : 0;
}

plt_frame frame_of(const float eye[3], const float look[3], uint16_t width, uint16_t height,
                   uint8_t shader) {
    const plt_frame f = {.camera = {.eye = {eye[0], eye[1], eye[2]},
                                    .look = {look[0], look[1], look[2]},
                                    .up = {0, 1, 0},
                                    .tan_half_fov = 0.5f},
                         .width = width,
                         .height = height,
                         .shader = shader,
                         .samples = PLT_SAMPLES_ONE};
    return f;
}
