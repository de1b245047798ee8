/* racers - structures that trace the same rays in turn, so that what else the machine does meets
 * all
 *
 * SPDX-License-Identifier: MIT */
#ifndef RACERS_H
#define RACERS_H

#include "host_tools/base/counters.h"
#include "host_tools/baselines/structure.h"
#include "host_tools/tables/stage.h"

enum { RACERS_MOST = TURNS_SIDES };

typedef struct racer_time {
    double rays, hits, seconds, cycles; /* of the best round, summed over all runs; cycles may be
                                         * NaN */
} racer_time;

typedef struct racer {
    const char *name;
    built_structure *s;
    racer_time sum;
} racer;

typedef struct racers {
    racer racer[RACERS_MOST];
    unsigned count;
} racers;

/* `text` is of structure_read. */
int racers_add(racers *all, const char *text, const mesh *m, const char *name, fail *f);
void racers_close(racers *all);

/* All structures move to the frame. */
int racers_move(racers *all, const mesh *m, fail *f);

/* Each traces the stage's rays `rounds` times. -1 also when their hits differ. */
int racers_run(racers *all, stage *s, unsigned rounds, counters *c, fail *f);

#endif
