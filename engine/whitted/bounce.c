/* bounce - see bounce.h
 *
 * Glass is a closed body: a ray in air that meets its surface enters it, one within leaves it,
 * whichever way the triangle turns.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/whitted/bounce.h"

#include "engine/whitted/direct.h"
#include "engine/whitted/lights.h"
#include "engine/whitted/optics.h"

#if PLT_WITH_WHITTED

/* Rays that a hit sends out: off the surface, and through it. */
typedef struct sent {
    plt_lit_ray ray[2];
    unsigned count;
} sent;

static void send(const plt_whitted *w, plt_lit_pixel *p, plt_lit_ray *ray, float side, sent *s) {
    for (int a = 0; a < 3; a++) {
        ray->org[a] = p->ray.org[a] + side * w->lift * p->side[a];
    }
    ray->level = (uint8_t)(p->ray.level + 1);
#if PLT_WITH_TEXTURE
    ray->before = p->ray.before;
#endif
    ray->is_sky = 0;
    if (p->ray.level < w->lighting.bounces && plt_lit_counts(ray->weight)) {
        s->ray[s->count++] = *ray;
        return;
    }
    float sky[3];
    plt_light_sky(&w->lighting, plt_optics_dot(ray->dir, w->up), sky);
    plt_lit_add(p, ray->weight, sky);
}

/* Through glass; returns how much is reflected instead. */
static float pass(const plt_whitted *w, plt_lit_pixel *p, const plt_material *m, sent *s) {
    plt_lit_ray ray;
    plt_material left = *m;
    float cosine;
    if (p->ray.inside > 0) {
        plt_materials_get(&w->materials, p->ray.inside - 1u, &left);
    }
    const float ratio = p->ray.inside > 0 ? left.index : 1.0f / m->index;
    const float *n = p->normal;
    if (!plt_optics_refract(p->ray.dir, n, ratio, ray.dir, &cosine)) {
        return 1.0f;
    }
    if (plt_optics_dot(ray.dir, p->side) >= 0.0f) { /* the triangle is on the other side */
        n = p->side;
        if (!plt_optics_refract(p->ray.dir, n, ratio, ray.dir, &cosine)) {
            return 1.0f;
        }
    }
    const float before = -plt_optics_dot(p->ray.dir, n);
    const float reflected = plt_optics_glass(left.index, p->ray.inside > 0 ? cosine : before);
    for (int c = 0; c < 3; c++) {
        ray.weight[c] = p->ray.weight[c] * m->transparency * (1.0f - reflected);
    }
    ray.inside = p->ray.inside > 0 ? 0 : (uint16_t)(p->material + 1u);
    send(w, p, &ray, -1.0f, s);
    return reflected;
}

static void reflect(const plt_whitted *w, plt_lit_pixel *p, const plt_material *m, float glass,
                    sent *s) {
    plt_lit_ray ray;
    float mirror[3];
    plt_direct_mirror(m, p, mirror);
    plt_optics_reflect(p->ray.dir, p->normal, ray.dir);
    if (plt_optics_dot(ray.dir, p->side) <= 0.0f) { /* it would go into the triangle */
        plt_optics_reflect(p->ray.dir, p->side, ray.dir);
    }
    for (int c = 0; c < 3; c++) {
        ray.weight[c] =
            p->ray.weight[c] * ((1.0f - m->transparency) * mirror[c] + m->transparency * glass);
    }
    ray.inside = p->ray.inside;
    send(w, p, &ray, 1.0f, s);
}

static void send_out(const plt_whitted *w, plt_lit_pixel *p, sent *s) {
    plt_material m;
    float glass = 0.0f;
    plt_materials_get(&w->materials, p->material, &m);
    if (m.transparency > 0.0f) {
        glass = pass(w, p, &m, s);
    }
    if (m.transparency > 0.0f || m.mirror > 0.0f) {
        reflect(w, p, &m, glass, s);
    }
}

/* The first of two is traced next, the other waits. */
static void go_on(plt_whitted *w, uint32_t k) {
    plt_lit_pixel *p = &w->pixel[k];
    plt_lit_ray *waiting = &w->waiting[k * w->room];
    sent s;
    s.count = 0;
    if (p->state == PLT_LIT_HIT) {
        send_out(w, p, &s);
    }
    if (s.count > 1) {
        waiting[p->waiting++] = s.ray[1];
    }
    p->state = PLT_LIT_RAY;
    if (s.count > 0) {
        p->ray = s.ray[0];
    } else if (p->waiting > 0) {
        p->ray = waiting[--p->waiting];
    } else {
        p->state = PLT_LIT_DONE;
    }
}

uint32_t plt_bounce_all(plt_whitted *w) {
    uint32_t count = 0;
    for (uint32_t k = 0; k < w->pixels; k++) {
        if (w->pixel[k].state == PLT_LIT_DONE && w->pixel[k].waiting == 0) {
            continue;
        }
        go_on(w, k);
        if (w->pixel[k].state == PLT_LIT_RAY) {
            w->slot[count++] = (uint8_t)k;
        }
    }
    return count;
}

#endif
