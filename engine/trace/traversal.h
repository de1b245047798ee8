/* traversal - one worker's way through a scene: stacks, opened blocks, counters
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

#include "engine/memory/block_cache.h"
#include "engine/scene/scene.h"
#include "engine/trace/packet.h"

typedef struct plt_traversal {
    const plt_scene *scene;
    uint8_t order;            /* enum plt_order */
    void *stack;              /* entries of the scene's format: depth first, or the global stack */
    uint32_t waiting;         /* entries on it; 0: the packet is done */
    void *local;              /* two-stage only */
    uint32_t treelet;         /* thesis nodes: the treelet block in hand, PLT_MISS: none */
    plt_opened_block *cache;  /* compact blocks: PLT_BLOCK_CACHE_SLOTS slots */
    plt_opened_block *opened; /* the one in hand, NULL: none */
    uint8_t geometry_counted; /* its geometry part is in the statistics */
    uint32_t *touched;        /* a bit per block that was counted once; NULL: not asked for */
    plt_stats stats;
} plt_traversal;

/* Memory that a traversal needs beside its structure, cut by the caller. */
typedef struct plt_traversal_memory {
    void *stack, *local;     /* plt_entry_bytes each entry; local: two-stage only */
    plt_opened_block *cache; /* PLT_BLOCK_CACHE_SLOTS of them; compact blocks only */
    uint32_t *touched;       /* plt_touched_words; or NULL */
} plt_traversal_memory;

/* Bytes of a stack entry of a format, both stacks. */
size_t plt_entry_bytes(enum plt_format format);

/* Words of a bit per block that can be fetched. */
uint32_t plt_touched_words(const plt_info *info);

void plt_traversal_init(plt_traversal *t, const plt_scene *scene, enum plt_order order,
                        const plt_traversal_memory *memory);

/* Starts a packet that is set up, and counts it and its `rays`. */
void plt_traversal_begin(plt_traversal *t, const plt_packet *packet, uint32_t rays);

/* Works off stack entries until about `visits` nodes were visited or the packet is
 * done. PLT_OK: it is done; PLT_MORE; or what a fetch failed with: then nothing
 * waits any more, and hits so far may not be the nearest. */
int plt_traverse(plt_traversal *t, plt_packet *packet, uint32_t visits);

#endif
