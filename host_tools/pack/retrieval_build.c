/* retrieval_build - see retrieval_build.h
 *
 * Every key is an edge between three entries. An entry that just one key has is that key's to
 * choose: it is taken away, with its key, and so on. With 1.23 entries per key that ends with no
 * key left, for all but one seed in some; then, from the last key taken to the first, the entry
 * that was its own is set so that all three give its value.
 *
 * Source: B. S. Majewski, N. C. Wormald, G. Havas and Z. J. Czech, A Family of Perfect Hashing
 * Methods, 1996.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/retrieval_build.h"

#include "engine/surface/retrieval.h"
#include "host_tools/base/heap.h"

/* Of an entry: how many keys have it, and the exclusive or of their numbers. */
typedef struct degree {
    uint32_t count, keys;
} degree;

enum { SEEDS_MOST = 512 }; /* one in some is enough: of different keys there is no such table */

typedef struct peeling {
    const retrieval_pair *pair;
    size_t pairs;
    uint32_t third, seed;
    degree *at;
    uint32_t *key, *own; /* in the order in which they are taken: keys, and their entries */
    size_t taken;
} peeling;

uint32_t retrieval_third(size_t keys) {
    return keys > 0 ? (uint32_t)((keys * 123 / 100 + 2) / 3 + 4) : 0;
}

static void places_of(const peeling *p, uint32_t key, uint32_t place[3]) {
    plt_retrieval_places(p->third, p->seed, p->pair[key].key, place);
}

static void take(peeling *p, uint32_t entry) {
    uint32_t place[3];
    while (p->at[entry].count == 1) {
        const uint32_t key = p->at[entry].keys;
        uint32_t next = entry;
        p->key[p->taken] = key;
        p->own[p->taken++] = entry;
        places_of(p, key, place);
        for (int i = 0; i < 3; i++) {
            p->at[place[i]].count--;
            p->at[place[i]].keys ^= key;
            /* one before the scan, which would not come back to it */
            next = p->at[place[i]].count == 1 && place[i] < next ? place[i] : next;
        }
        if (next == entry) {
            return;
        }
        entry = next;
    }
}

static int peel(peeling *p) {
    const uint32_t entries = 3 * p->third;
    uint32_t place[3];
    p->taken = 0;
    for (uint32_t i = 0; i < entries; i++) {
        p->at[i] = (degree){0, 0};
    }
    for (size_t k = 0; k < p->pairs; k++) {
        places_of(p, (uint32_t)k, place);
        for (int i = 0; i < 3; i++) {
            p->at[place[i]].count++;
            p->at[place[i]].keys ^= (uint32_t)k;
        }
    }
    size_t before;
    do { /* two or three scans, mostly */
        before = p->taken;
        for (uint32_t i = 0; i < entries; i++) {
            take(p, i);
        }
    } while (p->taken > before && p->taken < p->pairs);
    return p->taken == p->pairs;
}

static void assign(const peeling *p, uint32_t *entry) {
    uint32_t place[3];
    for (size_t i = p->taken; i-- > 0;) {
        places_of(p, p->key[i], place);
        entry[p->own[i]] = 0;
        entry[p->own[i]] =
            p->pair[p->key[i]].value ^ entry[place[0]] ^ entry[place[1]] ^ entry[place[2]];
    }
}

/* Another seed each time, and from the eighth on a larger table. */
static int try_seeds(peeling *p, retrieval_table *t) {
    for (uint32_t seed = 1; !peel(p); seed++) {
        if (seed > SEEDS_MOST) {
            return -1;
        }
        p->seed = seed;
        if (seed % 8 == 0) {
            p->third += p->third / 16 + 1;
            degree *more = heap_resize(p->at, 3 * (uint64_t)p->third * sizeof *more);
            if (more == NULL) {
                return -1;
            }
            p->at = more;
        }
    }
    t->entry = heap_get_zeroed(3 * (uint64_t)p->third * sizeof *t->entry);
    if (t->entry == NULL) {
        return -1;
    }
    t->third = p->third;
    t->seed = p->seed;
    assign(p, t->entry);
    return 0;
}

int retrieval_build(retrieval_table *t, const retrieval_pair *pair, size_t pairs) {
    *t = (retrieval_table){.entry = NULL};
    if (pairs == 0) {
        return 0;
    }
    peeling p = {.pair = pair, .pairs = pairs, .third = retrieval_third(pairs)};
    p.at = heap_get(3 * (uint64_t)p.third * sizeof *p.at);
    p.key = heap_get(4 * (uint64_t)pairs);
    p.own = heap_get(4 * (uint64_t)pairs);
    const int status = p.at == NULL || p.key == NULL || p.own == NULL ? -1 : try_seeds(&p, t);
    heap_drop(p.at);
    heap_drop(p.key);
    heap_drop(p.own);
    return status;
}

void retrieval_free(retrieval_table *t) {
    heap_drop(t->entry);
    *t = (retrieval_table){.entry = NULL};
}
