/* wave_compact - the wave over compact blocks
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WAVE_COMPACT_H
#define PLT_TRACE_WAVE_COMPACT_H

#include "engine/trace/wave_state.h"

/* Traces all rays of a job; the scene has compact blocks. */
void plt_wave_compact(plt_wave_job *job);

#endif
