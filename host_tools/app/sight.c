/* sight - see sight.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/sight.h"

#include <math.h>

#include "engine/shade/camera.h"
#include "host_tools/base/heap.h"

enum { SIDE_MOST = 128, STORE_BYTES = 1 << 20 };

/* NULL: there is no memory, or the image is not for it. */
static plt_engine *open_own(sight *s, const plt_info *info, uint8_t residency) {
    const plt_options options = {.packet_side = PLT_PACKET_SIDE_MAX < 8 ? PLT_PACKET_SIDE_MAX : 8,
                                 .residency = residency,
                                 .store_bytes =
                                     residency == PLT_RESIDENCY_STREAMED ? STORE_BYTES : 0};
    const size_t bytes = plt_arena_need(info, s->file.source.mapped != NULL, &options);
    plt_engine *engine = NULL;
    plt_fault fault;
    heap_drop(s->arena);
    s->arena = bytes > 0 ? heap_get_aligned(bytes) : NULL;
    if (s->arena == NULL ||
        plt_open(&engine, s->arena, bytes, &s->file.source, &options, &fault) != PLT_OK) {
        return NULL;
    }
    return engine;
}

void sight_open(sight *s, const host_scene *file, plt_engine *resident) {
    plt_info info;
    plt_fault fault;
    *s = (sight)SIGHT_CLOSED;
    host_scene_share(&s->file, file);
    if (plt_image_info(&s->file.source, &info, &fault) != PLT_OK || info.frames > 0) {
        return;
    }
    s->engine = resident;
    if (s->engine == NULL) {
        s->engine = open_own(s, &info, PLT_RESIDENCY_STREAMED);
    }
    if (s->engine == NULL) {
        s->engine = open_own(s, &info, PLT_RESIDENCY_WHOLE);
    }
}

void sight_close(sight *s) {
    heap_drop(s->arena);
    host_scene_close(&s->file);
    *s = (sight)SIGHT_CLOSED;
}

/* The rays of a row of the frame. */
static void make_rays(const plt_view *v, unsigned y, unsigned side, plt_ray *rays) {
    for (unsigned x = 0; x < side; x++) {
        rays[x] = (plt_ray){.tmax = PLT_VIEW_FAR};
        plt_view_direction(v, x, y, rays[x].dir);
        for (int i = 0; i < 3; i++) {
            rays[x].org[i] = v->eye[i];
        }
    }
}

/* `pixel`: from one ray to the next, at a depth of 1. */
static void add_hit(fitting *f, const plt_ray *ray, const plt_hit *hit, const double forward[3],
                    const double pixel[2]) {
    double point[3], arm[3];
    for (int i = 0; i < 3; i++) {
        arm[i] = (double)hit->t * (double)ray->dir[i];
        point[i] = (double)ray->org[i] + arm[i];
    }
    const double depth = vector_dot(arm, forward);
    fitting_add(f, point, depth * pixel[0], depth * pixel[1]);
}

/* A view of side x side pixels over a frame of that aspect, which are as much wider than high. */
static int set_view(plt_view *view, const plt_camera *camera, double aspect, unsigned side) {
    const plt_frame frame = {.camera = *camera, .width = (uint16_t)side, .height = (uint16_t)side};
    const int status = plt_view_set(view, &frame);
    for (int i = 0; i < 3 && status == PLT_OK; i++) {
        view->corner[i] += (float)(0.5 * (1.0 - aspect) * ((double)side - 1.0)) * view->right[i];
        view->right[i] = (float)(aspect * (double)view->right[i]);
    }
    return status;
}

static int add_row(const sight *s, const plt_view *view, unsigned y, unsigned side,
                   const double forward[3], const double pixel[2], fitting *f) {
    plt_ray rays[SIDE_MOST] = {{.tmax = 0.0f}}; /* `side` is not SIDE_MOST to a compiler */
    plt_hit hits[SIDE_MOST];
    int found = 0;
    make_rays(view, y, side, rays);
    if (plt_trace(s->engine, rays, hits, side, 0) != PLT_OK) {
        return -1;
    }
    for (unsigned x = 0; x < side; x++) {
        if (hits[x].triangle != PLT_MISS) {
            add_hit(f, &rays[x], &hits[x], forward, pixel);
            found++;
        }
    }
    return found;
}

int sight_add(const sight *s, const plt_camera *camera, double aspect, unsigned side, fitting *f) {
    const double high = 2.0 * (double)camera->tan_half_fov / side;
    const double pixel[2] = {aspect * high, high};
    plt_view view;
    double forward[3];
    int found = 0, row = 0;
    if (s->engine == NULL || side > SIDE_MOST || set_view(&view, camera, aspect, side) != PLT_OK) {
        return -1;
    }
    for (int i = 0; i < 3; i++) {
        forward[i] = (double)camera->look[i] - (double)camera->eye[i];
    }
    vector_normalise(forward);
    for (unsigned y = 0; y < side && row >= 0; y++) {
        row = add_row(s, &view, y, side, forward, pixel, f);
        found += row;
    }
    return row < 0 ? -1 : found;
}
