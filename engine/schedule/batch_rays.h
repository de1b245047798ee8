/* batch_rays - arrays of rays, many packets at a time
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCHEDULE_BATCH_RAYS_H
#define PLT_SCHEDULE_BATCH_RAYS_H

#include "engine/schedule/batch.h"

/* Traces any number of rays, in packets of `most`, batch->most of them at a time. PLT_OK, or
 * what a fetch failed with: then hits from that batch on are as they were. */
int plt_batch_trace_rays(plt_batch *batch, plt_traversal *t, uint32_t most, const plt_ray *rays,
                         plt_hit *hits, uint32_t count, int any);

#endif
