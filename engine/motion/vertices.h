/* vertices - records of triangles whose vertices are shared
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_VERTICES_H
#define PLT_MOTION_VERTICES_H

#include "engine/tree/vertices.h"

/* Puts the corners of triangle `id` into each of `count` records, in canonical order. What lists
 * say of themselves stays. */
void plt_vertices_put(plt_record *records, uint32_t count, const plt_vertices *v);

#endif
