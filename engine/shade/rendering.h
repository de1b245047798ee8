/* rendering - a frame, tile after tile, a bounded piece at a time
 *
 * Tiles go from left to right, top down, or as tile_order.h has it; the packets of a tile
 * from left to right, top down, the rays of a packet in Z order.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_RENDERING_H
#define PLT_SHADE_RENDERING_H

#include "engine/schedule/batch.h"
#include "engine/shade/beam.h"
#include "engine/shade/frame_place.h"
#include "engine/shade/sampling.h"

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

/* No frame is begun; `tile` is the buffer that finished tiles lie in, `beam` where a beam may
 * be, plt_beam_bytes(packet_side) of it: the memory of a packet, as it is one or the other. */
void plt_rendering_init(plt_rendering *r, uint8_t *tile, void *beam, uint32_t packet_side);

/* As plt_render_begin, plt_render_step and plt_render_tile. */
int plt_rendering_begin(plt_rendering *r, const plt_frame *frame, const plt_traversal *t);
int plt_rendering_step(plt_rendering *r, plt_traversal *t, plt_packet *packet, uint32_t visits);
void plt_rendering_tile(const plt_rendering *r, plt_tile *tile);

#if PLT_WITH_BATCH
/* The next batch, if there are any, begins with the packet at `at`; they end after `tiles` tiles.
 */
void plt_rendering_begin_batches(plt_rendering *r, uint32_t tiles);

/* `ahead` goes to the next packet that is wanted; 0: there is none. */
int plt_rendering_ahead(plt_rendering *r);
#else
static inline void plt_rendering_begin_batches(const plt_rendering *r, uint32_t tiles) {
    (void)r;
    (void)tiles;
}
#endif

#endif
