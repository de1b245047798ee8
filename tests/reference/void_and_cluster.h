/* void_and_cluster - a matrix of thresholds whose patterns are blue noise
 *
 * Integers only, ties go to the first place: the same matrix on every machine.
 *
 * Source: R. Ulichney, "The void-and-cluster method for dither array generation", 1993.
 *
 * SPDX-License-Identifier: MIT */
#ifndef VOID_AND_CLUSTER_H
#define VOID_AND_CLUSTER_H
#include <stdint.h>
#include <string.h>

enum { VAC_SIDE = 32, VAC_COUNT = VAC_SIDE * VAC_SIDE };

typedef struct vac_pattern {
    uint8_t is_set[VAC_COUNT];
    uint64_t near[VAC_COUNT];          /* sum of the weights of all that is set */
    uint64_t weight[VAC_SIDE / 2 + 1]; /* of one axis, by distance; products of two are weights */
} vac_pattern;

/* A Gaussian with a deviation of 1.5 places: exp(-d^2 / 4.5) times 2^20. */
static inline void vac_weights(vac_pattern *p) {
    const uint64_t one = 839634; /* exp(-1 / 4.5) times 2^20 */
    for (unsigned d = 0; d <= VAC_SIDE / 2; d++) {
        p->weight[d] = 1 << 20;
        for (unsigned i = 0; i < d * d; i++) {
            p->weight[d] = p->weight[d] * one >> 20;
        }
    }
}

static inline unsigned vac_distance(unsigned a, unsigned b) {
    const unsigned d = a < b ? b - a : a - b;
    return d < VAC_SIDE - d ? d : VAC_SIDE - d;
}

static inline void vac_change(vac_pattern *p, unsigned place, int set) {
    p->is_set[place] = (uint8_t)set;
    for (unsigned i = 0; i < VAC_COUNT; i++) {
        const uint64_t w = p->weight[vac_distance(i % VAC_SIDE, place % VAC_SIDE)] *
                           p->weight[vac_distance(i / VAC_SIDE, place / VAC_SIDE)];
        p->near[i] = set ? p->near[i] + w : p->near[i] - w;
    }
}

/* Of what is set the place with most around it; of what is not, that with least. */
static inline unsigned vac_cluster(const vac_pattern *p) {
    unsigned best = VAC_COUNT;
    for (unsigned i = 0; i < VAC_COUNT; i++) {
        best = p->is_set[i] && (best == VAC_COUNT || p->near[i] > p->near[best]) ? i : best;
    }
    return best;
}

static inline unsigned vac_void(const vac_pattern *p) {
    unsigned best = VAC_COUNT;
    for (unsigned i = 0; i < VAC_COUNT; i++) {
        best = !p->is_set[i] && (best == VAC_COUNT || p->near[i] < p->near[best]) ? i : best;
    }
    return best;
}

/* A tenth is set at random, and then evened out until nothing moves any more. */
static inline unsigned vac_begin(vac_pattern *p) {
    uint32_t seed = 1;
    unsigned count = 0;
    memset(p, 0, sizeof *p);
    vac_weights(p);
    while (count < VAC_COUNT / 10) {
        seed = seed * 1664525u + 1013904223u;
        if (!p->is_set[seed >> 22]) {
            vac_change(p, seed >> 22, 1);
            count++;
        }
    }
    for (;;) {
        const unsigned from = vac_cluster(p);
        vac_change(p, from, 0);
        const unsigned to = vac_void(p);
        vac_change(p, to, 1);
        if (from == to) {
            return count;
        }
    }
}

/* Ranks 0 .. VAC_COUNT - 1, row by row: the first `n` of them are a pattern as even as can be, for
 * every n. */
static inline void vac_ranks(uint16_t ranks[VAC_COUNT]) {
    vac_pattern first, p;
    const unsigned count = vac_begin(&first);
    p = first;
    for (unsigned rank = count; rank-- > 0;) {
        const unsigned place = vac_cluster(&p);
        ranks[place] = (uint16_t)rank;
        vac_change(&p, place, 0);
    }
    p = first;
    for (unsigned rank = count; rank < VAC_COUNT; rank++) {
        const unsigned place = vac_void(&p);
        ranks[place] = (uint16_t)rank;
        vac_change(&p, place, 1);
    }
}

#endif
