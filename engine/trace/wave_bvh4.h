/* wave_bvh4 - the wave over the wide form of a tree
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WAVE_BVH4_H
#define PLT_TRACE_WAVE_BVH4_H

#include "engine/trace/wave_state.h"

/* Goes on with the rays of a job. PLT_OK: all are traced; PLT_MORE: its visits are made, and what
 * is on the lists waits in the wave. The scene has a wide form. */
int plt_wave_bvh4(plt_wave_job *job);

#endif
