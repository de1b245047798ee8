/* open_formats - how each format is opened: a function and a file each
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCENE_OPEN_FORMATS_H
#define PLT_SCENE_OPEN_FORMATS_H

#include "engine/scene/build_compact.h"
#include "engine/scene/opening.h"

int plt_open_thesis(const plt_opening *o, const plt_header *header);
int plt_open_list(const plt_opening *o, const plt_header *header);

/* PLT_MORE: see plt_scene_open. */
int plt_open_compact(const plt_opening *o, const plt_header *header, plt_compact_build **build);

#endif
