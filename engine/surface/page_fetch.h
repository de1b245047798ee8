/* page_fetch - pages of what corners have that come from a source when a triangle is shaded
 *
 * They lie in the store of the scene's blocks, or treelets, and so do the chunks that say where
 * they are.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SURFACE_PAGE_FETCH_H
#define PLT_SURFACE_PAGE_FETCH_H

#include "engine/memory/fetcher.h"
#include "engine/surface/surface_pages.h"

#if PLT_WITH_PAGES

/* Words of a bit for each chunk and page that there can be of so many triangles. */
static inline uint32_t plt_pages_touched_words(uint32_t triangles) {
    const uint32_t pages = (triangles >> PLT_PAGE_SHIFT_LEAST) + 1;
    return (pages + pages / PLT_PAGES_IN_CHUNK + 1) / 32 + 1;
}

/* The tables of a page, fetched if it is not in the store; they stay until the next call that
 * fetches. `bit`: the first of fetcher->touched that is pages'. PLT_OK, PLT_ERR_SOURCE, or
 * PLT_ERR_IMAGE: what came breaks I31. */
int plt_page_fetch(plt_fetcher *fetcher, const plt_surface_data *data, uint32_t bit, uint32_t page,
                   plt_surface_data *view);

#endif
#endif
