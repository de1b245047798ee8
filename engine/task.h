/* task - a frame, or an array of rays, by tasks
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TASK_H
#define PLT_TASK_H

#include "engine/engine.h"

/* plt_render_step and plt_trace of a dispatcher that is its own worker. */
int plt_task_step(plt_engine *e, uint32_t visits);
int plt_task_trace(plt_engine *e, const plt_ray *rays, plt_hit *hits, uint32_t count, int any);

/* Drops what is under way. */
void plt_task_drop(plt_engine *e);

#endif
