/* engine - what lies at the front of the arena
 *
 * A scene, and one worker's traversal, packet and frame over it. The parts of the
 * arena behind it: scene/parts.h.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_ENGINE_H
#define PLT_ENGINE_H

#include "engine/base/arena.h"
#include "engine/scene/open.h"
#include "engine/schedule/batch.h"
#include "engine/shade/rendering.h"
#include "engine/trace/traversal.h"

struct plt_engine {
    plt_arena arena;
    plt_source source;
    plt_options options;
    plt_scene scene;
    plt_packet packet;
#if PLT_WITH_BATCH
    plt_batch batch; /* most 0: none */
#endif
    plt_traversal traversal;
    plt_rendering rendering;
    struct plt_compact_build *build; /* in scratch, between plt_open_begin and the last step */
    int8_t failed;                   /* what a step of opening failed with; PLT_OK: none has */
};

#endif
