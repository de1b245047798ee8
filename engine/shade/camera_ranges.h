/* camera_ranges - what the directions through a square of pixels have in common
 *
 * Rounding is monotone, so each component is between those of the square's corners, as computed.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_CAMERA_RANGES_H
#define PLT_SHADE_CAMERA_RANGES_H

#include "engine/shade/camera.h"

#if PLT_WITH_HULLS

typedef struct plt_view_ranges {
    float least[3], most[3]; /* of each component */
    f4 sum[3];               /* lane 0: of two directions that lie across from one another */
} plt_view_ranges;

/* The square lies in the frame. */
void plt_view_ranges_set(plt_view_ranges *r, const plt_view *view, const plt_pixels *pixels);

/* The axis that is the largest of every direction, the first of equals; or PLT_AXES_DIFFER, also
 * where a direction may be none. */
uint8_t plt_view_axis(const plt_view_ranges *r);

/* Whether no ray may meet the box. */
int plt_view_misses(const plt_view_ranges *r, const plt_view *view, const plt_box *box);

#endif

#endif
