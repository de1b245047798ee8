/* build_compact - compact blocks, built in the arena a bounded piece at a time
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCENE_BUILD_COMPACT_H
#define PLT_SCENE_BUILD_COMPACT_H

#include "engine/builder/blocks.h"
#include "engine/scene/opening.h"

/* What is known between two steps; lies in the builder's scratch. */
typedef struct plt_compact_build {
    plt_blocks_job job;
    size_t mark, peak;       /* of the arena, before the build */
    size_t scratch_bytes;    /* cut behind the memory that the blocks grow into */
    uint32_t corners_offset; /* of the section in the image */
} plt_compact_build;

/* Bytes of scratch for so many triangles, this state included. */
size_t plt_compact_build_bytes(uint32_t triangles);

/* PLT_MORE, and only then the state in `build`; or an error. */
int plt_build_compact_begin(const plt_opening *o, const plt_header *header,
                            plt_compact_build **build);

/* About `steps` splits or blocks, fewer if the source fails. PLT_OK: the scene is open, the scratch
 * given back. */
int plt_build_compact_step(const plt_opening *o, plt_compact_build *build, uint32_t steps);

#endif
