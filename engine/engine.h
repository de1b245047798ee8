/* engine - what lies at the front of the arena
 *
 * A scene, and one worker's traversal, packet and frame over it. The parts of the
 * arena behind it: scene/parts.h.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_ENGINE_H
#define PLT_ENGINE_H

#include "engine/base/arena.h"
#include "engine/instances/matrices.h"
#include "engine/motion/moving.h"
#include "engine/motion/sequence.h"
#include "engine/scene/open.h"
#include "engine/schedule/batch.h"
#include "engine/schedule/dispatch.h"
#include "engine/shade/rendering.h"
#include "engine/trace/traversal.h"

#if PLT_WITH_TASK
/* An array of rays that workers share. */
typedef struct plt_task_rays {
    const plt_ray *rays;
    plt_hit *hits;        /* NULL: there is none */
    uint32_t count, next; /* next: the first that no packet has */
    int any;
} plt_task_rays;
#endif

/* What a worker writes while it works comes first, then what does not change, then what a
 * dispatcher writes: workers on other cores read the last two meanwhile (task.c). */
struct plt_engine {
    plt_traversal traversal;
    plt_packet packet;
#if PLT_WITH_TASK
    plt_worker worker; /* if is_worker */
    uint8_t is_worker;
#endif
#if PLT_WITH_BATCH
    plt_batch batch; /* most 0: none */
#endif
#if PLT_WITH_MOTION
    plt_moving moving; /* of a movable scene */
#endif
#if PLT_WITH_SEQUENCE
    plt_sequence sequence; /* frames 0: the image has none, or is not opened to be moved */
#endif
#if PLT_WITH_INSTANCES
    plt_matrices matrices; /* frames 0: the image has no instances */
#endif
    struct plt_compact_build *build; /* in scratch, between plt_open_begin and the last step */
    int8_t failed;                   /* what a step of opening failed with; PLT_OK: none has */
    plt_arena arena;
    plt_source source;
    plt_options options;
    plt_scene scene;
    plt_rendering rendering;
#if PLT_WITH_TASK
    uint8_t *colours;      /* of the dispatcher's packets that are done; packet_side rows each */
    plt_task_rays shared;  /* rays that workers share; hits NULL: a frame, or nothing */
    plt_dispatch dispatch; /* rooms 0: none */
#endif
#if PLT_WITH_GRID
    void *grid_room; /* where the grid is made, of a scene that has one; the arena's last part */
    size_t grid_bytes;
#endif
};

#endif
