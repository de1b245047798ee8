/* surface_rig - a mesh with normals and colours, packed and opened
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_SURFACE_RIG_H
#define REFERENCE_SURFACE_RIG_H

#include <math.h>
#include <stdlib.h>

#include "host_tools/mesh/smooth.h"
#include "host_tools/pack/surface.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

/* Every corner's colour by where it is, in `steps` steps per axis of the cube -1 .. 1. */
static inline void surface_rig_colour(const mesh *m, mesh_corners *c, unsigned steps) {
    CHECK(corners_want_colours(c, m->triangles) == 0, "no memory");
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        uint32_t part[3];
        for (size_t a = 0; a < 3; a++) {
            const float at = 0.5f + 0.5f * m->vertex[3 * (size_t)m->triangle[i] + a];
            part[a] = (uint32_t)(at * (float)steps) * 255 / steps & 0xFFu;
        }
        c->colour[i] = corner_colour(part[0], part[1], part[2]);
    }
}

/* Colours by triangle: no position has one. */
static inline void surface_rig_paint(const mesh *m, mesh_corners *c) {
    CHECK(corners_want_colours(c, m->triangles) == 0, "no memory");
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        c->colour[i] = corner_colour(i / 3 % 80, 100, 50 + i % 3);
    }
}

/* Coordinates by where corners are: u along x, `repeats` times over, v against y, half as often. */
static inline void surface_rig_unwrap(const mesh *m, mesh_corners *c, float repeats) {
    CHECK(corners_want_texcoords(c, m->triangles) == 0, "no memory");
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        const float *p = m->vertex + 3 * (size_t)m->triangle[i];
        c->texcoord[0][i] = corner_texcoord((double)(repeats * (0.5f + 0.5f * p[0])));
        c->texcoord[1][i] = corner_texcoord((double)(-0.5f * repeats * p[1]));
    }
}

/* Coordinates by triangle: no position has any. Every ninth triangle's last corner has none. */
static inline void surface_rig_tile(const mesh *m, mesh_corners *c) {
    static const double corner[3][2] = {{0, 0}, {1, 0}, {0.25, 0.75}};
    CHECK(corners_want_texcoords(c, m->triangles) == 0, "no memory");
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        const int is_none = i % 27 == 26;
        for (int a = 0; a < 2; a++) {
            const double at = corner[i % 3][a] + (double)(i / 3 % 7);
            c->texcoord[a][i] = is_none ? CORNER_NO_TEXCOORD : corner_texcoord(at);
        }
    }
}

static inline packed surface_rig_image(const mesh *m, const mesh_corners *c,
                                       const pack_options *options) {
    packed image = {.size = 0};
    surface_stats stats;
    fail f = {""};
    CHECK(pack_mesh(&image, m, options, "test", &f) == 0 &&
              surface_add(&image, c, "test", &stats, &f) == 0,
          "%s", f.text);
    return image;
}

/* The same of compact blocks: float records, or a lattice of 16 bits. */
static inline packed surface_rig_compact(const mesh *m, const mesh_corners *c, uint8_t floats) {
    const compact_options options = {
        .lattice_bits = 16, .numbers = 1, .floats = floats, .leaf_triangles = 2, .meshes = 1};
    packed image = {.size = 0};
    surface_stats stats;
    lattice_loss loss;
    fail f = {""};
    CHECK(pack_compact(&image, m, &options, "test", &loss, &f) == 0 &&
              surface_add(&image, c, "test", &stats, &f) == 0,
          "%s", f.text);
    return image;
}

/* Opens the image in exactly its need; r->image is it from then on. */
static inline int surface_rig_open(rig *r, packed image, const plt_source *source,
                                   const plt_options *options) {
    *r = (rig){.image = image};
    r->arena_bytes = plt_arena_need(&image.info, source->mapped != NULL, options);
    r->arena = aligned_alloc(PLT_ALIGN, (r->arena_bytes + PLT_ALIGN) / PLT_ALIGN * PLT_ALIGN);
    return plt_open(&r->engine, r->arena, r->arena_bytes, source, options, &r->fault);
}

#endif
