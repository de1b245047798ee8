/* opening - what the opening of every format needs, and the steps they share
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCENE_OPENING_H
#define PLT_SCENE_OPENING_H

#include "engine/base/arena.h"
#include "engine/image/header.h"
#include "engine/scene/parts.h"
#include "engine/scene/scene.h"

typedef struct plt_opening {
    plt_scene *scene; /* to be filled in; info, box and format are there */
    const plt_source *source;
    plt_arena *arena;
    const plt_layout *layout;
    plt_fault *fault;
    uint8_t residency;     /* enum plt_residency */
    uint8_t structure;     /* enum plt_structure */
    uint8_t movable;       /* sections are copied, mapped or not */
    uint8_t over_vertices; /* records are not kept */
} plt_opening;

/* PLT_ERR_ARENA. need_bytes stays 0 here; engine/open.c sets it. */
int plt_opening_arena_error(const plt_opening *o);

/* Cuts all bytes of a part off the arena; NULL: there are too few. */
void *plt_opening_cut(const plt_opening *o, enum plt_part part);

/* A section where it lies in a mapped image, or copied into the arena; its checksum
 * is right. */
int plt_opening_section(const plt_opening *o, const plt_section *section, const void **bytes);

#if PLT_WITH_VERTICES
/* Of a mapped image, where it lies, though others are copied. */
int plt_opening_mapped(const plt_opening *o, const plt_section *section, const void **bytes);
#endif

/* The same, always copied, since a builder reorders it. */
int plt_opening_copy(const plt_opening *o, const plt_section *section, void **bytes);

#endif
