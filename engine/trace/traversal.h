/* traversal - one worker's way through a scene: stacks, current treelet, counters
 *
 * A scene is constant and shared; everything that changes while packets are traced is
 * here. Any number of traversals may read one scene at the same time, each with a
 * packet of its own.
 *
 * Stack bounds: the needs in the scene's info, which opening has validated (SPEC.md,
 * I8); pushes are not checked again.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_TRAVERSAL_H
#define PLT_TRACE_TRAVERSAL_H

#include "engine/scene/parts.h"
#include "engine/scene/scene.h"
#include "engine/surface/page_fetch.h"
#include "engine/trace/packet.h"

typedef struct plt_traversal {
    const plt_scene *scene;
    uint8_t order; /* enum plt_order */
#if PLT_WITH_STREAMED
    uint8_t prefetch;     /* as plt_options */
    uint16_t entry_bytes; /* of the stack */
#endif
#if PLT_WITH_PAGES
    uint8_t keeps; /* hits of packets are kept (kept.h) */
#endif
    void *stack;      /* entries: depth first, or the global stack */
    uint32_t waiting; /* entries on it; 0: the packet is done */
#if PLT_WITH_PAGES
    union {
        void *local;           /* two-stage only */
        struct plt_kept *kept; /* depth first only: [side^2], or numbers of a beam's records */
    };
#else
    void *local; /* two-stage only */
#endif
#if PLT_WITH_HULLS
    void *leaves;            /* hulls only: they wait to be tested */
    unsigned leaves_waiting; /* PLT_LEAVES_WAITING and two at most */
#endif
#if PLT_WITH_STREAMED
    void *store;          /* of a streamed scene's parts */
    uint32_t store_bytes; /* of it */
#endif
#if PLT_WITH_BATCH
    struct plt_tasks *tasks; /* where packets wait at edges (tasks.h); NULL: they cross them */
#endif
    void *wave;        /* rays in flight (wave_state.h); NULL: not asked for */
    void *state;       /* what the format keeps from visit to visit */
    uint32_t *touched; /* a bit per block that was counted once; NULL: not asked for */
    uint32_t touched_words;
    plt_stats stats;
} plt_traversal;

/* Leaves that wait at most until they are tested, for packets with hulls. A visit adds two. */
#define PLT_LEAVES_WAITING 8u

/* Entries that the stack of a streamed scene has beyond depth_stack_entries, which nobody has
 * counted: what its blocks say of themselves is tested with this to spare, for the levels of
 * hulls, and for what a block has pushed itself when a packet comes back to it
 * (blocks_streamed.h, format_streamed_thesis.h). */
#define PLT_STACK_SLACK (4u + PLT_BLOCK_NODES_MOST)

/* Depth first, for packets with hulls (order_hulls.h); follows enum plt_order. */
#define PLT_ORDER_HULLS 2u

/* Packets wait at edges (tasks.h). */
static inline int plt_meets(const plt_traversal *t) {
#if PLT_WITH_BATCH
    return t->tasks != NULL;
#else
    (void)t;
    return 0;
#endif
}

/* The order that a packet is traced in. */
static inline unsigned plt_order_for(const plt_traversal *t, const plt_packet *p) {
#if PLT_WITH_HULLS
    return t->order == PLT_ORDER_DEPTH_FIRST && p->along ? PLT_ORDER_HULLS : t->order;
#else
    (void)p;
    return t->order;
#endif
}

/* Bytes of a stack entry; 0: this build does not have the format, or not in that order. */
size_t plt_entry_bytes(enum plt_format format, unsigned order);

/* Bytes of a format's state. */
size_t plt_state_bytes(enum plt_format format);

/* Words of a bit per part of a tree that can be fetched. */
uint32_t plt_touched_words(enum plt_format format, const plt_info *info);

/* With those of pages (surface/page_fetch.h), which are behind them. */
static inline uint32_t plt_touched_all_words(enum plt_format format, const plt_info *info) {
    uint32_t words = plt_touched_words(format, info);
#if PLT_WITH_PAGES
    if (plt_is_streamed(format) && info->page_bytes > 0) {
        words += plt_pages_touched_words(info->triangles);
    }
#endif
    return words;
}

/* Lays a traversal over the parts of an arena (scene/parts.h), by enum plt_part; those
 * of 0 bytes may be anything. */
void plt_traversal_init(plt_traversal *t, const plt_scene *scene, const plt_options *options,
                        void *const part[PLT_PARTS_COUNT]);

/* Sets the format's state up, as plt_traversal_init does. */
void plt_state_init(plt_traversal *t);

void plt_traversal_reset_stats(plt_traversal *t);

/* Starts a packet that is set up, and counts it and its `rays`. */
void plt_traversal_begin(plt_traversal *t, plt_packet *packet, uint32_t rays);

/* Nothing waits, whatever was under way: what comes next need not begin at the root. */
static inline void plt_traversal_drop(plt_traversal *t) {
    t->waiting = 0;
#if PLT_WITH_HULLS
    t->leaves_waiting = 0;
#endif
}

/* Works off stack entries until about `visits` nodes were visited or the packet is
 * done. PLT_OK: it is done; PLT_MORE; or what a fetch failed with: then nothing
 * waits any more, and hits so far may not be the nearest. */
int plt_traverse(plt_traversal *t, plt_packet *packet, uint32_t visits);

#if PLT_WITH_BATCH
/* The treelet, as its edges name it, need not be fetched. */
int plt_treelet_at_hand(const plt_traversal *t, uint32_t treelet);

#if PLT_WITH_PREFETCH
/* Packets wait at the treelet, of that scope, and will be worked off soon: it is asked for. */
void plt_treelet_expect(plt_traversal *t, uint32_t treelet, uint32_t scope);

/* The edge that is the only entry on the stack is not hidden from the packet by hits that were
 * found while it waited there. */
int plt_edge_is_open(const plt_traversal *t, const plt_packet *packet);

/* Waits for all that is on its way: where packets meet, plt_traverse does not. */
void plt_traversal_pause(plt_traversal *t);
#else
static inline void plt_traversal_pause(const plt_traversal *t) {
    (void)t;
}
#endif
#endif

#endif
