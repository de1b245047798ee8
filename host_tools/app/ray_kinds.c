/* ray_kinds - see ray_kinds.h
 *
 * The engine's own frame in colours of the surface's directions says where the normals are:
 * 8 bits per axis are enough for what has to be random anyway, and any image has them.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/ray_kinds.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/shade/camera.h"
#include "host_tools/app/frame.h"
#include "host_tools/app/view_rays.h"

const char *const ray_kind_names[RAY_KINDS + 1] = {"primary", "shadow",  "light",  "bounce",
                                                   "random",  "outside", "inside", NULL};

enum {
    TILE_SIDE = 16,
    FROM_HITS = 1 << RAYS_SHADOW | 1 << RAYS_LIGHT | 1 << RAYS_BOUNCE,
    OF_THE_VIEW = 1 << RAYS_PRIMARY | FROM_HITS
};

#define SEED UINT64_C(88172645463325252)

/* What the rays are made from. */
typedef struct making {
    ray_kinds *to;
    unsigned kinds; /* to be made, a bit each */
    const plt_info *info;
    const plt_frame *frame;
    double diagonal, light[3];
    uint32_t *pixel; /* of each primary ray: y * width + x */
    plt_hit *hits;
    picture normals;
    uint64_t random;
} making;

static void add_primary(making *m, const plt_view *view, uint32_t x, uint32_t y) {
    ray_set *s = &m->to->of[RAYS_PRIMARY];
    m->pixel[s->count] = y * m->frame->width + x;
    view_ray_add(s, view, x, y);
}

static int make_primary(making *m, fail *f) {
    plt_view view;
    if (plt_view_set(&view, m->frame) != PLT_OK) {
        return fail_set(f, "engine", "status %d; please report this", PLT_ERR_ARGUMENT);
    }
    for (uint32_t top = 0; top < m->frame->height; top += TILE_SIDE) {
        for (uint32_t left = 0; left < m->frame->width; left += TILE_SIDE) {
            for (uint32_t k = 0; k < TILE_SIDE * TILE_SIDE; k++) {
                const uint32_t x = left + plt_z_order_x(k), y = top + plt_z_order_y(k);
                if (x < m->frame->width && y < m->frame->height) {
                    add_primary(m, &view, x, y);
                }
            }
        }
    }
    return 0;
}

static int make_normals(making *m, plt_engine *engine, fail *f) {
    plt_frame frame = *m->frame;
    frame.shader = PLT_SHADE_NORMAL;
    int status = plt_render_begin(engine, &frame);
    while (status >= PLT_OK && (status = plt_render_step(engine, FRAME_STEP_VISITS)) > PLT_OK) {
        if (status == PLT_TILE) {
            frame_copy_tile(engine, &m->normals);
        }
    }
    return status == PLT_OK ? 0 : fail_set(f, "engine", "status %d; please report this", status);
}

/* Of unit length, to the side from which the ray comes. */
static void normal_at(const making *m, uint32_t pixel, double normal[3]) {
    for (int a = 0; a < 3; a++) {
        normal[a] = m->normals.rgb[3 * (size_t)pixel + (size_t)a] / 127.5 - 1.0;
    }
    ray_normalise(normal);
}

/* Malley: points of a disc, of equal density, moved up to the half sphere. */
static void cosine_direction(making *m, const double normal[3], double dir[3]) {
    double x, y, side[3], over[3];
    do {
        x = 2.0 * ray_random(&m->random) - 1.0;
        y = 2.0 * ray_random(&m->random) - 1.0;
    } while (x * x + y * y >= 1.0);
    ray_frame(normal, side, over);
    for (int a = 0; a < 3; a++) {
        dir[a] = x * side[a] + y * over[a] + sqrt(1.0 - x * x - y * y) * normal[a];
    }
}

static int is_wanted(const making *m, enum ray_kind kind) {
    return (int)(m->kinds >> kind & 1u);
}

static void make_secondary(making *m) {
    const ray_set *primary = &m->to->of[RAYS_PRIMARY];
    for (uint32_t i = 0; i < primary->count; i++) {
        if (m->hits[i].triangle == PLT_MISS) {
            continue;
        }
        double normal[3], org[3], to_light[3], from_light[3], dir[3];
        normal_at(m, m->pixel[i], normal);
        for (int a = 0; a < 3; a++) {
            const plt_ray *ray = &primary->rays[i];
            org[a] = (double)ray->org[a] + (double)m->hits[i].t * (double)ray->dir[a] +
                     1e-4 * m->diagonal * normal[a];
            to_light[a] = m->light[a] - org[a];
            from_light[a] = -to_light[a];
        }
        if (is_wanted(m, RAYS_SHADOW)) {
            ray_set_add(&m->to->of[RAYS_SHADOW], org, to_light, 1.0f);
        }
        if (is_wanted(m, RAYS_LIGHT)) {
            ray_set_add(&m->to->of[RAYS_LIGHT], m->light, from_light, 1.0f);
        }
        if (is_wanted(m, RAYS_BOUNCE)) {
            cosine_direction(m, normal, dir);
            ray_set_add(&m->to->of[RAYS_BOUNCE], org, dir, INFINITY);
        }
    }
}

