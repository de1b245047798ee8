/* beam_planes - where rays of a range of directions enter boxes and leave them
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/beam.h"
#include "engine/trace/ray_bounds.h"

/* `tiny`: as packet_set.c makes components that are less, at most. Rays on both sides of 0 enter
 * a box by either plane, and leave it no one knows where. */
static void set_axis(plt_beam_plane plane[6], const plt_ray_origin *o, int axis,
                     const plt_beam_range *r, float tiny) {
    plt_beam_plane *lo = &plane[axis], *hi = &plane[3 + axis];
    lo->org = o->up[axis];
    hi->org = o->down[axis];
    lo->leaves = r->most <= -tiny;
    hi->leaves = r->least >= tiny;
    lo->factor = lo->leaves ? -1.0f / r->most : 1.0f / (r->most > tiny ? r->most : tiny);
    hi->factor = hi->leaves ? -1.0f / r->least : 1.0f / (r->least < -tiny ? r->least : -tiny);
}

int plt_beam_planes(plt_beam_plane plane[6], const plt_ray_origin *o, const plt_beam_range r[3]) {
    float largest = 0.0f;
    for (int a = 0; a < 3; a++) {
        const float size = r[a].most > -r[a].least ? r[a].most : -r[a].least;
        largest = size > largest ? size : largest;
    }
    for (int a = 0; a < 3; a++) {
        set_axis(plane, o, a, &r[a], largest * PLT_DIR_LEAST);
    }
    return largest >= PLT_DIR_LEAST;
}
