/* wave_compact - the wave over compact blocks
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WAVE_COMPACT_H
#define PLT_TRACE_WAVE_COMPACT_H

#include "engine/trace/wave_state.h"

/* Goes on with the rays of a job. PLT_OK: all are traced; PLT_MORE: its visits are made, and what
 * is on the lists waits in the wave. The scene has compact blocks. */
int plt_wave_compact(plt_wave_job *job);

#endif
