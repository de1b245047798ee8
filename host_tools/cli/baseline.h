/* baseline - rays through a structure of host_tools/baselines instead of the engine's
 *
 * Hits are the same, bit for bit.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINE_H
#define BASELINE_H

#include "engine/planelet.h"
#include "host_tools/base/output.h"
#include "host_tools/baselines/structure.h"

/* The names of those that trace takes; NULL ends them. */
extern const char *const baseline_names[];

typedef struct baseline {
    built_structure *s;   /* NULL: there is none */
    double build_seconds; /* of the processor */
    double seconds;       /* likewise, of the best run */
    uint32_t rays;
} baseline;

/* Of the triangles of an engine that is open with float records. -1: it has none, or no memory. */
int baseline_open(baseline *b, unsigned which, const plt_engine *engine, const char *name, fail *f);
void baseline_close(baseline *b);

/* The best of `repeat` runs; counts are of the last. */
int baseline_trace(baseline *b, const plt_ray *rays, plt_hit *hits, uint32_t count, int any,
                   unsigned repeat, fail *f);

/* An object of JSON. */
int baseline_print(const baseline *b, output *o, fail *f);

#endif
