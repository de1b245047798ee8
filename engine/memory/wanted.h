/* wanted - parts of an image that are wanted, and room for them in a store
 *
 * What fetches a part when it is needed (fetcher.h) and what fetches it before (prefetch.h) share.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MEMORY_WANTED_H
#define PLT_MEMORY_WANTED_H

#include "engine/memory/store.h"

typedef struct plt_fetcher {
    const plt_source *source;
    plt_stats *stats;
    uint32_t *touched; /* bits as of plt_traversal; NULL: not asked for */
    plt_fault fault;   /* why the last call failed */
    plt_store store;
    uint32_t serial; /* of the part that was asked for last */
#if PLT_WITH_PREFETCH
    uint8_t ahead;                      /* parts on their way at most (prefetch.h); 0: none */
    uint16_t coming[PLT_PREFETCH_MOST]; /* the parts; PLT_STORE_NONE: none */
#endif
} plt_fetcher;

/* A part that is wanted. */
typedef struct plt_wanted {
    uint32_t key;           /* its name in the store */
    uint32_t offset, count; /* bytes of the image */
#if PLT_WITH_THESIS
    uint32_t beside_at, beside; /* bytes that come from elsewhere, and lie behind those */
#endif
    uint32_t against;   /* serial of the part that it is validated against; 0: none */
    uint32_t bit;       /* of `touched` */
    uint8_t is_treelet; /* its arrival is one of plt_stats.treelet_fetches */
    /* Is the part valid, which lies in the store? PLT_OK, or PLT_ERR_IMAGE with the fault set. */
    int (*check)(const void *context, uint16_t part);
    const void *context;
} plt_wanted;

/* All its bytes. */
static inline uint32_t plt_wanted_bytes(const plt_wanted *w) {
#if PLT_WITH_THESIS
    return w->count + w->beside;
#else
    return w->count;
#endif
}

/* Room for a part that is to come, of which it is known that it is not there, counted as an
 * arrival. PLT_STORE_NONE: parts that are held leave none. */
uint16_t plt_fetcher_take(plt_fetcher *fetcher, const plt_wanted *wanted);

#endif
