/* fetcher - see fetcher.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/memory/fetcher.h"

#include "engine/base/fault.h"
#include "engine/image/fetch.h"
#include "engine/memory/prefetch.h"
#include "engine/memory/traffic.h"

void plt_fetcher_init(plt_fetcher *f, void *memory, uint32_t bytes) {
    plt_store_init(&f->store, memory, bytes);
    f->serial = 0;
#if PLT_WITH_PREFETCH
    f->ahead = 0;
#endif
    plt_fault_set(&f->fault, PLT_OK, 0, "no fault");
}

static int check(plt_fetcher *f, const plt_wanted *w, uint16_t part) {
    const int status = w->check(w->context, part); /* and may ask for other parts */
    f->stats->bytes_validated += plt_wanted_bytes(w);
    return status;
}

/* Once: PLT_OK, or why it did not come or is not valid. */
static int fetch_once(plt_fetcher *f, const plt_wanted *w, uint16_t part) {
    unsigned char *to = plt_store_bytes(&f->store, part);
    int status = plt_fetch(f->source, w->offset, to, w->count, &f->fault);
#if PLT_WITH_THESIS
    if (status == PLT_OK && w->beside > 0) {
        status = plt_fetch(f->source, w->beside_at, to + w->count, w->beside, &f->fault);
    }
#endif
    plt_traffic_count(f->stats, f->touched, w->bit, plt_wanted_bytes(w));
    return status == PLT_OK ? check(f, w, part) : status;
}

/* Parts that are on their way are held, and may be what leaves no room. */
static uint16_t take_for_sure(plt_fetcher *f, const plt_wanted *w) {
    const uint16_t part = plt_fetcher_take(f, w);
    if (part != PLT_STORE_NONE) {
        return part;
    }
    plt_prefetch_end(f);
    return plt_fetcher_take(f, w);
}

static int fetch_part(plt_fetcher *f, const plt_wanted *w, uint16_t *part) {
    int status = PLT_OK;
    *part = take_for_sure(f, w);
    if (*part == PLT_STORE_NONE) {
        return plt_limit(&f->fault, "the parts of a block do not fit the store together");
    }
    for (unsigned tries = 0; tries < PLT_FETCH_TRIES; tries++) {
        f->stats->fetch_retries += tries > 0;
        status = fetch_once(f, w, *part);
        if (status == PLT_OK) {
            return PLT_OK;
        }
    }
    plt_store_forget(&f->store, *part);
    return status;
}

/* It is as long as it shall be, and valid. What it is validated against may have come anew, from
 * a source that has changed: then it is validated again. */
static int is_valid(plt_fetcher *f, const plt_wanted *w, uint16_t part) {
    const plt_store_part *p = &f->store.part[part];
    return p->bytes == plt_store_rounded(plt_wanted_bytes(w)) &&
           ((!p->fresh && p->against == w->against) || check(f, w, part) == PLT_OK);
}

/* The part, if it is in the store, or on its way to it, and is valid. */
static uint16_t find_part(plt_fetcher *f, const plt_wanted *w) {
    const uint16_t part = plt_store_find(&f->store, w->key);
    if (part == PLT_STORE_NONE || (f->store.part[part].fresh && !plt_prefetch_arrive(f, part))) {
        return PLT_STORE_NONE;
    }
    if (is_valid(f, w, part)) {
        return part;
    }
    f->stats->fetch_retries += f->store.part[part].fresh;
    plt_store_forget(&f->store, part);
    return PLT_STORE_NONE;
}

int plt_fetcher_need(plt_fetcher *f, const plt_wanted *w, plt_found *found) {
    uint16_t part = find_part(f, w);
    int status = PLT_OK;
    if (part == PLT_STORE_NONE) {
        status = fetch_part(f, w, &part);
    }
    found->part = PLT_STORE_NONE;
    if (status == PLT_OK) {
        f->store.part[part].against = w->against;
        f->store.part[part].fresh = 0;
        found->part = part;
        found->at = f->store.part[part].at;
        found->serial = f->store.part[part].serial;
    }
    return status;
}

int plt_fetcher_has(plt_fetcher *f, uint32_t key, const plt_found *found) {
    if (found->part == PLT_STORE_NONE) {
        return 0;
    }
    plt_store_part *p = &f->store.part[found->part];
    const int there = p->key == key && p->at == found->at && p->serial == found->serial;
    p->found |= (uint8_t)there;
    return there;
}
