/* instances - packed meshes put together as the bodies of one image
 *
 * Bodies and instances first, then the matrices of one frame after the other; SPEC.md, section
 * 4.17.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_INSTANCES_H
#define PACK_INSTANCES_H
#include "engine/instances/placed.h"
#include "host_tools/pack/pack.h"

typedef struct instance_set {
    const packed *body; /* thesis nodes built by the host, all of one treelet size */
    uint32_t bodies;
    const uint32_t *body_of; /* by instance */
    uint32_t instances;      /* 1 .. PLT_INSTANCES_MOST */
    uint32_t frames;         /* 1 and more */
    uint32_t frame_rate;     /* per second, 1 .. PLT_FRAME_RATE_MOST */
} instance_set;

/* Whether the engine takes a matrix for a body, and where that puts it. */
int instances_place(const packed *body, const float matrix[PLT_MATRIX_FLOATS], plt_box *box);

/* The image with all but the matrices; `name` is for errors. */
int instances_begin(packed *image, const instance_set *all, const char *name, fail *f);

/* Those of a frame, of all instances; each is one that the engine takes. */
void instances_frame(packed *image, const instance_set *all, uint32_t frame,
                     const float (*matrix)[PLT_MATRIX_FLOATS]);

/* Once all frames are there: the checksums. */
void instances_finish(packed *image);

#endif