/* Fisher and Yates. */
static void shuffle(making *m, ray_set *s) {
    for (uint32_t i = s->count; i > 1; i--) {
        const uint32_t k = ray_random_below(&m->random, i);
        const plt_ray ray = s->rays[i - 1];
        s->rays[i - 1] = s->rays[k];
        s->rays[k] = ray;
    }
}

/* The light is two diagonals from the middle of the box, above and behind the default eye. */
static void measure_box(making *m) {
    double light[3] = {0.5, 1.0, 0.7}, sum = 0.0;
    ray_normalise(light);
    for (int a = 0; a < 3; a++) {
        const double edge = (double)m->info->hi[a] - (double)m->info->lo[a];
        sum += edge * edge;
    }
    m->diagonal = sqrt(sum);
    for (int a = 0; a < 3; a++) {
        const double middle = 0.5 * ((double)m->info->hi[a] + (double)m->info->lo[a]);
        m->light[a] = middle + 2.0 * m->diagonal * light[a];
    }
}

static void ray_set_free(ray_set *s) {
    free(s->rays);
    *s = (ray_set){NULL, 0};
}

static int out_of_memory(fail *f) {
    return fail_set(f, "rays", "out of memory; choose a smaller --size");
}

static int make_room(making *m, enum ray_kind kind, size_t pixels, fail *f) {
    ray_set *s = &m->to->of[kind];
    s->rays = malloc(pixels * sizeof *s->rays);
    return s->rays != NULL ? 0 : out_of_memory(f);
}

/* Primary rays and their hits. */
static int look(making *m, plt_engine *engine, size_t pixels, const char *name, fail *f) {
    m->pixel = malloc(pixels * sizeof *m->pixel);
    m->hits = malloc(pixels * sizeof *m->hits);
    if (m->pixel == NULL || m->hits == NULL) {
        return out_of_memory(f);
    }
    if (make_room(m, RAYS_PRIMARY, pixels, f) != 0 || make_primary(m, f) != 0) {
        return -1;
    }
    plt_trace(engine, m->to->of[RAYS_PRIMARY].rays, m->hits, (uint32_t)pixels, 0);
    for (size_t i = 0; i < pixels; i++) {
        if (m->hits[i].triangle != PLT_MISS) {
            return 0;
        }
    }
    return fail_set(f, name, "no primary ray hits it; choose another --eye or --look");
}

/* From where primary rays hit. */
static int make_from_hits(making *m, plt_engine *engine, size_t pixels, fail *f) {
    for (int kind = RAYS_SHADOW; kind <= RAYS_BOUNCE; kind++) {
        if (is_wanted(m, (enum ray_kind)kind) &&
            make_room(m, (enum ray_kind)kind, pixels, f) != 0) {
            return -1;
        }
    }
    if (picture_make(&m->normals, m->frame->width, m->frame->height, f) != 0 ||
        make_normals(m, engine, f) != 0) {
        return -1;
    }
    make_secondary(m);
    shuffle(m, &m->to->of[RAYS_BOUNCE]);
    return 0;
}

static int make_of_the_view(making *m, plt_engine *engine, size_t pixels, const char *name,
                            fail *f) {
    if (look(m, engine, pixels, name, f) != 0 ||
        ((m->kinds & FROM_HITS) != 0 && make_from_hits(m, engine, pixels, f) != 0)) {
        return -1;
    }
    if (!is_wanted(m, RAYS_PRIMARY)) {
        ray_set_free(&m->to->of[RAYS_PRIMARY]);
    }
    return 0;
}

/* The last three kinds, each from a seed of its own: the same whichever others are made. */
static int make_of_the_box(making *m, size_t pixels, fail *f) {
    static void (*const make[])(ray_set *, const plt_info *, uint32_t,
                                uint64_t *) = {ray_box_sides, ray_box_outside, ray_box_inside};
    for (int kind = RAYS_RANDOM; kind <= RAYS_INSIDE; kind++) {
        uint64_t random = SEED * (2 * (uint64_t)kind + 1);
        if (!is_wanted(m, (enum ray_kind)kind)) {
            continue;
        }
        if (make_room(m, (enum ray_kind)kind, pixels, f) != 0) {
            return -1;
        }
        make[kind - RAYS_RANDOM](&m->to->of[kind], m->info, (uint32_t)pixels, &random);
    }
    return 0;
}

int ray_kinds_make(ray_kinds *r, unsigned kinds, plt_engine *engine, const plt_frame *frame,
                   const char *name, fail *f) {
    const size_t pixels = (size_t)frame->width * frame->height;
    making m = {
        .to = r, .kinds = kinds, .info = plt_engine_info(engine), .frame = frame, .random = SEED};
    int status = 0;
    memset(r, 0, sizeof *r);
    measure_box(&m);
    if ((kinds & OF_THE_VIEW) != 0) {
        status = make_of_the_view(&m, engine, pixels, name, f);
    }
    if (status == 0) {
        status = make_of_the_box(&m, pixels, f);
    }
    picture_free(&m.normals);
    free(m.pixel);
    free(m.hits);
    return status;
}

void ray_kinds_free(ray_kinds *r) {
    for (int k = 0; k < RAY_KINDS; k++) {
        ray_set_free(&r->of[k]);
    }
}
