/* beam_slopes - along which axis of a grid a beam goes, and how far aside
 *
 * Slopes are quotients of functions that are linear in the pixel, so those of the square's corners
 * bound all of them but for rounding.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/beam.h"
#include "engine/trace/grid_state.h"
#include "engine/trace/ray_bounds.h"
#include "engine/trace/triangle_common.h"

#if PLT_WITH_GRID

#define MARGIN 3.0f            /* times how far origins are moved (DESIGN.md, section 7.9) */
#define DEPTH_LONG 1.00000095f /* 1 + 2^-20 */
#define STEEP 0.0625f          /* of the greatest component along z, at least, is the least */
#define ROUNDED 0.0625f        /* of margins.plane, 160 u M: 10 u M */

static inline float larger(float a, float b) {
    return a > b ? a : b;
}

static inline float smaller(float a, float b) {
    return a < b ? a : b;
}

static void set_corners(const plt_beam *b, float dir[4][3]) {
    const plt_view *v = b->view;
    const uint32_t x_last = b->square.x + b->columns - 1, y_last = b->square.y + b->rows - 1;
    for (uint32_t i = 0; i < 4; i++) {
        const float x =
            i & 1u ? plt_view_most(v, (float)x_last) : plt_view_least(v, (float)b->square.x);
        const float y =
            i & 2u ? plt_view_most(v, (float)y_last) : plt_view_least(v, (float)b->square.y);
        plt_view_point(v, x, y, dir[i]);
    }
}

/* The largest component of all of them together. */
static void set_axes(plt_grid_beam *g, const float dir[4][3]) {
    float most = -1.0f;
    for (int a = 0; a < 3; a++) {
        const float sum = dir[0][a] + dir[1][a] + dir[2][a] + dir[3][a];
        if (__builtin_fabsf(sum) > most) {
            most = __builtin_fabsf(sum);
            g->z = a;
            g->sign = sum < 0.0f ? -1.0f : 1.0f;
        }
    }
    g->x = plt_axis_after[g->z];
    g->y = plt_axis_after[g->x];
}

/* The least, and minus the greatest. */
static void set_slope(plt_grid_beam *g, int i, int axis, const float dir[4][3], float rounded) {
    float least = 0.0f, most = 0.0f;
    for (int k = 0; k < 4; k++) {
        const float slope = dir[k][axis] / __builtin_fabsf(dir[k][g->z]);
        least = k == 0 ? slope : smaller(least, slope);
        most = k == 0 ? slope : larger(most, slope);
    }
    g->slope[i] = least - rounded * (1.0f + __builtin_fabsf(least));
    g->slope[i + 2] = -(most + rounded * (1.0f + __builtin_fabsf(most)));
}

void plt_beam_grid_slopes(plt_grid_beam *g, const plt_beam *b) {
    float dir[4][3], least, most, furthest = 0.0f;
    set_corners(b, dir);
    set_axes(g, (const float(*)[3])dir);
    least = most = g->sign * dir[0][g->z];
    for (int k = 1; k < 4; k++) {
        least = smaller(least, g->sign * dir[k][g->z]);
        most = larger(most, g->sign * dir[k][g->z]);
    }
    for (int a = 0; a < 3; a++) {
        furthest = larger(furthest, __builtin_fabsf(b->origin.org[a]));
    }
    g->margin = MARGIN * larger(b->origin.reach * PLT_BOX_ERROR, furthest * PLT_ORIGIN_ERROR);
    g->quickest = most * DEPTH_LONG;
    if (!(least >= STEEP * most && least > 2.0f * b->margins.plane)) {
        g->sign = 0.0f;
        return;
    }
    set_slope(g, 0, g->x, (const float(*)[3])dir, ROUNDED * b->margins.plane / least);
    set_slope(g, 1, g->y, (const float(*)[3])dir, ROUNDED * b->margins.plane / least);
}

#endif
