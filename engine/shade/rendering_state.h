/* rendering_state - where a frame that is being rendered has got to
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_RENDERING_STATE_H
#define PLT_SHADE_RENDERING_STATE_H

#include "engine/schedule/batch.h"
#include "engine/shade/beam.h"
#include "engine/shade/frame_place.h"
#include "engine/shade/sampling.h"
#include "engine/shade/smooth_paint.h"
#include "engine/whitted/state.h"

#define PLT_TILE_BUFFER_BYTES (3 * PLT_TILE_SIDE * PLT_TILE_SIDE)

typedef struct plt_rendering {
    plt_frame frame;
    plt_view view;
    plt_beam *beam;                 /* in the memory of the packet */
    uint8_t *tile;                  /* PLT_TILE_BUFFER_BYTES, rows as wide as the current tile */
    uint8_t sky[3 * PLT_TILE_SIDE]; /* colour of the sky in each row of the tile */
    uint32_t side;                  /* of a packet */
#if PLT_WITH_INSTANCES
    plt_box box; /* of the scene, and around that what rays from the eye may miss it by */
#endif
    plt_frame_place at; /* the current packet */
#if PLT_WITH_WHITTED
    plt_whitted *whitted; /* NULL: there is no room for it */
#endif
#if PLT_WITH_TEXTURE
    plt_smooth_paint paint;
#endif
#if PLT_WITH_MIXES
    plt_sampling sampling;
    uint64_t visits; /* of nodes, before the current packet */
#endif
#if PLT_WITH_BATCH
    plt_batch *batch;      /* NULL: packets come one by one */
    plt_frame_place ahead; /* the next packet of the batch; `at` is the next to be shaded */
    uint32_t shaded;       /* packets of the batch */
    uint8_t phase;         /* enum batch_phase of rendering.c */
    uint32_t tiles_ahead;  /* are wanted, with that of `ahead` */
    uint8_t all_added;     /* there is none ahead */
#endif
#if PLT_WITH_TASK
    uint8_t by_tasks; /* packets are a dispatcher's: no beams */
#endif
#if PLT_WITH_STREAMED
    uint8_t curves; /* tiles go along curves */
#endif
    uint8_t tracing; /* the packet is set up and its traversal is not over */
    uint8_t beams;   /* packets are beams, not groups of rays */
    uint8_t done;    /* nothing left, or no frame begun */
} plt_rendering;

/* Samples along a pixel's side, and pixels along a packet's. */
static inline uint32_t plt_rendering_across(const plt_rendering *r) {
#if PLT_WITH_SAMPLES
    return r->sampling.across;
#else
    (void)r;
    return 1;
#endif
}

static inline uint32_t plt_rendering_side(const plt_rendering *r) {
#if PLT_WITH_SAMPLES
    return r->sampling.adapts ? r->side / 2 : r->side / r->sampling.across;
#else
    return r->side;
#endif
}

#endif
