/* beam_grid - the beam on its way through a grid, slice after slice
 *
 * What its rays may reach of a slice is a rectangle of cells, by the slopes of its corners. Each
 * triangle that they refer to is looked at once, for all pixels. So slices need no order; as they
 * come front to back, the rest is left when no pixel has a hit behind the next one.
 *
 * Invariant: what is left out no ray of the beam would have hit (DESIGN.md, section 7.9).
 *
 * Source: Wald, Ize, Kensler, Knoll, Parker, "Ray tracing animated scenes using coherent grid
 * traversal", 2006.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/lanes/unroll.h"
#include "engine/shade/beam.h"
#include "engine/trace/grid_state.h"

#if PLT_WITH_GRID

/* Of a level, along the beam: depths, from the eye on. */
typedef struct slices {
    float plane, size; /* of its least corner, and what a slice adds to that */
    float slack;
} slices;

static inline slices slices_of(const plt_beam *b, const plt_grid_beam *g, const plt_grid_level *l) {
    const slices s = {g->sign * (l->lo[g->z] - b->origin.org[g->z]), g->sign * l->size[g->z],
                      g->margin + PLT_GRID_CELL_ERROR * l->size[g->z]};
    return s;
}

/* Depths of a slice that rays may be in. */
static inline void depths_of(const plt_grid_beam *g, const slices *s, int32_t slice, float *near,
                             float *far) {
    const float lower = s->plane + (float)slice * s->size;
    const float upper = s->plane + (float)(slice + 1) * s->size;
    *near = (g->sign > 0.0f ? lower : upper) - s->slack;
    *far = (g->sign > 0.0f ? upper : lower) + s->slack;
}

/* No pixel has a hit that deep, or deeper. */
static inline int ends_before(const plt_beam *b, const plt_grid_beam *g, float near) {
    return g->sign != 0.0f && near > b->far * g->quickest;
}

/* Along x or y, in cells. */
static inline int reach_along(const plt_beam *b, const plt_grid_beam *g, const plt_grid_level *l,
                              int i, int axis, float near, float far, plt_grid_patch *c) {
    const float org = b->origin.org[axis] - l->lo[axis], scale = l->scale[axis];
    const float least = g->slope[i], minus_most = g->slope[i + 2];
    const float margin = g->margin * scale + PLT_GRID_CELL_ERROR;
    const float from = org + least * (least > 0.0f ? near : far);
    const float minus_to = minus_most * (minus_most > 0.0f ? near : far) - org;
    return plt_grid_between(c, i, from * scale - margin, margin - minus_to * scale, l->last[axis]);
}

/* What the beam may reach of a slice. 0: nothing. */
static int reach(const plt_beam *b, const plt_grid_beam *g, const plt_grid_level *l, float near,
                 float far, plt_grid_patch *c) {
    if (g->sign == 0.0f) {
        return plt_grid_between(c, 0, 0.0f, l->last[g->x], l->last[g->x]) &&
               plt_grid_between(c, 1, 0.0f, l->last[g->y], l->last[g->y]);
    }
    near = near > 0.0f ? near : 0.0f;
    return far >= 0.0f && reach_along(b, g, l, 0, g->x, near, far, c) &&
           reach_along(b, g, l, 1, g->y, near, far, c);
}

/* What is counted, and where triangles that were met are marked. */
typedef struct visit {
    plt_beam *b;
    const plt_grid_beam *g;
    plt_beam_marks marks;
    uint32_t cells;
} visit;

static inline void update_far(plt_beam *b) {
    if (b->is_stored && b->open == 0) {
        plt_beam_update_far(b);
    }
}

