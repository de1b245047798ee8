/* wanted - see wanted.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/memory/wanted.h"

uint16_t plt_fetcher_take(plt_fetcher *f, const plt_wanted *w) {
    const uint64_t before = f->store.given_up;
    const uint16_t part = plt_store_take(&f->store, w->key, plt_wanted_bytes(w));
    f->stats->store_evictions += f->store.given_up - before;
    if (part != PLT_STORE_NONE) {
        f->stats->treelet_fetches += w->is_treelet;
        f->store.part[part].serial = ++f->serial;
        f->store.part[part].fresh = 1;
    }
    return part;
}
