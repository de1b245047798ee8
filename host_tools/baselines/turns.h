/* turns - structures that trace the same rays in turn, by the clock
 *
 * In a round each traces all rays once; what else the machine does meets all alike. Rays go in
 * batches, and may be made batch by batch, so that it does not take room to have many. Times are of
 * the processor, in the structure alone. Hits of the first pass must be the same, bit for bit.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_TURNS_H
#define BASELINES_TURNS_H

#include "host_tools/base/counters.h"
#include "host_tools/base/progress.h"
#include "host_tools/baselines/structure.h"

enum {
    TURNS_SIDES = 4,
    TURNS_ROUNDS_MOST = 1000,
    TURNS_BATCH = 65536 /* rays; a whole number of packets of every size */
};

/* Rays `first` to `first + count` - 1, at most TURNS_BATCH, until it is called again. */
typedef struct turns_rays {
    const plt_ray *(*at)(void *context, uint64_t first, uint32_t count);
    void *context;
    uint64_t count;
} turns_rays;

/* Those that lie one behind the other in memory. */
turns_rays turns_rays_of(const plt_ray *rays, uint32_t count);

typedef struct turns_side {
    const char *name; /* for errors */
    built_structure *s;
    /* Of the first pass: rays that hit something, a hash of all hits, what was counted. */
    uint64_t hits, hash;
    structure_statistics counts;
    /* By the clock. */
    double seconds[TURNS_ROUNDS_MOST]; /* of each round, above 0 */
    double best;                       /* the least of them */
    double best_cycles;                /* of that round; NaN where they are not granted */
    uint64_t counted[COUNTERS];        /* of all rounds together */
} turns_side;

typedef struct turns {
    turns_side side[TURNS_SIDES];
    unsigned sides, rounds; /* 1 to TURNS_SIDES, to TURNS_ROUNDS_MOST; 0: by no clock at all */
    int is_tried;           /* 1: a pass of each by no clock comes before the rounds */
    int any;                /* as plt_trace's */
    turns_rays rays;
    const char *scene, *kind; /* for errors: whose rays, which rays */
    counters *counters;       /* NULL: nothing is counted */
    progress *bar;            /* NULL: nobody looks on */
    uint64_t passes;          /* that are done; of the bar */
} turns;

/* Fills what came of each side. -1: no memory, or hits that differ. */
int turns_run(turns *t, fail *f);

/* The middle one of `count` values, or half way between the two; they are sorted. */
double turns_median(double *values, unsigned count);

#endif
