/* surface_place - where the triangle of a primitive id is
 *
 * A hit names its triangle by number; its corners are in a record, or in a block. This is the way
 * there: of records their number, of blocks the address, over 8, in the first half of the room, and
 * the triangle of the block, 16 bits, in the second.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCENE_SURFACE_PLACE_H
#define PLT_SCENE_SURFACE_PLACE_H

#include "engine/scene/scene.h"

#if PLT_WITH_SURFACE && PLT_WITH_GROUPS

/* Ids are below this. */
static inline uint32_t plt_surface_ids(const plt_info *info) {
    return info->source_triangles > info->triangles ? info->source_triangles : info->triangles;
}

/* 4 bytes each, of compact blocks 6. */
static inline uint64_t plt_surface_places_bytes(const plt_info *info) {
    return (info->nodes_format == PLT_NODES_COMPACT ? 6ull : 4ull) * plt_surface_ids(info);
}

/* Fills the room, of a scene that is open. Ids that no triangle has, which are none of a hit, get
 * the first one's place; of two that have one, either. */
void plt_surface_places_set(plt_scene *scene, void *room);

/* The record of an id below scene->surface.triangles: where it is, or made in `room`. */
const plt_record *plt_surface_record(const plt_scene *scene, uint32_t id, plt_record *room);

#if PLT_WITH_PAGES
/* The number of that triangle in the image; not of grids, whose records are in another order. */
uint32_t plt_surface_index(const plt_scene *scene, uint32_t id);
#endif

#endif
#endif
