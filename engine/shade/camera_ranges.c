/* camera_ranges - see camera_ranges.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/camera_ranges.h"

#include "engine/trace/ray_bounds.h"
#include "engine/trace/triangle_common.h"

#if PLT_WITH_HULLS

static inline float larger(float a, float b) {
    return a > b ? a : b;
}

void plt_view_ranges_set(plt_view_ranges *r, const plt_view *v, const plt_pixels *pixels) {
    static const float right_of[4] = {0, 1, 0, 1}, below_of[4] = {0, 0, 1, 1};
    const f4 last = f4_all(plt_view_most(v, plt_view_most(v, (float)(pixels->side - 1))));
    const f4 px =
        f4_add(f4_all(plt_view_least(v, (float)pixels->x)), f4_mul(f4_load(right_of), last));
    const f4 py =
        f4_add(f4_all(plt_view_least(v, (float)pixels->y)), f4_mul(f4_load(below_of), last));
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 corner = plt_view_directions(v, a, px, py);
        r->least[a] = f4_min_lane(corner);
        r->most[a] = -f4_min_lane(f4_neg(corner));
        r->sum[a] = f4_add(corner, f4_rotate(f4_rotate(f4_rotate(corner))));
    }
}

/* The greatest size of a component. */
static inline float largest(const plt_view_ranges *r, int a) {
    return larger(r->most[a], -r->least[a]);
}

uint8_t plt_view_axis(const plt_view_ranges *r) {
    for (uint8_t z = 0; z < 3; z++) {
        const int x = plt_axis_after[z], y = plt_axis_after[x];
        const float least = larger(r->least[z], -r->most[z]); /* negative: there are both signs */
        const int beyond_x = x < z ? least > largest(r, x) : least >= largest(r, x);
        const int beyond_y = y < z ? least > largest(r, y) : least >= largest(r, y);
        if (beyond_x && beyond_y && least >= PLT_DIR_LEAST && largest(r, z) <= PLT_DIR_MOST) {
            return z;
        }
    }
    return PLT_AXES_DIFFER;
}

/* As shade/beam.c has it of a beam (DESIGN.md, section 7.7): rays enter by planes at the earliest
 * at `enter`, and leave at the latest at `leave`. On an axis on which they go both ways, both
 * planes may be entered by, and left no one knows where. */
int plt_view_misses(const plt_view_ranges *r, const plt_view *v, const plt_box *box) {
    float enter = 0.0f, leave = PLT_VIEW_FAR, reach = PLT_REACH_LEAST;
    for (int a = 0; a < 3; a++) {
        reach = larger(reach, __builtin_fabsf(box->lo[a] - v->eye[a]));
        reach = larger(reach, __builtin_fabsf(box->hi[a] - v->eye[a]));
    }
    reach *= PLT_REACH_ROUNDING;
    const float size = larger(larger(largest(r, 0), largest(r, 1)), largest(r, 2));
    const float tiny = size * PLT_DIR_LEAST;
    if (size < PLT_DIR_LEAST) {
        return 0;
    }
    for (int a = 0; a < 3; a++) {
        const float moved =
            larger(reach * PLT_BOX_ERROR, __builtin_fabsf(v->eye[a]) * PLT_ORIGIN_ERROR);
        const float lo = box->lo[a] - (v->eye[a] + moved), hi = box->hi[a] - (v->eye[a] - moved);
        const float least = r->least[a], most = r->most[a];
        if (most <= -tiny) {
            leave = -larger(-leave, -(lo * (1.0f / most)));
        } else {
            enter = larger(enter, lo * (1.0f / larger(most, tiny)));
        }
        if (least >= tiny) {
            leave = -larger(-leave, -(hi * (1.0f / least)));
        } else {
            enter = larger(enter, hi * (1.0f / -larger(-least, tiny)));
        }
    }
    return enter > leave;
}

#endif
