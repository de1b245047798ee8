/* bph_packet - up to 16x16 rays, side by side, and sets of them
 *
 * Rays that hit nothing whatever there is are not in it. A ray's interval begins at its tmin and
 * ends at its nearest hit so far; of one that wants no more it is empty.
 *
 * Source: Karrenberg 2007, sections 3.5.1 to 3.5.3.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_BPH_PACKET_H
#define BASELINES_BPH_PACKET_H

#include <string.h>

#include "host_tools/baselines/base/lone_ray.h"

enum { BPH_SIDE = 16, BPH_RAYS = BPH_SIDE * BPH_SIDE, BPH_WORDS = BPH_RAYS / 64 };

typedef struct bph_set {
    uint64_t word[BPH_WORDS];
} bph_set;

/* What the rays have between them on an axis: the hull of their origins and rates. */
typedef struct bph_hull_axis {
    float early[2], late[2], rdir[2]; /* least, greatest */
} bph_hull_axis;

typedef struct bph_packet {
    lone_ray ray[BPH_RAYS];
    uint32_t count;
    float early[3][BPH_RAYS], late[3][BPH_RAYS], rdir[3][BPH_RAYS];
    uint8_t negative[3][BPH_RAYS];
    float tmin[BPH_RAYS], limit[BPH_RAYS]; /* limit: the hit's t, or tmax; -1: it wants no more */
    bph_set open;                          /* rays that want more */
    uint8_t is_equal;                      /* 1: the signs of ray 0 are those of all */
    bph_hull_axis hull[3];                 /* where they are equal */
    float tmin_least, limit_most;
} bph_packet;

/* After rays 0 .. count - 1 are set. */
void bph_packet_begin(bph_packet *p);

/* After hits. */
void bph_packet_shorten(bph_packet *p);

static inline void bph_set_add(bph_set *s, uint32_t ray) {
    s->word[ray / 64] |= 1ull << ray % 64;
}

static inline int bph_set_has(const bph_set *s, uint32_t ray) {
    return (int)(s->word[ray / 64] >> ray % 64 & 1u);
}

static inline bph_set bph_set_both(const bph_set *a, const bph_set *b) {
    bph_set s;
    for (uint32_t w = 0; w < BPH_WORDS; w++) {
        s.word[w] = a->word[w] & b->word[w];
    }
    return s;
}

static inline uint32_t bph_set_count(const bph_set *s) {
    uint32_t n = 0;
    for (uint32_t w = 0; w < BPH_WORDS; w++) {
        n += (uint32_t)__builtin_popcountll(s->word[w]);
    }
    return n;
}

static inline int bph_set_is_empty(const bph_set *s) {
    return (s->word[0] | s->word[1] | s->word[2] | s->word[3]) == 0;
}

/* Of a set that is not empty. */
static inline uint32_t bph_set_first(const bph_set *s) {
    uint32_t w = 0;
    while (s->word[w] == 0) {
        w++;
    }
    return 64 * w + (uint32_t)__builtin_ctzll(s->word[w]);
}

static inline uint32_t bph_set_last(const bph_set *s) {
    uint32_t w = BPH_WORDS - 1;
    while (s->word[w] == 0) {
        w--;
    }
    return 64 * w + 63 - (uint32_t)__builtin_clzll(s->word[w]);
}

/* Rays first .. last. */
static inline bph_set bph_set_range(uint32_t first, uint32_t last) {
    bph_set s = {{0}};
    for (uint32_t i = first; i <= last; i++) {
        bph_set_add(&s, i);
    }
    return s;
}

#endif
