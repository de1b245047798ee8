/* fetcher - see fetcher.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/memory/fetcher.h"

#include "engine/base/fault.h"
#include "engine/image/fetch.h"
#include "engine/memory/traffic.h"

void plt_fetcher_init(plt_fetcher *f, void *memory, uint32_t bytes) {
    plt_store_init(&f->store, memory, bytes);
    f->serial = 0;
    plt_fault_set(&f->fault, PLT_OK, 0, "no fault");
}

/* Once: PLT_OK, or why it did not come or is not valid. */
static int fetch_once(plt_fetcher *f, const plt_wanted *w, uint16_t part) {
    const int status =
        plt_fetch(f->source, w->offset, plt_store_bytes(&f->store, part), w->count, &f->fault);
    plt_traffic_count(f->stats, f->touched, w->bit, w->count);
    return status == PLT_OK ? w->check(w->context, part) : status;
}

static int fetch_part(plt_fetcher *f, const plt_wanted *w, uint16_t *part) {
    const uint64_t before = f->store.given_up;
    int status = PLT_OK;
    *part = plt_store_take(&f->store, w->key, w->count);
    if (*part == PLT_STORE_NONE) {
        return plt_limit(&f->fault, "the parts of a block do not fit the store together");
    }
    f->stats->store_evictions += f->store.given_up - before;
    f->stats->treelet_fetches += w->is_treelet;
    f->store.part[*part].serial = ++f->serial;
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
static int is_valid(const plt_fetcher *f, const plt_wanted *w, uint16_t part) {
    const plt_store_part *p = &f->store.part[part];
    return p->bytes == plt_store_rounded(w->count) &&
           (p->against == w->against || w->check(w->context, part) == PLT_OK);
}

int plt_fetcher_need(plt_fetcher *f, const plt_wanted *w, plt_found *found) {
    uint16_t part = plt_store_find(&f->store, w->key);
    int status = PLT_OK;
    if (part != PLT_STORE_NONE && !is_valid(f, w, part)) {
        plt_store_forget(&f->store, part);
        part = PLT_STORE_NONE;
    }
    if (part == PLT_STORE_NONE) {
        status = fetch_part(f, w, &part);
    }
    found->part = PLT_STORE_NONE;
    if (status == PLT_OK) {
        f->store.part[part].against = w->against;
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
