/* shares - see shares.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/shares.h"

typedef struct range {
    uint32_t first, end;
} range;

static uint64_t word_of(range r) {
    return (uint64_t)r.first << 32 | r.end;
}

static range range_of(uint64_t word) {
    const range r = {(uint32_t)(word >> 32), (uint32_t)word};
    return r;
}

static uint32_t least(uint32_t a, uint32_t b) {
    return a < b ? a : b;
}

void shares_split(shares *s, uint32_t items, uint32_t run, unsigned count) {
    const uint64_t runs = items / run + (items % run > 0);
    s->run = run;
    s->count = count;
    atomic_init(&s->end, items);
    for (unsigned i = 0; i < count; i++) {
        const uint64_t first = runs * i / count * run, end = runs * (i + 1) / count * run;
        const range r = {(uint32_t)first, end < items ? (uint32_t)end : items};
        atomic_init(&s->left[i], word_of(r));
    }
}

/* What is left of a share, without what is not handed out. */
static range look(shares *s, unsigned who, uint64_t *word) {
    const uint32_t end = (uint32_t)atomic_load_explicit(&s->end, memory_order_relaxed);
    *word = atomic_load_explicit(&s->left[who], memory_order_relaxed);
    range r = range_of(*word);
    r.end = least(r.end, end);
    return r;
}

/* Puts `r` where `word` was; 0: that is not there any more. */
static int change(shares *s, unsigned who, uint64_t word, range r) {
    uint_fast64_t expected = word;
    return atomic_compare_exchange_strong_explicit(&s->left[who], &expected, word_of(r),
                                                   memory_order_relaxed, memory_order_relaxed);
}

static unsigned find_largest(shares *s) {
    unsigned largest = 0;
    uint32_t most = 0;
    for (unsigned i = 0; i < s->count; i++) {
        uint64_t word;
        const range r = look(s, i, &word);
        if (r.first < r.end && r.end - r.first > most) {
            most = r.end - r.first;
            largest = i;
        }
    }
    return largest;
}

/* Takes the back half of the largest share, which may be a single run, for `who`, whose own is
 * empty. 0: all are empty. Between the two changes nobody sees what was taken: a third
 * worker may end too early, but no item is lost. */
static int steal(shares *s, unsigned who) {
    for (;;) {
        uint64_t word;
        const unsigned from = find_largest(s);
        const range r = look(s, from, &word);
        if (r.first >= r.end) {
            return 0;
        }
        const uint32_t runs = (r.end - r.first - 1) / s->run + 1;
        const range kept = {r.first, r.first + runs / 2 * s->run};
        const range taken = {kept.end, r.end};
        if (change(s, from, word, kept)) {
            atomic_store_explicit(&s->left[who], word_of(taken), memory_order_relaxed);
            return 1;
        }
    }
}

uint32_t shares_take(shares *s, unsigned who, uint32_t *first) {
    do {
        uint64_t word;
        range r = look(s, who, &word);
        while (r.first < r.end) {
            const uint32_t count = least(s->run, r.end - r.first);
            const range rest = {r.first + count, range_of(word).end};
            if (change(s, who, word, rest)) {
                *first = r.first;
                return count;
            }
            r = look(s, who, &word);
        }
    } while (steal(s, who));
    return 0;
}

void shares_end(shares *s, uint32_t item) {
    uint_fast32_t end = atomic_load_explicit(&s->end, memory_order_relaxed);
    while (item < end && !atomic_compare_exchange_weak_explicit(
                             &s->end, &end, item, memory_order_relaxed, memory_order_relaxed)) {
    }
}
