/* prefetch - see prefetch.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/memory/prefetch.h"

#if PLT_WITH_PREFETCH

#include "engine/memory/traffic.h"

/* plt_fetch has the tags before. */
enum { FIRST_TAG = 2 };

void plt_prefetch_begin(plt_fetcher *f, unsigned parts) {
    f->ahead = (uint8_t)(f->source->mapped == NULL ? parts : 0);
    for (unsigned i = 0; i < PLT_PREFETCH_MOST; i++) {
        f->coming[i] = PLT_STORE_NONE;
    }
}

static void forget(plt_fetcher *f, uint16_t part) {
    f->stats->fetch_retries++;
    plt_store_forget(&f->store, part);
}

/* Waits for slot `i`; 0: what was to come has failed. */
static int end_slot(plt_fetcher *f, unsigned i) {
    const uint16_t part = f->coming[i];
    f->coming[i] = PLT_STORE_NONE;
    const int status = f->source->wait(f->source->context, 1u << (FIRST_TAG + i));
    f->store.part[part].held = 0;
    if (status < 0) {
        forget(f, part);
    }
    return status >= 0;
}

/* A slot that is free: the one that has waited longest ends, if there is none. */
static unsigned free_slot(plt_fetcher *f) {
    unsigned oldest = 0;
    for (unsigned i = 0; i < f->ahead; i++) {
        if (f->coming[i] == PLT_STORE_NONE) {
            return i;
        }
        const uint32_t serial = f->store.part[f->coming[i]].serial;
        /* Serial numbers may go around: what matters is which is further back. */
        oldest =
            f->serial - serial > f->serial - f->store.part[f->coming[oldest]].serial ? i : oldest;
    }
    end_slot(f, oldest);
    return oldest;
}

/* Bytes from `offset` on, in as many transfers as they take. 0: one did not start. */
static int start_some(const plt_fetcher *f, uint32_t offset, unsigned char *to, uint32_t count,
                      unsigned tag) {
    const plt_source *source = f->source;
    int status = 0;
    for (uint32_t done = 0; done < count && status >= 0; done += PLT_TRANSFER_BYTES) {
        const uint32_t left = count - done;
        const uint32_t now = left < PLT_TRANSFER_BYTES ? left : PLT_TRANSFER_BYTES;
        status = source->start(source->context, tag, offset + done, to + done, now);
    }
    return status >= 0;
}

/* All transfers of the part under one tag. */
static int start(const plt_fetcher *f, const plt_wanted *w, unsigned char *to, unsigned tag) {
    const int begun = start_some(f, w->offset, to, w->count, tag);
#if PLT_WITH_THESIS
    return begun && start_some(f, w->beside_at, to + w->count, w->beside, tag);
#else
    return begun;
#endif
}

static uint32_t transfers_of(uint32_t count) {
    return count / PLT_TRANSFER_BYTES + (count % PLT_TRANSFER_BYTES != 0);
}

/* One that would take more than a quarter of the store takes too much from what is there. */
static int is_too_large(const plt_fetcher *f, const plt_wanted *w) {
    uint32_t transfers = transfers_of(w->count);
#if PLT_WITH_THESIS
    transfers += transfers_of(w->beside);
#endif
    return transfers > PLT_PREFETCH_TRANSFERS || plt_wanted_bytes(w) > f->store.bytes / 4;
}

void plt_prefetch_ask(plt_fetcher *f, const plt_wanted *w) {
    if (f->ahead == 0 || is_too_large(f, w) ||
        plt_store_find(&f->store, w->key) != PLT_STORE_NONE) {
        return;
    }
    const unsigned i = free_slot(f);
    const uint16_t part = plt_fetcher_take(f, w);
    if (part == PLT_STORE_NONE) {
        return;
    }
    f->store.part[part].held = 1;
    f->coming[i] = part;
    plt_traffic_count(f->stats, f->touched, w->bit, plt_wanted_bytes(w));
    if (!start(f, w, plt_store_bytes(&f->store, part), FIRST_TAG + i) && end_slot(f, i)) {
        forget(f, part);
    }
}

/* Its first use is what it came for, and not a reason to keep it. */
int plt_prefetch_arrive(plt_fetcher *f, uint16_t part) {
    f->store.part[part].found = 0;
    for (unsigned i = 0; i < f->ahead; i++) {
        if (f->coming[i] == part) {
            return end_slot(f, i);
        }
    }
    return 1;
}

void plt_prefetch_end(plt_fetcher *f) {
    for (unsigned i = 0; i < f->ahead; i++) {
        if (f->coming[i] != PLT_STORE_NONE) {
            end_slot(f, i);
        }
    }
}

#endif
