/* ply_corners - which properties of a PLY file are normals, colours and texture coordinates
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLY_CORNERS_H
#define PLY_CORNERS_H
#include "host_tools/mesh/ply_header.h"

/* Three properties each, of the first names that are all there; property[0] NULL: none are. */
typedef struct ply_triple {
    const ply_property *property[3];
} ply_triple;

ply_triple ply_find_normal(const ply_element *e);
/* Of one type, which is that of uchar, ushort, float or double. */
ply_triple ply_find_colour(const ply_element *e);
/* The greatest colour of that type. */
double ply_colour_most(ply_type type);

/* Two, of float or double. */
ply_triple ply_find_texcoord(const ply_element *e);
/* The list of a face's corners, u and v of each, of float or double; NULL: there is none. */
const ply_property *ply_find_texcoord_list(const ply_element *e);

/* Which of the three `p` is; 3: none. */
unsigned ply_triple_part(const ply_triple *t, const ply_property *p);

#endif
