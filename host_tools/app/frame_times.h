/* frame_times - what each frame of a scene in motion took, in parts
 *
 * SPDX-License-Identifier: MIT */
#ifndef FRAME_TIMES_H
#define FRAME_TIMES_H

#include "host_tools/base/fail.h"
#include "host_tools/base/output.h"

/* Seconds of the processor. */
typedef struct frame_time {
    double move;    /* records and refit, or the grid; with the image's frames reading, too */
    double rebuild; /* steps of a new tree */
    double trace;   /* of the worker that took longest, as crew_times.seconds */
} frame_time;

typedef struct frame_times {
    unsigned frames; /* 0: nobody wants to know */
    frame_time *at;
} frame_times;

int frame_times_make(frame_times *t, unsigned frames, fail *f);
void frame_times_free(frame_times *t);

/* Of all up to now, before frame `index` and behind it: keeps the difference, of several runs the
 * least of each part. */
void frame_times_keep(frame_times *t, unsigned index, const frame_time *before,
                      const frame_time *behind, int is_first_run);

/* JSON members, each ending in ",\n". `moves`: also what it took before rays. */
void frame_times_print(output *o, const frame_times *t, int moves, fail *f);

#endif
