/* corners - the corners of records, when triangles move
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_CORNERS_H
#define PLT_MOTION_CORNERS_H

#include "engine/tree/record.h"

/* The first of `count` triangles with a corner that is not a number or beyond +-PLT_COORD_MAX on
 * an axis; `count`: there is none. Nine floats each: x, y, z of three corners. */
uint32_t plt_corners_refused(const float (*corners)[9], uint32_t count);

/* Puts the corners of triangle `id` into each of `count` records, in canonical order. What lists
 * say of themselves stays. */
void plt_corners_put(plt_record *records, uint32_t count, const float (*corners)[9]);

#endif
