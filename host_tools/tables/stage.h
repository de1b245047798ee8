/* stage - a scene, the rays that are traced in it, and a picture of it
 *
 * Rays are those of a camera that sees all of the scene, and of others around it: representative
 * views, as the thesis's averages are over. They stand in packets of 16x16, 8x8 and 4x4 (Z order).
 *
 * SPDX-License-Identifier: MIT */
#ifndef STAGE_H
#define STAGE_H
#include <stdint.h>

#include "engine/planelet.h"
#include "host_tools/base/fail.h"
#include "host_tools/mesh/mesh.h"
#include "host_tools/picture/picture.h"

typedef struct stage_options {
    unsigned side;  /* of the picture that rays are of, a multiple of 16 */
    unsigned views; /* around the scene */
} stage_options;

enum { STAGE_PICTURE_SIDE = 256 };

typedef struct stage {
    const char *name; /* for errors */
    mesh m;           /* owned */
    uint64_t hash;    /* of the mesh */
    plt_ray *rays;    /* owned; NULL: not made */
    plt_hit *hits;    /* room for one of each */
    uint32_t count;
    picture picture; /* of the first view; 0: not made */
} stage;

/* Takes the mesh over. */
void stage_set(stage *s, const char *name, mesh *m);
void stage_free(stage *s);

/* Makes the rays, and the picture, if they are not there. */
int stage_look(stage *s, const stage_options *o, fail *f);

/* The hash of a mesh's triangles and vertices. */
uint64_t stage_hash(const mesh *m);

#endif
