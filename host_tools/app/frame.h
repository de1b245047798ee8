/* frame - a picture, tile by tile from the engine
 *
 * SPDX-License-Identifier: MIT */
#ifndef FRAME_H
#define FRAME_H

#include "engine/planelet.h"
#include "host_tools/picture/picture.h"

/* Node visits per plt_render_step: between two steps a program shows its progress
 * or keeps a link alive. */
enum { FRAME_STEP_VISITS = 4096 };

/* Copies the tile that plt_render_step has finished into `to`, a picture of the
 * frame's size. Returns the first row below the tile. */
unsigned frame_copy_tile(const plt_engine *engine, picture *to);

#endif
