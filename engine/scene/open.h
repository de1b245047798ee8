/* open - from an image's header to a scene: validated, or built
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCENE_OPEN_H
#define PLT_SCENE_OPEN_H

#include "engine/scene/build_compact.h"
#include "engine/scene/opening.h"

/* Fills info, box and format of a scene from its image's header. */
void plt_scene_describe(plt_scene *scene, const plt_header *header);

/* Reads and validates a finished tree, or builds one. PLT_MORE: compact blocks are
 * to be built, by plt_scene_build_step, with the state that *build points at. Needs
 * plt_scene_describe before. Errors: as plt_open. */
int plt_scene_open(const plt_opening *o, const plt_header *header, plt_compact_build **build);

/* About `steps` splits or blocks more. PLT_OK: the scene is open, the state gone. */
int plt_scene_build_step(const plt_opening *o, plt_compact_build *build, uint32_t steps);

#endif
