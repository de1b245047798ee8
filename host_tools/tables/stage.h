/* stage - a scene, the rays that are traced in it, and a picture of it
 *
 * Rays are those of a camera that sees all of the scene, and of others around it: representative
 * views, as the thesis's averages are over. They stand in packets of 16x16, 8x8 and 4x4 (Z order),
 * and are made when they are traced, STAGE_RAY_BYTES at a time, however many there are.
 *
 * SPDX-License-Identifier: MIT */
#ifndef STAGE_H
#define STAGE_H
#include <stdint.h>

#include "engine/planelet.h"
#include "host_tools/app/view_rays.h"
#include "host_tools/base/fail.h"
#include "host_tools/baselines/turns.h"
#include "host_tools/mesh/mesh.h"
#include "host_tools/picture/picture.h"

typedef struct stage_options {
    unsigned side;  /* of the picture that rays are of, a multiple of 16 */
    unsigned views; /* around the scene */
} stage_options;

/* Rays and hits that are there at once take so many bytes. */
enum {
    STAGE_PICTURE_SIDE = 256,
    STAGE_RAY_BYTES = TURNS_BATCH * (int)(sizeof(plt_ray) + sizeof(plt_hit))
};

typedef struct stage {
    const char *name; /* for errors */
    mesh m;           /* owned */
    uint64_t hash;    /* of the mesh */
    view_rays look;   /* what the rays are made of; its room is owned, NULL: not made */
    picture picture;  /* of the first view; 0: not made */
} stage;

/* Takes the mesh over. */
void stage_set(stage *s, const char *name, mesh *m);
void stage_free(stage *s);

/* Sets the views, and makes the picture, if they are not there. */
int stage_look(stage *s, const stage_options *o, fail *f);

/* All rays of the views. */
turns_rays stage_rays(stage *s);

/* The hash of a mesh's triangles and vertices. */
uint64_t stage_hash(const mesh *m);

#endif
