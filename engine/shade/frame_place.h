/* frame_place - where in a frame: a tile, and a packet within it
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_FRAME_PLACE_H
#define PLT_SHADE_FRAME_PLACE_H

#include "engine/planelet.h"
#include "engine/shade/tile_order.h"

/* Pixels. */
typedef struct plt_frame_place {
    uint32_t x, y, px, py;
#if PLT_WITH_STREAMED
    plt_tile_order order; /* of the tiles of a streamed scene */
#endif
} plt_frame_place;

static inline uint32_t plt_least(uint32_t a, uint32_t b) {
    return a < b ? a : b;
}

/* Of the tile; those at the right and at the bottom may be smaller. */
static inline uint32_t plt_tile_width(const plt_frame *f, const plt_frame_place *at) {
    return plt_least(PLT_TILE_SIDE, f->width - at->x);
}

static inline uint32_t plt_tile_height(const plt_frame *f, const plt_frame_place *at) {
    return plt_least(PLT_TILE_SIDE, f->height - at->y);
}

/* To the next packet of side^2 rays of the tile; 0 when there is none. */
static inline int plt_place_next_packet(plt_frame_place *at, const plt_frame *f, uint32_t side) {
    at->px += side;
    if (at->px >= plt_tile_width(f, at)) {
        at->px = 0;
        at->py += side;
    }
    return at->py < plt_tile_height(f, at);
}

static inline int plt_place_follow_curve(plt_frame_place *at) {
#if PLT_WITH_STREAMED
    uint32_t column = 0, row = 0;
    const int there = plt_tile_order_next(&at->order, &column, &row);
    at->x = PLT_TILE_SIDE * column;
    at->y = PLT_TILE_SIDE * row;
    return there;
#else
    (void)at;
    return 0;
#endif
}

/* To the next tile; 0 at the end of the frame. */
static inline int plt_place_next_tile(plt_frame_place *at, const plt_frame *f, int curves) {
    at->px = at->py = 0;
    if (curves) {
        return plt_place_follow_curve(at);
    }
    at->x += PLT_TILE_SIDE;
    if (at->x >= f->width) {
        at->x = 0;
        at->y += PLT_TILE_SIDE;
    }
    return at->y < f->height;
}

/* Tiles along so many pixels. */
static inline uint32_t plt_tiles_along(uint32_t pixels) {
    return (pixels + PLT_TILE_SIDE - 1u) / PLT_TILE_SIDE;
}

#endif
