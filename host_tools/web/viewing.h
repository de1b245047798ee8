/* viewing - what the viewer keeps of the one scene that it shows; its files share it
 *
 * Memory: the image if it is mapped, the arena, then pixels, each behind the one before
 * (board/web/web.h).
 *
 * SPDX-License-Identifier: MIT */
#ifndef WEB_VIEWING_H
#define WEB_VIEWING_H

#include "engine/planelet.h"
#include "host_tools/app/coarse.h"
#include "host_tools/app/pose.h"
#include "host_tools/base/fail.h"
#include "host_tools/picture/picture.h"

typedef struct viewing {
    fail why;
    size_t need_bytes;
    plt_source source;
    int where;
    uint32_t before_arena, before_pixels; /* marks of the room */
    void *arena;
    uint32_t arena_bytes;
    plt_options options;
    plt_engine *engine; /* NULL: there is no scene, or it is not open yet */
    plt_engine *opening;
    plt_frame frame;
    unsigned width, height;       /* of the frame at rest */
    uint8_t samples;              /* likewise */
    int has_camera, has_lighting; /* first ones that were given, or are known already */
    plt_camera first;
    plt_lighting lighting;
    pose pose;
    coarse coarse;
    int is_rendering;
    unsigned level; /* of the frame that is rendered */
    picture coming, complete;
    uint8_t *rgba;
    int is_new;
    uint64_t hash;
    double busy_ms, longest_ms; /* of the frame */
    uint32_t steps, tiles;
} viewing;

extern viewing viewed;

/* Keeps a sentence about a fault that opening or rendering ended with. Returns `status`. */
int viewing_fault(int status, const plt_fault *fault);

/* The usual camera and lights, where the page gave no others; of an open scene with a size. */
void viewing_aim(void);

#endif
