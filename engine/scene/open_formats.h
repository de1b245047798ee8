/* open_formats - how each format is opened: a function and a file each
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCENE_OPEN_FORMATS_H
#define PLT_SCENE_OPEN_FORMATS_H

#include "engine/image/header.h"
#include "engine/scene/opening.h"

struct plt_compact_build;

/* plt_open_thesis, plt_open_compact ...: as plt_scene_open, of one format. */
#define PLT_OPEN_DECLARED(NAME, name, with, text)                                                  \
    int plt_open_##name(const plt_opening *o, const plt_header *header,                            \
                        struct plt_compact_build **build);
PLT_FORMATS(PLT_OPEN_DECLARED)
#undef PLT_OPEN_DECLARED

#endif
