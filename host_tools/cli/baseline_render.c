/* baseline_render - see baseline_render.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/baseline_render.h"

#include <string.h>

#include "engine/engine.h"
#include "engine/shade/camera.h"
#include "engine/shade/surface.h"
#include "engine/trace/triangle_ray.h"
#include "host_tools/base/clock.h"
#include "host_tools/base/heap.h"

enum { SIDE = 16, TILE = SIDE * SIDE };

int baseline_colours_make(baseline_colours *c, const plt_engine *engine, const char *name,
                          fail *f) {
    const plt_scene *scene = &engine->scene;
    const uint32_t count = scene->info.triangles;
    c->record = baseline_records(scene);
    c->place = heap_get((uint64_t)count * sizeof *c->place + 1);
    if (c->place == NULL) {
        return fail_set(f, name, "out of memory; close other programs");
    }
    for (uint32_t i = 0; i < count; i++) {
        c->place[plt_primitive_id(plt_get_u32(&c->record[i].word[9]))] = i;
    }
    return 0;
}

void baseline_colours_free(baseline_colours *c) {
    heap_drop(c->place);
    c->place = NULL;
}

/* A tile, its top left pixel, and what the view and the frame say of it. */
typedef struct tile {
    const baseline_colours *colours;
    const plt_frame *frame;
    plt_view view;
    uint32_t x, y;
    plt_ray ray[TILE];
    plt_hit hit[TILE];
} tile;

static int is_inside(const tile *t, uint32_t k, uint32_t *x, uint32_t *y) {
    *x = t->x + plt_z_order_x(k);
    *y = t->y + plt_z_order_y(k);
    return *x < t->frame->width && *y < t->frame->height;
}

static void set_rays(tile *t) {
    memset(t->ray, 0, sizeof t->ray);
    for (uint32_t k = 0; k < TILE; k++) {
        uint32_t x, y;
        if (is_inside(t, k, &x, &y)) {
            memcpy(t->ray[k].org, t->view.eye, sizeof t->ray[k].org);
            plt_view_direction(&t->view, x, y, t->ray[k].dir);
            t->ray[k].tmax = PLT_VIEW_FAR;
        }
    }
}

static void set_colours(const tile *t, picture *to) {
    for (uint32_t k = 0; k < TILE; k++) {
        uint32_t x, y;
        const plt_hit *h = &t->hit[k];
        if (!is_inside(t, k, &x, &y)) {
            continue;
        }
        uint8_t *rgb = to->rgb + 3 * ((size_t)y * to->width + x);
        if (h->triangle == PLT_MISS) {
            plt_surface_sky(t->frame, y, rgb);
            continue;
        }
        float corner[3][3], normal[3];
        plt_surface surface;
        plt_record_corners(&t->colours->record[t->colours->place[h->triangle]], corner);
        plt_hit_normal((const float(*)[3])corner, normal);
        plt_surface_set(&surface, normal);
        plt_surface_colour(&surface, t->frame->shader, h->triangle, t->ray[k].dir, rgb);
    }
}

int baseline_render(const baseline *b, const baseline_colours *c, const plt_frame *frame,
                    picture *to, double *seconds, progress *bar, uint64_t done, fail *f) {
    tile t = {.colours = c, .frame = frame};
    const double began = clock_processor_seconds();
    if (plt_view_set(&t.view, frame) != PLT_OK) {
        return fail_set(f, "engine", "status %d; please report this", PLT_ERR_ARGUMENT);
    }
    for (t.y = 0; t.y < frame->height; t.y += SIDE) {
        for (t.x = 0; t.x < frame->width; t.x += SIDE) {
            set_rays(&t);
            if (structure_trace(b->s, t.ray, t.hit, TILE, 0, f) != 0) {
                return -1;
            }
            set_colours(&t, to);
            progress_show(bar, ++done);
        }
    }
    *seconds += clock_processor_seconds() - began;
    return 0;
}
