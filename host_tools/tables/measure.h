/* measure - one structure on a stage: what it takes, what packets meet in it, how long that is
 *
 * A job is a text: "size:KIND:SWITCHES" is a structure without rays, "trace:KIND:SWITCHES" one with
 * (baselines/structure.h); "pack:" and "slots:" are of thesis nodes
 * (measure_nodes.h).
 *
 * SPDX-License-Identifier: MIT */
#ifndef MEASURE_H
#define MEASURE_H

#include "host_tools/base/counters.h"
#include "host_tools/tables/figures.h"
#include "host_tools/tables/stage.h"

enum { MEASURE_RACERS = 3 };

typedef struct meter {
    stage_options look;
    counters counters;
    unsigned rounds; /* of a race, 1 and up */
} meter;

/* All NaN. */
figures figures_none(void);

int measure_job(meter *m, stage *s, const char *job, figures *to, fail *f);

/* Structures in turn, round after round, the best time of each. Hits must be the same: -1 and `f`
 * says so, if not. */
int measure_race(meter *m, stage *s, const char *const texts[MEASURE_RACERS],
                 figures to[MEASURE_RACERS], fail *f);

/* A race in which the scene moves: `frame` makes step `step` of `steps`; times are sums over all
 * steps. Rays are those of the stage, whose mesh is step 0. */
typedef struct measure_motion {
    unsigned steps;
    int (*frame)(void *context, unsigned step, mesh *m, fail *f);
    void *context;
} measure_motion;

int measure_moving_race(meter *m, stage *s, const measure_motion *motion,
                        const char *const texts[MEASURE_RACERS], figures to[MEASURE_RACERS],
                        fail *f);

#endif
