/* lit_rig - a small scene with materials, packed and opened in an arena of exactly its need
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_LIT_RIG_H
#define REFERENCE_LIT_RIG_H

#include "host_tools/mesh/materials.h"
#include "tests/reference/rig.h"

/* Materials of the scene. */
enum { LIT_FLOOR, LIT_GLASS, LIT_MIRROR, LIT_PAINT, LIT_LAMP, LIT_MATERIALS };

typedef struct lit_scene {
    mesh m;
    mesh_materials materials;
} lit_scene;

enum lit_image {
    LIT_THESIS,
    LIT_LIST,
    LIT_DEVICE,
    LIT_COMPACT, /* float records: corners are where those of the others are */
    LIT_IMAGES,
    LIT_LATTICE = LIT_IMAGES /* blocks that can be streamed, with corners a little elsewhere */
};

/* A floor of y = 0, and a ball each of the others over it. */
void lit_scene_make(lit_scene *s);
/* Triangles that were added to s->m get that material. */
void lit_scene_is(lit_scene *s, unsigned material);
void lit_scene_free(lit_scene *s);

/* Packs it with its materials: 0, or -1. */
int lit_pack(packed *image, const lit_scene *s, enum lit_image kind);

/* The status of plt_open; r->image is packed. `fetched`: through a source that is not mapped. */
int lit_open(rig *r, const plt_options *options, int fetched);

/* A point, a sun and a disc; a sky. */
plt_lighting lit_lights(uint8_t bounces);

#endif
