/* view_rays - the rays of several square views, by their numbers, so that they need not be kept
 *
 * Of each view one ray through every pixel, in Z order in tiles of 16x16, as primary rays are
 * (ray_kinds.h); a view behind the other.
 *
 * SPDX-License-Identifier: MIT */
#ifndef VIEW_RAYS_H
#define VIEW_RAYS_H
#include <stdint.h>

#include "engine/shade/camera.h"
#include "host_tools/app/ray_box.h"

enum { VIEW_RAYS_VIEWS = 16, VIEW_RAYS_TILE = 16 };

typedef struct view_rays {
    plt_view view[VIEW_RAYS_VIEWS];
    unsigned side, views; /* a multiple of VIEW_RAYS_TILE; 1 .. VIEW_RAYS_VIEWS */
    plt_ray *room;        /* for as many as are asked for at once; not owned */
} view_rays;

static inline uint64_t view_rays_count(const view_rays *v) {
    return (uint64_t)v->side * v->side * v->views;
}

/* Adds the one through a pixel. */
void view_ray_add(ray_set *to, const plt_view *view, uint32_t x, uint32_t y);

/* Rays `first` to `first + count` - 1, in the room for them. */
const plt_ray *view_rays_make(const view_rays *v, uint64_t first, uint32_t count);

#endif
