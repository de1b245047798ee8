/* triangle_corners - a triangle as any format gives it
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_TRIANGLE_CORNERS_H
#define PLT_TRACE_TRIANGLE_CORNERS_H

#include <stdint.h>

#include "engine/tree/primitive_id.h"

/* Corners in canonical order (record.h). */
typedef struct plt_triangle {
    float corner[3][3];
    float longest;                /* at least the longest side of its box */
    uint32_t word;                /* of primitive_id.h if `ids` is NULL, else its index there */
    const plt_primitive_ids *ids; /* or NULL */
} plt_triangle;

#endif
