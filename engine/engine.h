/* engine - what lies at the front of the arena
 *
 * Arena, in the order of the cuts (DESIGN.md, section 3):
 *   plt_engine | scene, unless it is mapped | touched bits | packet groups |
 *   film tile | stacks | open blocks, for compact scenes. Scratch of opening and
 *   building comes last and is given back.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_ENGINE_H
#define PLT_ENGINE_H

#include "engine/base/arena.h"
#include "engine/builder/blocks.h"
#include "engine/image/header.h"
#include "engine/planelet.h"
#include "engine/trace/walk.h"

/* A frame in the making: tiles from left to right, top down; packets of a
 * tile likewise, the rays of a packet in Z order. */
typedef struct plt_rendering {
    plt_frame frame;
    float corner[3], right[3], down[3]; /* direction of pixel (0, 0), steps */
    uint32_t x, y;                      /* tile in hand, pixels */
    uint32_t px, py;                    /* packet in hand, pixels within the tile */
    uint8_t tracing;                    /* the packet is set up and its walk is not over */
    uint8_t done;                       /* nothing left, or no frame begun */
} plt_rendering;

struct plt_engine {
    plt_arena arena;
    plt_source source;
    plt_options options;
    plt_header header;
    plt_walker walker;
    plt_rendering rendering;
    plt_blocks_job build; /* of compact blocks, while it runs */
    size_t build_mark;    /* arena in use before it */
    size_t build_peak;    /* and the peak till then */
    uint8_t building;     /* between plt_open_begin and the step that ends it */
    int8_t failed;        /* what a step of it failed with; PLT_OK: none has */
    uint8_t *film;        /* a tile, 3 bytes a pixel, rows as wide as the tile in hand */
    uint32_t touched_words;
};

/* Goes on with the packet; returns the visits left. */
static inline uint32_t plt_engine_walk(plt_engine *e, uint32_t visits) {
    if (e->walker.compact) {
        return plt_walk_blocks(&e->walker, visits);
    }
    return e->options.order == PLT_ORDER_TWO_STAGE ? plt_walk_two_stage(&e->walker, visits)
                                                   : plt_walk_depth_first(&e->walker, visits);
}

#endif
