/* tile_order - the order in which the tiles of a frame come
 *
 * Those of a resident scene come row by row. Those of a streamed one go along Hilbert curves
 * through squares of 8 x 8 tiles, themselves in rows that go to and fro. Neighbours in that order
 * are neighbours in the picture, and a row of squares is high: what was fetched for a tile is
 * wanted again soon, if at all. Measured in DESIGN.md, section 3.1.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_TILE_ORDER_H
#define PLT_SHADE_TILE_ORDER_H

#include <stdint.h>

/* Tiles along the side of a square, a power of two. */
#define PLT_TILE_SQUARE 8u

typedef struct plt_tile_order {
    uint32_t columns, rows; /* tiles */
    uint32_t at;            /* steps taken along the curves */
} plt_tile_order;

/* The next tile; 0: there is none left. The first, at step 0, is in the corner. Steps of curves
 * that lie outside of the frame are left out, fewer than two squares have. */
int plt_tile_order_next(plt_tile_order *order, uint32_t *column, uint32_t *row);

#endif
