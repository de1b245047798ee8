/* frame_put - a frame that has come put in place of the one that is shown
 *
 * Records, blocks that lie in the arena, or which copy of all blocks is fetched.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_FRAME_PUT_H
#define PLT_FRAME_PUT_H

#include "engine/planelet.h"

/* Vertices of frame `frame` have been read, where it has some. Ends a frame that is rendered. */
int plt_frame_put(plt_engine *engine, uint32_t frame, plt_fault *fault);

#endif