/* A crowded cell: the slices of its level. */
static void visit_crowded(visit *v, const plt_grid_level *l) {
    const plt_grid_beam *g = v->g;
    const slices s = slices_of(v->b, g, l);
    const int32_t count = (int32_t)l->cells[g->z];
    plt_grid_patch patch;
    for (int32_t i = 0; i < count; i++) {
        const int32_t slice = g->step > 0 ? i : count - 1 - i;
        uint32_t first, end;
        float near, far;
        depths_of(g, &s, slice, &near, &far);
        if (ends_before(v->b, g, near)) {
            return;
        }
        if (!reach(v->b, g, l, near, far, &patch)) {
            continue;
        }
        plt_grid_runs runs = plt_grid_runs_of(l, g->x, g->y, g->z, slice, &patch);
        while (plt_grid_next_run(&runs, &first, &end)) {
            v->cells += runs.cells;
            plt_beam_references(v->b, &l->reference[first], end - first, &v->marks);
        }
        update_far(v->b);
    }
}

/* References of the top level, maybe of several cells. */
static void visit_run(visit *v, const plt_grid *grid, uint32_t first, uint32_t end) {
    const uint32_t *reference = grid->top.reference;
    while (first < end) {
        first += plt_beam_references(v->b, &reference[first], end - first, &v->marks);
        if (first < end) {
            visit_crowded(v, &grid->crowded[reference[first] & ~PLT_GRID_CROWDED]);
            first += reference[first + 1];
        }
    }
}

static void visit_slice(visit *v, const plt_grid *grid, int32_t slice, float near, float far) {
    const plt_grid_beam *g = v->g;
    plt_grid_patch patch;
    uint32_t first, end;
    if (!reach(v->b, g, &grid->top, near, far, &patch) ||
        !plt_grid_cut(&patch, &grid->rect[g->z][slice])) {
        return;
    }
    plt_grid_runs runs = plt_grid_runs_of(&grid->top, g->x, g->y, g->z, slice, &patch);
    while (plt_grid_next_run(&runs, &first, &end)) {
        v->cells += runs.cells;
        visit_run(v, grid, first, end);
    }
    update_far(v->b);
}

void plt_beam_grid_init(plt_traversal *t) {
    plt_grid_state_clear(plt_grid_state_of(t), t->scene->gridded.count);
}

void plt_beam_grid_push(const plt_beam *b, plt_traversal *t) {
    plt_grid_state *state = plt_grid_state_of(t);
    const plt_grid_level *top = &t->scene->gridded.grid->top;
    plt_grid_beam *g = &state->beam;
    if (t->scene->gridded.count == 0) {
        return;
    }
    plt_grid_next_stamp(state, t->scene->gridded.count);
    plt_beam_grid_slopes(g, b);
    const int32_t cells = (int32_t)top->cells[g->z];
    g->step = g->sign < 0.0f ? -1 : 1;
    g->slice = 0;
    if (g->sign == 0.0f ||
        plt_grid_slice_at(top, g->z, g->sign, b->origin.org[g->z] - top->lo[g->z], g->margin,
                          &g->slice)) {
        g->left = g->step > 0 ? cells - g->slice : g->slice + 1;
        t->waiting = 1;
    }
}

plt_beam_counts plt_beam_grid_trace(plt_beam *b, plt_traversal *t, uint32_t visits) {
    const plt_grid *grid = t->scene->gridded.grid;
    plt_grid_state *state = plt_grid_state_of(t);
    plt_grid_beam *g = &state->beam;
    visit v = {b, g, {plt_grid_mailbox(state), state->stamp, 0}, 0};
    const slices s = slices_of(b, g, &grid->top);
    for (uint32_t seen = 0; t->waiting > 0 && seen + v.cells < visits; seen++) {
        float near, far;
        depths_of(g, &s, g->slice, &near, &far);
        if (ends_before(b, g, near)) {
            t->waiting = 0;
            break;
        }
        visit_slice(&v, grid, g->slice, near, far);
        g->slice += g->step;
        t->waiting = --g->left > 0;
    }
    const plt_beam_counts c = {v.cells, v.marks.met};
    return c;
}

#endif
