/* tile_order - see tile_order.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/tile_order.h"

/* Where a Hilbert curve of a square is after `step` steps: from the smallest quarter up, each is
 * turned as its place in the next demands. */
static void on_curve(uint32_t step, uint32_t *x, uint32_t *y) {
    *x = *y = 0;
    for (uint32_t side = 1; side < PLT_TILE_SQUARE; side *= 2, step /= 4) {
        const uint32_t right = step >> 1 & 1u, up = (step ^ right) & 1u;
        if (!up) {
            const uint32_t from = *x;
            *x = right ? side - 1 - *y : *y;
            *y = right ? side - 1 - from : from;
        }
        *x += right * side;
        *y += up * side;
    }
}

/* Curves begin and end at the same edge of their squares, so every square of a row begins next to
 * where the one before has ended. */
static void place_of(const plt_tile_order *o, uint32_t *column, uint32_t *row) {
    const uint32_t steps = PLT_TILE_SQUARE * PLT_TILE_SQUARE;
    const uint32_t across = (o->columns + PLT_TILE_SQUARE - 1) / PLT_TILE_SQUARE;
    const uint32_t square = o->at / steps, square_row = square / across;
    const uint32_t backwards = square_row & 1u;
    const uint32_t in_row = square % across;
    const uint32_t square_column = backwards ? across - 1 - in_row : in_row;
    uint32_t x, y;
    on_curve(o->at % steps, &x, &y);
    *column = square_column * PLT_TILE_SQUARE + (backwards ? PLT_TILE_SQUARE - 1 - x : x);
    *row = square_row * PLT_TILE_SQUARE + y;
}

int plt_tile_order_next(plt_tile_order *o, uint32_t *column, uint32_t *row) {
    const uint32_t square_rows = (o->rows + PLT_TILE_SQUARE - 1) / PLT_TILE_SQUARE;
    const uint32_t across = (o->columns + PLT_TILE_SQUARE - 1) / PLT_TILE_SQUARE;
    const uint32_t steps = PLT_TILE_SQUARE * PLT_TILE_SQUARE * across * square_rows;
    while (++o->at < steps) {
        place_of(o, column, row);
        if (*column < o->columns && *row < o->rows) {
            return 1;
        }
    }
    return 0;
}
