/* slices - cells of a slice that rays may reach, and their references
 *
 * A *slice* is a layer of cells across an axis z; x and y are the axes after it (x, y, z, x).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_GRID_SLICES_H
#define PLT_GRID_SLICES_H

#include "engine/grid/grid.h"

/* Of a cell, more than what its planes are off by: 3 u times PLT_GRID_CELLS_MOST, and once more
 * where its own level's box is. */
#define PLT_GRID_CELL_ERROR 2.0e-3f

/* The first slice, along z or, `sign` -1, against it, that a ray is in which begins `at` beyond
 * the level's least corner, less `margin`. 0: it begins beyond the last. */
static inline int plt_grid_slice_at(const plt_grid_level *l, int z, float sign, float at,
                                    float margin, int32_t *slice) {
    const float cells = at * l->scale[z], more = margin * l->scale[z] + PLT_GRID_CELL_ERROR;
    const float first = cells - sign * more, last = l->last[z];
    *slice = first <= 0.0f ? 0 : first >= last ? (int32_t)last : (int32_t)first;
    return sign > 0.0f ? first < last + 1.0f : first > 0.0f;
}

/* Cells of a slice, from the first to the last along x and y. */
typedef struct plt_grid_patch {
    int32_t from[2], to[2];
} plt_grid_patch;

/* Along axis `i` of both, between bounds in cells. 0: there are none. */
static inline int plt_grid_between(plt_grid_patch *c, int i, float from, float to, float last) {
    c->from[i] = from > 0.0f ? (int32_t)from : 0;
    c->to[i] = to < last ? (int32_t)to : (int32_t)last;
    return from < last + 1.0f && to >= 0.0f;
}

/* Without what is empty. 0: all of it is. */
static inline int plt_grid_cut(plt_grid_patch *c, const plt_grid_rect *occupied) {
    for (int i = 0; i < 2; i++) {
        c->from[i] = c->from[i] > occupied->lo[i] ? c->from[i] : occupied->lo[i];
        c->to[i] = c->to[i] < occupied->hi[i] ? c->to[i] : occupied->hi[i];
    }
    return c->from[0] <= c->to[0] && c->from[1] <= c->to[1];
}

/* References of such cells, run by run: of a row along the level's first axis, where cells are
 * side by side, or of one cell. */
typedef struct plt_grid_runs {
    const uint32_t *start;
    uint32_t cells;         /* of a run */
    uint32_t cell, step;    /* the next run's first, and what the one after it adds */
    uint32_t runs, left;    /* of a row, and of this one */
    uint32_t row, row_step; /* the next row's first cell */
    uint32_t rows;          /* that are left */
} plt_grid_runs;

static inline plt_grid_runs plt_grid_runs_of(const plt_grid_level *l, int x, int y, int z,
                                             int32_t slice, const plt_grid_patch *c) {
    const uint32_t first = (uint32_t)slice * l->stride[z] + (uint32_t)c->from[0] * l->stride[x] +
                           (uint32_t)c->from[1] * l->stride[y];
    const int inner = y == 0, outer = !inner; /* rows lie along x, or along y if that is axis 0 */
    const uint32_t cells = (uint32_t)(c->to[inner] - c->from[inner] + 1);
    const uint32_t across = l->stride[inner ? y : x];
    const int is_row = across == 1;
    const plt_grid_runs r = {
        l->start, is_row ? cells : 1,       first,
        across,   is_row ? 1 : cells,       0,
        first,    l->stride[inner ? x : y], (uint32_t)(c->to[outer] - c->from[outer] + 1)};
    return r;
}

/* Sets the next run of references. 0: there is none. */
static inline int plt_grid_next_run(plt_grid_runs *r, uint32_t *first, uint32_t *end) {
    if (r->left == 0) {
        if (r->rows == 0) {
            return 0;
        }
        r->rows--;
        r->left = r->runs;
        r->cell = r->row;
        r->row += r->row_step;
    }
    r->left--;
    *first = r->start[r->cell];
    *end = r->start[r->cell + r->cells];
    r->cell += r->step;
    return 1;
}

#endif
