/* prefetch - parts of an image that are on their way before they are needed
 *
 * A part that will be needed soon is asked for, and comes while the rays go on: its place in the
 * store is held until it is waited for. It is waited for when it is needed, when its tag is wanted
 * for another part, when parts that are on their way leave too little room, or when the call that
 * traces returns. What has come is validated when it is needed. One that fails is forgotten, and
 * fetched like any other when it is needed.
 *
 * A source that is mapped has nothing to wait for, and nothing is asked of it.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MEMORY_PREFETCH_H
#define PLT_MEMORY_PREFETCH_H

#include "engine/memory/wanted.h"

#define PLT_PREFETCH_TRANSFERS 4u

#if PLT_WITH_PREFETCH

/* From now on so many parts, PLT_PREFETCH_MOST at most, may be on their way; 0: none. The fetcher
 * has its source. */
void plt_prefetch_begin(plt_fetcher *fetcher, unsigned parts);

/* Asks for a part, if it is not there and is no more than PLT_PREFETCH_TRANSFERS transfers, or a
 * quarter of the store. Other parts may move or be given up. */
void plt_prefetch_ask(plt_fetcher *fetcher, const plt_wanted *wanted);

/* Waits for a part that nobody has used yet, if it is on its way. 0: it has failed, and is
 * forgotten. */
int plt_prefetch_arrive(plt_fetcher *fetcher, uint16_t part);

/* Waits for all parts that are on their way. */
void plt_prefetch_end(plt_fetcher *fetcher);

#else

static inline void plt_prefetch_begin(plt_fetcher *fetcher, unsigned parts) {
    (void)fetcher;
    (void)parts;
}

static inline void plt_prefetch_ask(plt_fetcher *fetcher, const plt_wanted *wanted) {
    (void)fetcher;
    (void)wanted;
}

static inline int plt_prefetch_arrive(plt_fetcher *fetcher, uint16_t part) {
    (void)fetcher;
    (void)part;
    return 1;
}

static inline void plt_prefetch_end(plt_fetcher *fetcher) {
    (void)fetcher;
}

#endif

#endif
