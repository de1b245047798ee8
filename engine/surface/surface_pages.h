/* surface_pages - normals, colours and texture coordinates of an image, some triangles at a time
 *
 * Triangles lie in an image so that neighbours are near each other. A page has the tables
 * (surface_data.h) of so many of them, one after the other: all that one of them needs, though
 * positions at its border are in other pages, too. So of a scene that is streamed the pages come
 * that triangles are shaded of, and of no triangle it must be known where it is.
 *
 * Pages have a directory, in chunks, which come likewise. Both have checks, which tell one from
 * another.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SURFACE_SURFACE_PAGES_H
#define PLT_SURFACE_SURFACE_PAGES_H

#include "engine/base/bytes.h"
#include "engine/surface/surface_data.h"

#if PLT_WITH_PAGES

enum {
    PLT_PAGES_HEAD = 64, /* bytes of what the section begins with; behind that is the palette */
    PLT_PAGES_CHUNK = 256,
    PLT_PAGES_IN_CHUNK = 62,
    PLT_PAGE_HEAD = 4,          /* bytes in front of its tables */
    PLT_PAGE_BYTES_MOST = 8184, /* of a page */
    PLT_PAGE_SHIFT_LEAST = 6,   /* triangles of a page, as a power of two */
    PLT_PAGE_SHIFT_MOST = 12,
    PLT_PAGES_COLOUR_BITS = 8 /* of an entry: palettes are small */
};

/* What pages have tables of: bits, in the order of their tables. */
enum { PLT_PAGES_NORMALS = 1, PLT_PAGES_COLOURS = 2, PLT_PAGES_TEXCOORDS = 4, PLT_PAGES_ALL = 7 };

/* Head and palette, as much as there may be. */
#define PLT_PAGES_ROOM (PLT_PAGES_HEAD + PLT_PALETTE_SMALL * PLT_PALETTE_BYTES)

#define PLT_PAGES_CHUNK_DAMAGED "where pages of what corners have are is damaged (check)"
#define PLT_PAGES_PAGE_DAMAGED "what corners of some triangles have is damaged (check)"

/* Their check, with its own four bytes, at 12, as 0; `bytes`: of both. */
uint32_t plt_pages_head_check(const unsigned char *head, uint32_t bytes);

/* Of chunk or page `number`: of `bytes`, in front of which it stands. */
uint32_t plt_pages_check(uint32_t number, const unsigned char *bytes, uint32_t count);

/* Sets `d` to pages: `head` has head and palette of the section, and stays where it is, or all of
 * the section if `is_all`. R21 refuses what does not fit. */
int plt_surface_pages_set(plt_surface_data *d, const plt_section *section,
                          const unsigned char *head, int is_all, uint32_t triangles,
                          plt_fault *fault);

/* The chunk of so many bytes is that of its number, and right: its pages lie in the section, one
 * behind the other. */
int plt_pages_chunk_valid(const plt_surface_pages *p, uint32_t chunk, const unsigned char *bytes);

/* Where a page of a chunk begins, and ends, in bytes from the section on. */
static inline uint32_t plt_pages_offset(const unsigned char *chunk, uint32_t page) {
    return plt_get_u32(chunk + 4 + 4 * (page % PLT_PAGES_IN_CHUNK));
}

static inline uint32_t plt_pages_end(const unsigned char *chunk, uint32_t page) {
    return plt_get_u32(chunk + 8 + 4 * (page % PLT_PAGES_IN_CHUNK));
}

/* The page is that of its number, and right: its tables fill it. */
int plt_surface_page_valid(const plt_surface_data *d, uint32_t page, const unsigned char *bytes,
                           uint32_t count);

/* Sets `view` to the tables of a page that is valid, where its bytes are. */
void plt_surface_page_view(plt_surface_data *view, const plt_surface_data *d,
                           const unsigned char *bytes);

/* Of a section that is there as a whole: checks pages from `first` on, so many of them, with their
 * chunks, and behind the last one what fills the section up. PLT_OK, or PLT_ERR_IMAGE: I31. */
int plt_surface_pages_validate(const plt_surface_data *d, uint32_t first, uint32_t count,
                               plt_fault *fault);

/* Where a page of it is. */
static inline const unsigned char *plt_surface_page_bytes(const plt_surface_pages *p,
                                                          uint32_t page) {
    return p->resident +
           plt_pages_offset(
               p->resident + p->chunks_at + page / PLT_PAGES_IN_CHUNK * PLT_PAGES_CHUNK, page);
}

#endif
#endif
