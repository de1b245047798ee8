/* counted - what the thesis counts of packets, of the engine: --counts of render and trace
 *
 * Rays go through the engine once more, by a traversal that counts (baselines/counted), so that
 * neither times nor other counts have a share of that. Hits must be the same.
 *
 * SPDX-License-Identifier: MIT */
#ifndef COUNTED_H
#define COUNTED_H

#include "host_tools/app/args.h"
#include "host_tools/base/output.h"
#include "host_tools/baselines/counted/counted_engine.h"

#define COUNTED_FLAG                                                                               \
    {                                                                                              \
        "--counts", NULL,                                                                          \
            "with --json, how often packets were held against nodes and triangles, as the thesis " \
            "counts, for which rays are traced once more; structures of --baseline count anyway"   \
    }

typedef struct counted {
    int is_wanted;
    counted_engine *engine; /* NULL: nothing is counted */
} counted;

void counted_read(counted *c, args *a);

/* Where they are wanted, of an engine that stays open. -1: it cannot be, or no memory. */
int counted_start(counted *c, plt_engine *engine, const char *name, fail *f);
void counted_end(counted *c);

/* Rays whose hits are known; a frame. They add to what is counted. -1: no memory, or other hits. */
int counted_rays(counted *c, const plt_ray *rays, const plt_hit *hits, uint32_t count, int any,
                 fail *f);
int counted_frame(counted *c, const plt_frame *frame, fail *f);

/* Members of JSON behind others, if there are any. */
int counted_print(const counted *c, output *o, fail *f);

#endif
