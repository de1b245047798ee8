/* blocks_streamed - compact blocks that are fetched when a packet needs them
 *
 * What format_compact.h asks of it: blocks_resident.h. The state of the format is a stream
 * (memory/stream.h).
 *
 * A scene that is not read when it is opened claims how deep it is; so every block says how
 * deep it is itself, and is refused where the stack might not hold what it pushes.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_BLOCKS_STREAMED_H
#define PLT_TRACE_BLOCKS_STREAMED_H

#include "engine/base/rules.h"
#include "engine/memory/prefetch.h"
#include "engine/memory/stream.h"
#include "engine/trace/block_place.h"
#include "engine/trace/block_target.h"
#include "engine/trace/kept.h"
#include "engine/trace/tasks.h"
#include "engine/trace/traversal.h"

#define FORMAT_MEETS PLT_WITH_BATCH

typedef plt_stream format_state;

static inline void format_state_init(plt_traversal *t) {
    plt_stream *s = (plt_stream *)t->state;
    s->image = t->scene->stream;
    s->tree = t->scene->compact;
    s->fetcher.source = s->image.source;
    s->fetcher.stats = &t->stats;
    s->fetcher.touched = t->touched;
    plt_stream_init(s, t->store, t->store_bytes);
    plt_prefetch_begin(&s->fetcher, t->prefetch);
}

static inline void blocks_leave(format_state *state) {
    state->current = NULL;
}

static inline plt_opened_block *blocks_current(const plt_traversal *t) {
    return &((const format_state *)t->state)->current->opened;
}

static inline const plt_block_tree *blocks_tree(const plt_traversal *t) {
    return &((const format_state *)t->state)->tree;
}

#if PLT_WITH_PREFETCH
/* The block behind `link` is asked for, then those of what waits, the next one first. An entry of
 * every order begins with its place, and one of a beam has link and end where that has them. */
static inline void look_ahead(plt_traversal *t, uint32_t link, float end) {
    format_state *s = (format_state *)t->state;
    const unsigned char *top = (const unsigned char *)t->stack + t->waiting * t->entry_bytes;
    const uint32_t most = t->waiting < s->fetcher.ahead ? t->waiting : s->fetcher.ahead;
    plt_stream_expect(s, link, end);
    for (uint32_t i = 0; i < most; i++) {
        top -= t->entry_bytes;
        const plt_block_place *next = (const plt_block_place *)(const void *)top;
        plt_stream_expect(s, next->link, next->hi[3]);
    }
}

#endif

static inline int blocks_open(plt_traversal *t, uint32_t link, float end) {
    format_state *s = (format_state *)t->state;
    if (s->current != NULL && s->current->opened.link == link && s->current->end == end) {
        return PLT_OK;
    }
#if PLT_WITH_PREFETCH
    if (s->fetcher.ahead > 0 && !plt_meets(t)) { /* edges on the stack wait, where packets meet */
        look_ahead(t, link, end);
    }
#endif
    const int status = plt_stream_open(s, link, end);
    if (status == PLT_OK &&
        t->waiting + plt_stream_depth(s) > t->scene->info.depth_stack_entries + PLT_STACK_SLACK) {
        return plt_stream_refuse(s, PLT_I18_COUNTS);
    }
    return status;
}

/* To a place that has waited in a block: that of `link` now, and the place is there. */
static inline int blocks_return(plt_traversal *t, uint32_t link, float end, uint32_t target) {
    format_state *s = (format_state *)t->state;
    const uint32_t index = plt_target_index(target);
    const int status = blocks_open(t, link, end);
    if (status != PLT_OK) {
        return status;
    }
    const int is_there = plt_target_kind(target) == PLT_SLOT_LEAF
                             ? plt_stream_has_leaf(s, index, target >> 16 & 0xFFu, target >> 24)
                             : plt_stream_has_node(s, index);
    return is_there ? PLT_OK : plt_stream_refuse(s, PLT_I11_KINDS);
}

static inline int blocks_open_geometry(plt_traversal *t) {
    return plt_stream_open_geometry((format_state *)t->state);
}

static inline int blocks_at_hand(const plt_traversal *t, uint32_t link) {
    return plt_stream_has((const format_state *)t->state, link);
}

static inline int blocks_geometry_at_hand(const plt_traversal *t) {
    return plt_stream_has_geometry((const format_state *)t->state);
}

/* A child of the node is a leaf. */
static inline int has_leaf(const plt_block *b, uint32_t node) {
    const uint32_t word = node >> 4, shift = node << 1 & 31;
    const uint32_t inner = b->mask[PLT_SLOT_INNER][word] | b->mask[PLT_SLOT_EDGE][word];
    return (~inner >> shift & 3u) != 0;
}

/* Triangles are probably needed next; blocks behind the node's edges only if they are met. */
static inline void blocks_prefetch(const plt_traversal *t, const plt_block *b, uint32_t node) {
#if PLT_WITH_PREFETCH
    format_state *s = (format_state *)t->state;
    if (s->fetcher.ahead > 0 && !s->expects && has_leaf(b, node)) {
        plt_stream_expect_geometry(s);
    }
#else
    (void)t;
    (void)b;
    (void)node;
#endif
}

static inline float blocks_root_end(const plt_block_tree *tree) {
    return plt_stream_end(tree->used);
}

static inline float blocks_edge_end(const plt_opened_block *o, uint32_t link) {
    /* `opened` is the first member. */
    return plt_stream_edge_end((const plt_stream_block *)(const void *)o, link);
}

static inline void blocks_set_end(float hi[4], float end) {
    hi[3] = end;
}

static inline void blocks_keep(const plt_traversal *t, const plt_packet *p, const plt_leaf_run *run,
                               plt_mask groups) {
#if PLT_WITH_PAGES && PLT_WITH_GROUPS
    if (plt_keeps(t, p)) {
        plt_keep_strips(t->kept, p, blocks_tree(t), &blocks_current(t)->geometry, run, groups);
    }
#else
    (void)t;
    (void)p;
    (void)run;
    (void)groups;
#endif
}

#endif
