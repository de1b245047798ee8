/* frame - a picture, tile by tile from the engine
 *
 * SPDX-License-Identifier: MIT */
#ifndef FRAME_H
#define FRAME_H

#include "engine/planelet.h"
#include "host_tools/app/args.h"
#include "host_tools/picture/picture_file.h"

/* Node visits per plt_render_step: between two steps a program shows its progress
 * or keeps a link alive. */
enum { FRAME_STEP_VISITS = 4096 };

/* Copies the tile that plt_render_step has finished into `to`, a picture of the
 * frame's size. Returns the first row below the tile. */
unsigned frame_copy_tile(const plt_engine *engine, picture *to);

/* For a command whose -o may be a film. */
#define FRAME_CHROMA_FLAG                                                                          \
    {                                                                                              \
        "--chroma", "420|444",                                                                     \
            "colour of a film: 420, which players play once ffmpeg -i film.y4m film.mp4 has "      \
            "compressed it, or 444, that of each pixel in full range (default 420)"                \
    }

/* Makes the format of a film what --chroma says. */
void frame_choose_chroma(args *a, picture_format *format);

#endif
