/* point - see point.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/whitted/point.h"

#include "engine/whitted/optics.h"

#if PLT_WITH_SURFACE
#include "engine/scene/surface_place.h"
#include "engine/surface/surface_corners.h"
#endif

#if PLT_WITH_WHITTED

int plt_point_is_smooth(const plt_scene *scene) {
#if PLT_WITH_SURFACE
    return scene->surface.is_open;
#else
    (void)scene;
    return 0;
#endif
}

void plt_point_want(const plt_scene *scene, plt_packet *packet) {
#if PLT_WITH_SURFACE
    if (scene->surface.is_open) {
        plt_packet_want_weights(packet);
        return;
    }
#endif
    (void)scene;
    plt_packet_want_normals(packet);
}

/* The triangle's, against the ray; a sliver without one faces it. */
static void set_side(plt_lit_pixel *p, const float normal[3]) {
    float n[3] = {normal[0], normal[1], normal[2]};
    const int has_one = plt_normalise(n);
    const float side = plt_optics_dot(n, p->ray.dir) > 0.0f ? -1.0f : 1.0f;
    for (int a = 0; a < 3; a++) {
        p->side[a] = has_one ? side * n[a] : -p->ray.dir[a];
        p->normal[a] = p->side[a];
    }
}

#if PLT_WITH_SURFACE
/* That of the corners, on the same side as the triangle's, unless it faces away from the ray. */
static void set_smooth(plt_lit_pixel *p, const float normal[3]) {
    float n[3] = {normal[0], normal[1], normal[2]};
    if (!plt_normalise(n)) {
        return;
    }
    const float side = plt_optics_dot(n, p->side) < 0.0f ? -1.0f : 1.0f;
    if (side * plt_optics_dot(n, p->ray.dir) < 0.0f) {
        for (int a = 0; a < 3; a++) {
            p->normal[a] = side * n[a];
        }
    }
}

static void set_of_corners(const plt_scene *scene, plt_lit_pixel *p, const plt_group_rays *g,
                           unsigned lane, plt_surface_point *to) {
    plt_record room;
    plt_surface_corners corners;
    plt_surface_point point;
    plt_surface_corners_set(&corners, &scene->surface,
                            plt_surface_record(scene, g->id[lane], &room));
    plt_surface_mix(&corners, g->u[lane], g->v[lane], &point);
    set_side(p, point.flat);
    set_smooth(p, point.normal);
    for (int c = 0; c < 3; c++) {
        const float colour = point.has_colour ? point.colour[c] : 1.0f;
        p->tint[c] = (uint8_t)(int32_t)(colour * 255.0f + 0.5f);
    }
    if (to != NULL) {
        *to = point;
    }
}
#endif

#if PLT_WITH_TEXTURE
void plt_point_set(const plt_scene *scene, plt_lit_pixel *p, const plt_group_rays *g, unsigned lane,
                   plt_surface_point *surface) {
    surface->has_texcoord = 0;
#else
void plt_point_set(const plt_scene *scene, plt_lit_pixel *p, const plt_group_rays *g,
                   unsigned lane) {
#endif
#if PLT_WITH_SURFACE
    if (scene->surface.is_open) {
#if PLT_WITH_TEXTURE
        set_of_corners(scene, p, g, lane, surface);
#else
        set_of_corners(scene, p, g, lane, NULL);
#endif
        return;
    }
#endif
    (void)scene;
    const float normal[3] = {g->normal[0][lane], g->normal[1][lane], g->normal[2][lane]};
    set_side(p, normal);
    p->tint[0] = p->tint[1] = p->tint[2] = 255;
}

#endif
