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

#include "engine/memory/wanted.h"

/* A part that was found, as it was then. */
typedef struct plt_found {
    uint32_t at, serial;
    uint16_t part; /* in the store; PLT_STORE_NONE: there is none */
} plt_found;

/* `memory`: of the store, `bytes` of it. Source, stats and touched are set by the caller. Nothing
 * is prefetched (plt_prefetch_begin). */
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
