/* stream - compact blocks that come from a source when a ray needs them
 *
 * A block has three parts, each fetched when it is needed first (fetcher.h): its nodes; the
 * geometry of its leaves; and, if the image has them, the primitive ids of its triangles. A few
 * blocks are open, as those of a resident scene are (block_cache.h). What arrives is validated
 * before it is used (SPEC.md, section 5.5).
 *
 * Every block knows where its subtree ends: blocks lie depth first, so what is below an edge
 * lies between its block and that of the next edge by address. Links that leave this
 * range are refused, and so no image can lead a packet in a circle. A source that returns
 * other bytes when it is asked again is outside the contract; it gets no further than to wrong
 * hits, more visits, or a refusal.
 *
 * One stream per traversal. Source: Karrenberg 2007, section 4.3, SPEs that fetch treelets.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MEMORY_STREAM_H
#define PLT_MEMORY_STREAM_H

#include "engine/memory/block_cache.h"
#include "engine/memory/fetcher.h"

/* Where the image lies, and what its header says of the parts. */
typedef struct plt_stream_image {
    const plt_source *source;
    uint32_t blocks_at, ids_at; /* bytes of the image: where the sections begin */
    uint32_t triangles, source_triangles;
#if PLT_WITH_STILLS
    uint32_t stills_at; /* blocks of frame 0, and behind them those of the others */
#endif
} plt_stream_image;

enum plt_stream_part { PLT_STREAM_NODES, PLT_STREAM_GEOMETRY, PLT_STREAM_IDS, PLT_STREAM_PARTS };

typedef struct plt_stream_block {
    plt_opened_block opened;
    float end;                         /* of its subtree (plt_stream_end) */
    plt_found found[PLT_STREAM_PARTS]; /* its parts, as they were when they were opened */
} plt_stream_block;

typedef struct plt_stream {
    plt_stream_image image;
    plt_block_tree tree; /* the scene's, but that `ids` are those of the current block */
    plt_fetcher fetcher;
#if PLT_WITH_PREFETCH
    uint8_t expects; /* the current block's geometry, or has it */
#endif
    plt_stream_block *current; /* NULL: none */
    plt_stream_block cache[PLT_BLOCK_CACHE_SLOTS];
} plt_stream;

/* `memory`: of the store, `bytes` of it. Image and tree, and what plt_fetcher_init leaves to the
 * caller, are set by the caller. */
void plt_stream_init(plt_stream *stream, void *memory, uint32_t bytes);

/* Blocks are at multiples of 8 bytes, and so are the ends of their subtrees. A float holds such a
 * number of eights exactly, up to 2^24; what is more stands for the end of all blocks. */
static inline float plt_stream_end(uint32_t address) {
    return address / 8 < 1u << 24 ? (float)(address / 8) : 16777216.0f;
}

/* Makes the block behind `link` the current one, fetched if it is not there; its subtree ends
 * at `end`. PLT_OK, PLT_ERR_SOURCE, or PLT_ERR_IMAGE: what came breaks a rule; the fault says
 * which, and there is no current block. */
int plt_stream_open(plt_stream *stream, uint32_t link, float end);

/* The nodes of the block behind `link` are in the store. Asking does not count as finding. */
int plt_stream_has(const plt_stream *stream, uint32_t link);

/* And so is the current block's geometry. */
int plt_stream_has_geometry(const plt_stream *stream);

#if PLT_WITH_PREFETCH
/* The block behind `link` will be needed soon: its nodes are asked for (prefetch.h). The current
 * block may move, and is opened again before it is used. */
void plt_stream_expect(plt_stream *stream, uint32_t link, float end);

/* The current block's geometry will be. */
void plt_stream_expect_geometry(plt_stream *stream);
#endif

/* Does the current block have the node, or the leaf, a pair or not, with so many pairs before? A
 * place that has waited asks, as its block may have come anew meanwhile, and be another. */
int plt_stream_has_node(const plt_stream *stream, uint32_t node);
int plt_stream_has_leaf(const plt_stream *stream, uint32_t leaf, uint32_t pairs, uint32_t pair);

/* Fetches and opens the current block's geometry part, and ids, likewise. */
int plt_stream_open_geometry(plt_stream *stream);

/* How deep the current block is, in nodes. */
static inline uint32_t plt_stream_depth(const plt_stream *s) {
    return s->fetcher.store.part[s->current->found[PLT_STREAM_NODES].part].depth;
}

/* Where the subtree ends that edge `link` of the block leads to. */
float plt_stream_edge_end(const plt_stream_block *block, uint32_t link);

/* Breaks off: the current block breaks rule `rule`. */
int plt_stream_refuse(plt_stream *stream, uint8_t rule);

#endif
