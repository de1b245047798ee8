/* wave_thesis - the wave over thesis nodes
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WAVE_THESIS_H
#define PLT_TRACE_WAVE_THESIS_H

#include "engine/trace/wave_state.h"

/* Goes on with the rays of a job. PLT_OK: all are traced; PLT_MORE: its visits are made, and what
 * is on the lists waits in the wave. The scene has thesis nodes. */
int plt_wave_thesis(plt_wave_job *job);

#endif
