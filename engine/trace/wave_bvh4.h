/* wave_bvh4 - the wave over the wide form of a tree
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WAVE_BVH4_H
#define PLT_TRACE_WAVE_BVH4_H

#include "engine/trace/wave_state.h"

/* Traces all rays of a job; the scene has a wide form. */
void plt_wave_bvh4(plt_wave_job *job);

#endif
