/* macro - cubes of cells that have no references
 *
 * A *macro cell* is 4 x 4 x 4 cells of the top level, and a bit that says whether any of them has
 * references; a *slab* is a layer of macro cells across an axis. For packets alone, and where four
 * lanes are one register: beams on small machines gain less by them than their code is worth
 * (DESIGN.md, section 6.3).
 *
 * Source: Wald, Ize, Kensler, Knoll, Parker, "Ray tracing animated scenes using coherent grid
 * traversal", 2006, section 4.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_GRID_MACRO_H
#define PLT_GRID_MACRO_H

#include <string.h>

#include "engine/grid/slices.h"

#define PLT_GRID_MACRO 4 /* cells along each axis */

static inline uint32_t plt_grid_macros_along(const plt_grid_level *l, int axis) {
    return (l->cells[axis] + PLT_GRID_MACRO - 1) / PLT_GRID_MACRO;
}

#if PLT_WITH_MACRO_CELLS
/* Of the bits of a grid whose top level has such cells. */
static inline size_t plt_grid_macro_bytes(const plt_grid_level *l) {
    const uint64_t bits = (uint64_t)plt_grid_macros_along(l, 0) * plt_grid_macros_along(l, 1) *
                          plt_grid_macros_along(l, 2);
    return (size_t)((bits + 31) / 32 * sizeof(uint32_t));
}

/* Lays them out, and clears them. */
static inline void plt_grid_macro_begin(plt_grid *g, void *room) {
    g->macro.bits = room;
    g->macro.stride[0] = 1;
    g->macro.stride[1] = plt_grid_macros_along(&g->top, 0);
    g->macro.stride[2] = g->macro.stride[1] * plt_grid_macros_along(&g->top, 1);
    memset(room, 0, plt_grid_macro_bytes(&g->top));
}

/* Cell x, y, z has references. */
static inline void plt_grid_macro_add(const plt_grid *g, uint32_t x, uint32_t y, uint32_t z) {
    const uint32_t bit = x / PLT_GRID_MACRO + y / PLT_GRID_MACRO * g->macro.stride[1] +
                         z / PLT_GRID_MACRO * g->macro.stride[2];
    g->macro.bits[bit / 32] |= 1u << (bit & 31u);
}

/* None of the macro cells of a slab that the patch reaches into has any. */
static inline int plt_grid_macro_is_empty(const plt_grid *g, int x, int y, int z, int32_t slab,
                                          const plt_grid_patch *c) {
    const uint32_t *stride = g->macro.stride;
    for (int32_t j = c->from[1] / PLT_GRID_MACRO; j <= c->to[1] / PLT_GRID_MACRO; j++) {
        for (int32_t i = c->from[0] / PLT_GRID_MACRO; i <= c->to[0] / PLT_GRID_MACRO; i++) {
            const uint32_t bit =
                (uint32_t)slab * stride[z] + (uint32_t)i * stride[x] + (uint32_t)j * stride[y];
            if ((g->macro.bits[bit / 32] >> (bit & 31u) & 1u) != 0) {
                return 0;
            }
        }
    }
    return 1;
}
#else
static inline size_t plt_grid_macro_bytes(const plt_grid_level *l) {
    (void)l;
    return 0;
}

static inline void plt_grid_macro_begin(const plt_grid *g, const void *room) {
    (void)g;
    (void)room;
}

static inline void plt_grid_macro_add(const plt_grid *g, uint32_t x, uint32_t y, uint32_t z) {
    (void)g;
    (void)x;
    (void)y;
    (void)z;
}
#endif

#endif
