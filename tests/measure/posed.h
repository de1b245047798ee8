/* posed - all frames of an animation, and those that one tree for all of them is made for
 *
 * SPDX-License-Identifier: MIT */
#ifndef MEASURE_POSED_H
#define MEASURE_POSED_H

#include <stdlib.h>

#include "host_tools/pack/poses.h"
#include "tests/measure/animation.h"

typedef struct posed {
    mesh *frame;
    unsigned frames;
    poses poses;
    float lo[3], hi[3]; /* of the middle frame: the cameras stand */
} posed;

/* -1: a frame cannot be read, which is a failure. posed_free all the same. */
static inline int posed_read(posed *f, const animation *a) {
    memset(f, 0, sizeof *f);
    f->frames = a->frames;
    f->frame = calloc(a->frames, sizeof *f->frame);
    for (unsigned i = 0; i < a->frames; i++) {
        if (animation_frame(&f->frame[i], a, i) != 0) {
            return -1;
        }
    }
    const uint32_t wanted = poses_wanted(a->frames, f->frame[0].triangles);
    poses_begin(&f->poses, &f->frame[0]);
    for (uint32_t i = 0; i < wanted; i++) {
        CHECK(poses_add(&f->poses, &f->frame[poses_frame(i, wanted, a->frames)]) == 0,
              "out of memory");
    }
    poses_weigh(&f->poses);
    animation_box(&f->frame[a->frames / 2], f->lo, f->hi);
    return 0;
}

static inline void posed_free(posed *f) {
    for (unsigned i = 0; i < f->frames; i++) {
        mesh_free(&f->frame[i]);
    }
    poses_free(&f->poses);
    free(f->frame);
}

#endif
