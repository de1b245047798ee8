/* open - from an image's header to a scene: read and validated, or built
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCENE_OPEN_H
#define PLT_SCENE_OPEN_H

#include "engine/image/header.h"
#include "engine/scene/opening.h"

/* State of a build in steps, in the builder's scratch (scene/build_compact.h). */
struct plt_compact_build;

/* NULL, or why this build of the engine cannot open such an image: what it lacks. */
const char *plt_scene_left_out(const plt_info *info, unsigned residency, unsigned structure);

/* Fills the scene in: reads and validates a finished tree, or builds one. PLT_MORE:
 * compact blocks are to be built, by plt_scene_build_step, with the state that *build
 * points at. Errors: as plt_open. */
int plt_scene_open(const plt_opening *o, const plt_header *header,
                   struct plt_compact_build **build);

/* About `steps` splits or blocks more. PLT_OK: the scene is open, the state gone. */
int plt_scene_build_step(const plt_opening *o, struct plt_compact_build *build, uint32_t steps);

#endif
