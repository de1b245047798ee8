/* fetcher - parts of an image that come from a source when they are needed
 *
 * Parts lie in a store (store.h). One that is not there is fetched, PLT_FETCH_TRIES times at
 * most if it is late, short or wrong, and is not used before its owner has found it valid.
 * What a part is, and when it is valid, the owner says; stream.h does of compact blocks.
 *
 * Every arrival has a serial number. A part that is validated against another (triangles against
 * the nodes that lead to them) is validated again when that one has come anew.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MEMORY_FETCHER_H
#define PLT_MEMORY_FETCHER_H

#include "engine/memory/store.h"

typedef struct plt_fetcher {
    const plt_source *source;
    plt_stats *stats;
    uint32_t *touched; /* bits as of plt_traversal; NULL: not asked for */
    plt_fault fault;   /* why the last call failed */
    plt_store store;
    uint32_t serial; /* of the part that came last */
} plt_fetcher;

/* A part that is wanted. */
typedef struct plt_wanted {
    uint32_t key;           /* its name in the store */
    uint32_t offset, count; /* bytes of the image */
    uint32_t against;       /* serial of the part that it is validated against; 0: none */
    uint32_t bit;           /* of `touched` */
    uint8_t is_treelet;     /* its arrival is one of plt_stats.treelet_fetches */
    /* Is the part valid, which lies in the store? PLT_OK, or PLT_ERR_IMAGE with the fault set. */
    int (*check)(const void *context, uint16_t part);
    const void *context;
} plt_wanted;

/* A part that was found, as it was then. */
typedef struct plt_found {
    uint32_t at, serial;
    uint16_t part; /* in the store; PLT_STORE_NONE: there is none */
} plt_found;

/* `memory`: of the store, `bytes` of it. Source, stats and touched are set by the caller. */
void plt_fetcher_init(plt_fetcher *fetcher, void *memory, uint32_t bytes);

/* Finds the part, or fetches it. Parts that are not held may move or be given up. PLT_OK,
 * PLT_ERR_SOURCE, PLT_ERR_IMAGE, or PLT_ERR_LIMIT: parts that are held leave no room. */
int plt_fetcher_need(plt_fetcher *fetcher, const plt_wanted *wanted, plt_found *found);

/* Is it in the store still, unmoved, and has not come anew? Then it counts as used. */
int plt_fetcher_has(plt_fetcher *fetcher, uint32_t key, const plt_found *found);

static inline plt_store_part *plt_fetcher_part(plt_fetcher *fetcher, const plt_found *found) {
    return &fetcher->store.part[found->part];
}

static inline const unsigned char *plt_fetcher_bytes(const plt_fetcher *fetcher,
                                                     const plt_found *found) {
    return plt_store_bytes(&fetcher->store, found->part);
}

#endif
