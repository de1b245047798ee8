/* seek - see seek.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/seek.h"

#include "engine/shade/mixing.h"
#include "engine/shade/tile_sky.h"

uint32_t plt_rendering_tiles(const plt_rendering *r) {
    return r->done ? 0 : plt_tiles_along(r->frame.width) * plt_tiles_along(r->frame.height);
}

#if PLT_WITH_STREAMED
/* Where the square that holds tile `tile` begins on the curves. `*tile` becomes how many tiles of
 * that square come before it. A row of squares holds whole rows of tiles; of its squares only
 * the one at the right edge of the frame may be narrower, and in every other row it comes first. */
static uint32_t find_square(const plt_tile_order *o, uint32_t *tile) {
    const uint32_t side = PLT_TILE_SQUARE, across = (o->columns + side - 1) / side;
    const uint32_t square_row = *tile / (side * o->columns);
    const uint32_t height = plt_least(side, o->rows - side * square_row);
    const uint32_t narrow = (o->columns - side * (across - 1)) * height;
    uint32_t in_row = 0;
    *tile %= side * o->columns;
    if ((square_row & 1u) && *tile >= narrow) {
        *tile -= narrow;
        in_row = 1;
    }
    in_row += *tile / (side * height);
    *tile %= side * height;
    return side * side * (square_row * across + in_row);
}

/* At most the steps of one square. */
static void seek_on_curve(plt_rendering *r, uint32_t tile) {
    uint32_t column = 0, row = 0;
    r->at.order.at =
        find_square(&r->at.order, &tile) - 1; /* of the first square: all ones, and back */
    do {
        (void)plt_tile_order_next(&r->at.order, &column, &row);
    } while (tile-- > 0);
    r->at.x = PLT_TILE_SIDE * column;
    r->at.y = PLT_TILE_SIDE * row;
}
#endif

static void seek_in_rows(plt_rendering *r, uint32_t tile) {
    const uint32_t columns = plt_tiles_along(r->frame.width);
    r->at.x = tile % columns * PLT_TILE_SIDE;
    r->at.y = tile / columns * PLT_TILE_SIDE;
}

int plt_rendering_seek(plt_rendering *r, uint32_t tile, uint32_t count) {
    if (count == 0 || tile >= plt_rendering_tiles(r)) {
        return PLT_ERR_ARGUMENT;
    }
#if PLT_WITH_STREAMED
    if (r->curves) {
        seek_on_curve(r, tile);
    } else {
        seek_in_rows(r, tile);
    }
#else
    seek_in_rows(r, tile);
#endif
    r->at.px = r->at.py = 0;
    r->tracing = 0;
#if PLT_WITH_SAMPLES
    plt_samples_drop(r);
#endif
    plt_rendering_begin_batches(r, count);
    plt_tile_sky(&r->frame, &r->at, r->sky); /* as the first tile of a row does for all of them */
    return PLT_OK;
}
