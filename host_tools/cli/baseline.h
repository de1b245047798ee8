/* baseline - rays through a structure of host_tools/baselines instead of the engine's
 *
 * Hits are the same, bit for bit.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINE_H
#define BASELINE_H

#include "engine/planelet.h"
#include "engine/scene/scene.h"
#include "host_tools/app/args.h"
#include "host_tools/base/output.h"
#include "host_tools/baselines/structure.h"

/* The flag, and what a help says behind all flags. */
#define BASELINE_FLAG                                                                              \
    {                                                                                              \
        "--baseline", "NAME[:SWITCH,...]",                                                         \
            "through a structure of the scene's triangles instead, as listed below; hits are the " \
            "same"                                                                                 \
    }
void baseline_print_notes(FILE *to);

typedef struct baseline {
    const structure_kind *kind; /* NULL: it was not asked for */
    structure_options options;
    built_structure *s;   /* NULL: there is none */
    double build_seconds; /* of the processor */
    double seconds;       /* likewise, of the best run */
    uint32_t rays;
} baseline;

/* Reads the flag; `others` are flags that do not go with it, NULL ends them. */
void baseline_read(baseline *b, args *a, const char *const *others);

/* Of the triangles of an engine that is open with float records. -1: it has none, or no memory. */
int baseline_open(baseline *b, const plt_engine *engine, const char *name, fail *f);
void baseline_close(baseline *b);

/* The float records of a scene; NULL: it has others, or none. */
const plt_record *baseline_records(const plt_scene *scene);

/* The best of `repeat` runs; counts are of the last. */
int baseline_trace(baseline *b, const plt_ray *rays, plt_hit *hits, uint32_t count, int any,
                   unsigned repeat, fail *f);

/* An object of JSON; or its members alone: what was traced, by the clock; what was counted. */
int baseline_print(const baseline *b, output *o, fail *f);
void baseline_print_rays(output *o, uint64_t rays, double seconds, fail *f);
int baseline_print_counts(const baseline *b, output *o, fail *f);

/* Members alone: what the thesis counts of packets (structure_types.h); the last has no comma. */
int baseline_print_intersections(const structure_statistics *s, output *o, fail *f);

#endif
