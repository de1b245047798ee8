/* treelet_stream - thesis nodes and float records that come from a source when a ray needs them
 *
 * Parts (fetcher.h) are treelets, and pages of PLT_PAGE_RECORDS records, which is where a list is
 * looked for. Lists lie in the order of the tree, so a page has those of a few neighbours. What
 * arrives is validated before it is used (SPEC.md, section 5.5).
 *
 * A treelet that edges leave fills a block of N slots, and those blocks lie depth first. So it is
 * known where the blocks of a treelet's subtree end: what is below an edge lies in front of the
 * block of the next edge. An edge that leads elsewhere leads to a treelet *alone*, without edges:
 * one of those that share blocks, of a few nodes each. So no image can lead a packet in a circle,
 * or to a subtree with edges twice; to a treelet alone each edge leads once. A source that returns
 * other bytes when it is asked again is outside the contract; it gets no further than to wrong
 * hits, more visits, or a refusal.
 *
 * One stream per traversal. Source: Karrenberg 2007, section 4.3, SPEs that fetch treelets.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MEMORY_TREELET_STREAM_H
#define PLT_MEMORY_TREELET_STREAM_H

#include "engine/memory/fetcher.h"
#include "engine/tree/record.h"
#include "engine/tree/thesis/validate_treelet.h"

/* Where the image lies: its source, and the bytes at which the sections begin. */
typedef struct plt_treelet_image {
    const plt_source *source;
    uint32_t nodes_at, records_at;
    uint32_t checks_at; /* 0: neither nodes nor records have checks */
} plt_treelet_image;

/* The scope of a treelet: the block at which the blocks of its subtree end; or if it is alone, this
 * bit, and its first slot. */
#define PLT_TREELET_ALONE 0x80000000u

typedef struct plt_treelet_stream {
    plt_fetcher fetcher;
    plt_treelet_image image;
    plt_treelet_scene scene;
    uint32_t longest_list; /* K, as the header claims it */
    /* The current treelet. */
    uint32_t first; /* slot; PLT_MISS: there is none */
    uint32_t count; /* of its nodes */
    uint32_t scope;
    const plt_node *nodes;
    plt_found found;
    int starts_known;
    plt_treelet_starts starts; /* if they are */
    uint32_t start[PLT_STREAMED_TREELET_MOST + 1];
} plt_treelet_stream;

/* Nodes that are asked for of a treelet alone; if they are not all, four times as many, and then
 * all that its block has. */
#define PLT_ALONE_NODES 4u

/* Lists on their way through pages. */
typedef struct plt_lists_left {
    uint32_t record;      /* the next */
    uint32_t lists;       /* that have not ended */
    uint32_t length;      /* of the current one so far */
    const plt_record *at; /* what was read last: ... */
    uint32_t count;       /* ... so many records in a row */
} plt_lists_left;

/* `memory`: of the store, `bytes` of it. Image, scene and longest list, and what plt_fetcher_init
 * leaves to the caller, are set by the caller. */
void plt_treelet_stream_init(plt_treelet_stream *stream, void *memory, uint32_t bytes);

/* Makes the treelet of that scope that has the node in `slot` the current one, fetched if it is
 * not there. PLT_OK, PLT_ERR_SOURCE, or PLT_ERR_IMAGE: what came breaks a rule; the fault says
 * which, and there is no current treelet. */
int plt_treelet_stream_open(plt_treelet_stream *stream, uint32_t slot, uint32_t scope);

/* Nodes of the treelet that begins at that slot are in the store. Asking is not finding. */
int plt_treelet_stream_has(const plt_treelet_stream *stream, uint32_t slot);

/* The scope of the treelet behind an edge of the current one, whose first slot it is. */
uint32_t plt_treelet_stream_edge(plt_treelet_stream *stream, uint32_t slot);

/* Reads on to the end of the lists, or of a page. Likewise. The records stay until the next call.
 * The current treelet stays the current one. */
int plt_treelet_stream_read(plt_treelet_stream *stream, plt_lists_left *left);

#if PLT_WITH_PREFETCH
/* The treelet will be needed soon, and is asked for (prefetch.h). There is no current one any more
 * until it is opened again. */
void plt_treelet_stream_expect(plt_treelet_stream *stream, uint32_t slot, uint32_t scope);

/* The page of that record will be. The current treelet stays the current one. */
void plt_treelet_stream_expect_records(plt_treelet_stream *stream, uint32_t record);
#endif

/* Breaks off: the current treelet breaks rule `rule`. */
int plt_treelet_stream_refuse(plt_treelet_stream *stream, uint8_t rule);

/* The node in `slot`, of that scope, is one of the current treelet. */
static inline int plt_treelet_stream_is_in(const plt_treelet_stream *s, uint32_t slot,
                                           uint32_t scope) {
    return s->first != PLT_MISS && scope == s->scope && slot - s->first < s->count;
}

static inline const plt_node *plt_treelet_stream_node(const plt_treelet_stream *s, uint32_t slot) {
    return &s->nodes[slot - s->first];
}

/* How deep the current treelet is, in nodes. */
static inline uint32_t plt_treelet_stream_depth(const plt_treelet_stream *s) {
    return s->fetcher.store.part[s->found.part].depth & 0x7Fu;
}

#endif
