/* view_rays - see view_rays.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/view_rays.h"

#include <math.h>

void view_ray_add(ray_set *to, const plt_view *view, uint32_t x, uint32_t y) {
    double org[3], dir[3];
    for (int a = 0; a < 3; a++) {
        org[a] = (double)view->eye[a];
        dir[a] = (double)view->corner[a] + x * (double)view->right[a] + y * (double)view->down[a];
    }
    ray_set_add(to, org, dir, INFINITY);
}

const plt_ray *view_rays_make(const view_rays *v, uint64_t first, uint32_t count) {
    ray_set to = {v->room, 0};
    const uint32_t across = v->side / VIEW_RAYS_TILE;
    for (uint64_t i = first; i < first + count; i++) {
        const uint32_t in_view = (uint32_t)(i % ((uint64_t)v->side * v->side));
        const uint32_t tile = in_view / (VIEW_RAYS_TILE * VIEW_RAYS_TILE);
        const uint32_t k = in_view % (VIEW_RAYS_TILE * VIEW_RAYS_TILE);
        view_ray_add(&to, &v->view[i / ((uint64_t)v->side * v->side)],
                     tile % across * VIEW_RAYS_TILE + plt_z_order_x(k),
                     tile / across * VIEW_RAYS_TILE + plt_z_order_y(k));
    }
    return v->room;
}
