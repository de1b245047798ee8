/* page_fetch - see page_fetch.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/surface/page_fetch.h"

#if PLT_WITH_PAGES

#include "engine/base/fault.h"
#include "engine/base/rules.h"

/* Names in the store: blocks and treelets have those below. */
enum { KEY_PAGES = 0x40000000, KEY_CHUNKS = 0x60000000 };

/* A page or chunk that is needed. */
typedef struct part_of {
    plt_fetcher *fetcher;
    const plt_surface_data *data;
    uint32_t number, offset, count; /* offset: from the section on */
} part_of;

static int refuse(const part_of *a, const char *message) {
    return plt_broken(&a->fetcher->fault, PLT_I31_PAGES, a->data->pages.at + a->offset, message);
}

static int check_chunk(const void *context, uint16_t part) {
    const part_of *a = context;
    return plt_pages_chunk_valid(&a->data->pages, a->number,
                                 plt_store_bytes(&a->fetcher->store, part))
               ? PLT_OK
               : refuse(a, PLT_PAGES_CHUNK_DAMAGED);
}

static int check_page(const void *context, uint16_t part) {
    const part_of *a = context;
    return plt_surface_page_valid(a->data, a->number, plt_store_bytes(&a->fetcher->store, part),
                                  a->count)
               ? PLT_OK
               : refuse(a, PLT_PAGES_PAGE_DAMAGED);
}

static int need(const part_of *a, plt_wanted *w, const unsigned char **bytes) {
    plt_found found;
    w->offset = a->data->pages.at + a->offset;
    w->count = a->count;
    w->context = a;
    const int status = plt_fetcher_need(a->fetcher, w, &found);
    if (status == PLT_OK) {
        *bytes = plt_fetcher_bytes(a->fetcher, &found);
    }
    return status;
}

int plt_page_fetch(plt_fetcher *f, const plt_surface_data *d, uint32_t bit, uint32_t page,
                   plt_surface_data *view) {
    const plt_surface_pages *p = &d->pages;
    const uint32_t number = page / PLT_PAGES_IN_CHUNK;
    const unsigned char *bytes = NULL;
    const part_of chunk = {f, d, number, p->chunks_at + number * PLT_PAGES_CHUNK, PLT_PAGES_CHUNK};
    plt_wanted of_chunk = {
        .key = KEY_CHUNKS + number, .bit = bit + p->pages + number, .check = check_chunk};
    int status = need(&chunk, &of_chunk, &bytes);
    if (status != PLT_OK) {
        return status;
    }
    const uint32_t at = plt_pages_offset(bytes, page), end = plt_pages_end(bytes, page);
    const part_of one = {f, d, page, at, end - at};
    plt_wanted of_page = {.key = KEY_PAGES + page, .bit = bit + page, .check = check_page};
    status = need(&one, &of_page, &bytes);
    if (status == PLT_OK) {
        plt_surface_page_view(view, d, bytes);
    }
    return status;
}

#endif
