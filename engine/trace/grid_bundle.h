/* grid_bundle - groups of a packet that go through a grid together
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_GRID_BUNDLE_H
#define PLT_TRACE_GRID_BUNDLE_H

#include "engine/trace/grid_state.h"

/* Sets up the next bundle of the turn that may reach a cell. 0: there is none. `records`: of the
 * mailbox. */
int plt_grid_next_bundle(plt_grid_state *s, const plt_packet *p, const plt_grid_level *top,
                         uint32_t records);

/* Bounds of the bundle's groups. */
void plt_grid_set_bounds(plt_grid_state *s);

/* A bundle's bounds in cells of a level. */
typedef struct plt_grid_view {
    f4 base, rate, margin;
    float plane, size; /* depths: of the level's least corner, and what a cell adds to it */
    float slack;       /* of depths */
} plt_grid_view;

static inline plt_grid_view plt_grid_view_of(const plt_grid_state *s, const plt_packet *p,
                                             const plt_grid_level *l) {
    const plt_grid_turn *t = &s->turn;
    const float x = l->lo[t->x] - p->scene->lo[t->x], y = l->lo[t->y] - p->scene->lo[t->y];
    const float per_x = l->scale[t->x], per_y = l->scale[t->y];
    const f4 per = plt_grid_four(per_x, per_y, per_x, per_y);
    const plt_grid_view v = {
        f4_mul(f4_sub(f4_load(s->bundle.base), plt_grid_four(x, y, -x, -y)), per),
        f4_mul(f4_load(s->bundle.rate), per),
        f4_add(f4_mul(per, f4_all(t->margin)), f4_all(PLT_GRID_CELL_ERROR)),
        t->sign * (l->lo[t->z] - t->plane),
        t->sign * l->size[t->z],
        t->margin + PLT_GRID_CELL_ERROR * l->size[t->z]};
    return v;
}

/* The first slice, going the turn's way, that a ray is in which begins at depth `from`. 0: it
 * begins beyond the last. */
static inline int plt_grid_first_slice(const plt_grid_turn *t, const plt_grid_level *l, float from,
                                       int32_t *slice) {
    return plt_grid_slice_at(l, t->z, t->sign, (t->plane - l->lo[t->z]) + t->sign * from, t->margin,
                             slice);
}

#endif
