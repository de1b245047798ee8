/* frustum - see frustum.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/frustum.h"

#define MARGIN 6.103515625e-5f /* 2^-14 */

int plt_frustum_set(plt_frustum *f, const plt_packet *p, plt_mask groups) {
    static const float to_x[2][4] = {{1, -1, 0, 0}, {-1, 1, 0, 0}};
    static const float to_y[2][4] = {{0, 0, 1, -1}, {0, 0, -1, 1}};
    if (p->slabs.coherence != PLT_ONE_ORIGIN || p->axis == PLT_AXES_DIFFER || groups == 0) {
        return 0;
    }
    const f4 most = f4_all(2.0f); /* no slope is above 1 */
    f4 x = most, minus_x = most, y = most, minus_y = most;
    for (plt_mask m = groups; m != 0; m &= m - 1) {
        const plt_group_rays *g = &p->rays[plt_mask_first(m)];
        const f4 slope_x = f4_load(g->slope[0]), slope_y = f4_load(g->slope[1]);
        x = f4_min(x, slope_x);
        minus_x = f4_min(minus_x, f4_neg(slope_x));
        y = f4_min(y, slope_y);
        minus_y = f4_min(minus_y, f4_neg(slope_y));
    }
    f4_transpose(&x, &minus_x, &y, &minus_y);
    const f4 least = f4_min(f4_min(x, minus_x), f4_min(y, minus_y));
    const unsigned back = p->slabs.negative[p->axis], axis = p->axis;
    f4 *const normal = f->normal;
    normal[axis] = back ? least : f4_neg(least);
    normal[axis == 2 ? 0 : axis + 1] = f4_load(to_x[back]);
    normal[axis == 0 ? 2 : axis - 1] = f4_load(to_y[back]);
    for (int a = 0; a < 3; a++) {
        f->org[a] = f4_all(p->org[a]);
    }
    f->margin = f4_all(-MARGIN * p->reach);
    f->axis = axis;
    f->sign = back ? -1.0f : 1.0f;
    f->org_along = p->org[axis];
    return 1;
}
