/* counted_engine - an engine that is open, its packets counted as the thesis counts them
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_COUNTED_ENGINE_H
#define BASELINES_COUNTED_ENGINE_H

#include "engine/planelet.h"
#include "host_tools/base/fail.h"
#include "host_tools/baselines/base/structure_types.h"

typedef struct counted_engine counted_engine;

/* Of an engine that has resident thesis nodes, and stays open; it is used while rays are counted,
 * and between two of its own calls. `name` is for errors. NULL: it has none, or no memory. */
counted_engine *counted_engine_open(plt_engine *engine, const char *name, fail *f);
void counted_engine_close(counted_engine *e); /* NULL is allowed */

/* All rays in packets of the engine's side, as plt_trace has them without a wave, with its hits.
 * -1: no memory. */
int counted_engine_trace(counted_engine *e, const plt_ray *rays, plt_hit *hits, uint32_t count,
                         int any, fail *f);

/* The packets of a frame, as plt_render_step has them; where that has beams, as it would without.
 * -1: no memory, or a camera that the engine does not take. */
int counted_engine_frame(counted_engine *e, const plt_frame *frame, fail *f);

/* Since it was opened: of packets, and the engine's own visits and tests. */
structure_statistics counted_engine_count(const counted_engine *e);

#endif
