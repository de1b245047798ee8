/* build_thesis - thesis nodes over a scene's records, built in the arena
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCENE_BUILD_THESIS_H
#define PLT_SCENE_BUILD_THESIS_H

#include "engine/scene/opening.h"

/* Copies the records, orders them, and grows nodes behind them; the scene's counts
 * and stack needs come from a validation of what was built. */
int plt_build_thesis(const plt_opening *o, const plt_header *header);

#endif
