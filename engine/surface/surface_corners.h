/* surface_corners - what the corners of a triangle have, and a hit of it between them
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SURFACE_SURFACE_CORNERS_H
#define PLT_SURFACE_SURFACE_CORNERS_H

#include "engine/surface/surface_data.h"
#include "engine/tree/record.h"

#if PLT_WITH_SURFACE

/* In the order of the packed mesh, as u and v are. */
typedef struct plt_surface_corners {
    float normal[3][3]; /* if has_normals; of length 1 */
    float colour[3][3]; /* if has_colours; 0 .. 1 */
    float flat[3];      /* the triangle's own, of length 1; 0: it has no area */
    uint8_t has_normals, has_colours;
#if PLT_WITH_TEXCOORDS
    uint8_t has_texcoords;
    float texcoord[3][2], texcoord_scale; /* if has_texcoords; the scale as a point has it */
#endif
} plt_surface_corners;

/* The key of a corner by where it is: -0 is 0. */
static inline void plt_surface_key(const float position[3], uint32_t key[3]) {
    for (int a = 0; a < 3; a++) {
        const uint32_t bits = plt_bits_of(position[a]);
        key[a] = bits == 0x80000000u ? 0 : bits;
    }
}

/* ... and by the triangle that it is of. */
static inline void plt_surface_corner_key(uint32_t id, uint32_t corner, uint32_t key[3]) {
    key[0] = id;
    key[1] = corner;
    key[2] = 0;
}

void plt_surface_corners_set(plt_surface_corners *c, const plt_surface_data *data,
                             const plt_record *record);

/* At (1 - u - v) * p0 + u * p1 + v * p2. */
void plt_surface_mix(const plt_surface_corners *c, float u, float v, plt_surface_point *point);

#endif
#endif
