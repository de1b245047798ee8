/* grid - cells of one size over a scene's box, and which triangles' boxes reach into each
 *
 * A *reference* is the index of a record. Cells of a level lie along x, then y, then z; those of a
 * row are side by side, and so are their references. A cell that is crowded can have a level of its
 * own: the first of its references is then its number, and the second how many references it has.
 *
 *     plt_grid | start, 4 bytes a cell and 4 | rectangles, 8 bytes a slice | macro cells, a bit
 *     each | references, 4 bytes each | of each crowded cell: its level, start, references
 *
 * Invariant: let p be any point of a triangle's own box, in the scene's box. The triangle is among
 * the references of the cell plt_grid_cell(p), and of its cell there, if that has a level of its
 * own. So it is if p is in the cell by less than a thousandth of a cell's side (DESIGN.md, 6.3).
 *
 * Sources: Fujimoto, Tanaka, Iwata, "ARTS", 1986 (uniform grids); Wald, Ize, Kensler, Knoll,
 * Parker, "Ray tracing animated scenes using coherent grid traversal", 2006.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_GRID_GRID_H
#define PLT_GRID_GRID_H

#include "engine/lanes/lanes.h"
#include "engine/planelet.h"

/* Cells along an axis at most: planes are then off by less than 2e-4 of a cell. */
enum { PLT_GRID_CELLS_MOST = 1024 };

/* A reference that is none: the number of a level in the other bits. */
#define PLT_GRID_CROWDED 0x80000000u

/* Cells over a box; the fourth of each is 0. */
typedef struct plt_grid_level {
    float lo[4];
    float size[4];  /* of a cell */
    float scale[4]; /* cells per length of 1; 0: there is one along this axis */
    float last[4];  /* the last cell: cells - 1 */
    uint32_t cells[4], stride[4];
    uint32_t *start; /* [cells + 1] of references */
    uint32_t *reference;
} plt_grid_level;

/* Cells of a slice that have references, along both axes after the slice's (x, y, z, x);
 * lo > hi: none has. */
typedef struct plt_grid_rect {
    uint16_t lo[2], hi[2];
} plt_grid_rect;

/* Macro cells (macro.h). */
#define PLT_WITH_MACRO_CELLS (PLT_WITH_GROUPS && PLT_LANES_REGISTERS)

typedef struct plt_grid_macro {
    uint32_t *bits;     /* one per macro cell, x, then y, then z: it has references */
    uint32_t stride[3]; /* bits */
} plt_grid_macro;

typedef struct plt_grid {
    plt_grid_level top;
#if PLT_WITH_MACRO_CELLS
    plt_grid_macro macro;
#endif
    plt_grid_rect *rect[3]; /* [cells along the axis] */
    plt_grid_level *crowded;
    uint32_t crowded_count;
    uint32_t references; /* of the top level */
    size_t bytes;        /* with itself and all behind it */
} plt_grid;

/* Cells that a box, or a point, is in. */
static inline u4 plt_grid_cell(f4 at, f4 lo, f4 scale, f4 last) {
    const f4 cell = f4_mul(f4_sub(at, lo), scale);
    return u4_of_f4(f4_min(f4_max(cell, f4_zero()), last));
}

static inline uint32_t plt_grid_cells(const plt_grid_level *l) {
    return l->cells[0] * l->cells[1] * l->cells[2];
}

#endif
