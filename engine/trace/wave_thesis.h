/* wave_thesis - the wave over thesis nodes
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WAVE_THESIS_H
#define PLT_TRACE_WAVE_THESIS_H

#include "engine/trace/wave_state.h"

/* Traces all rays of a job; the scene has thesis nodes. */
void plt_wave_thesis(plt_wave_job *job);

#endif
