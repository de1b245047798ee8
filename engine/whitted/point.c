/* point - see point.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/whitted/point.h"

#include "engine/whitted/optics.h"

#if PLT_WITH_SURFACE
#include "engine/trace/surface_hit.h"
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

static int set_of_corners(plt_traversal *t, plt_lit_pixel *p, const plt_packet *packet,
                          uint32_t ray, plt_surface_point *to) {
    const plt_group_rays *g = &packet->rays[ray / 4];
    plt_surface_corners corners;
    plt_surface_point point;
    const int status = plt_surface_of_ray(t, packet, ray, &corners);
    if (status != PLT_OK) {
        return status;
    }
    plt_surface_mix(&corners, g->u[ray % 4], g->v[ray % 4], &point);
    set_side(p, point.flat);
    set_smooth(p, point.normal);
    for (int c = 0; c < 3; c++) {
        const float colour = point.has_colour ? point.colour[c] : 1.0f;
        p->tint[c] = (uint8_t)(int32_t)(colour * 255.0f + 0.5f);
    }
    if (to != NULL) {
        *to = point;
    }
    return PLT_OK;
}
#endif

#if PLT_WITH_TEXTURE
int plt_point_set(plt_traversal *t, plt_lit_pixel *p, const plt_packet *packet, uint32_t ray,
                  plt_surface_point *surface) {
    surface->has_texcoord = 0;
#else
int plt_point_set(plt_traversal *t, plt_lit_pixel *p, const plt_packet *packet, uint32_t ray) {
#endif
#if PLT_WITH_SURFACE
    if (t->scene->surface.is_open) {
#if PLT_WITH_TEXTURE
        return set_of_corners(t, p, packet, ray, surface);
#else
        return set_of_corners(t, p, packet, ray, NULL);
#endif
    }
#endif
    (void)t;
    const plt_group_rays *g = &packet->rays[ray / 4];
    const unsigned lane = ray % 4;
    const float normal[3] = {g->normal[0][lane], g->normal[1][lane], g->normal[2][lane]};
    set_side(p, normal);
    p->tint[0] = p->tint[1] = p->tint[2] = 255;
    return PLT_OK;
}

#endif
