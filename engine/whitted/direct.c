/* direct - see direct.h
 *
 * Diffuse surfaces are Lambert's; highlights J. Blinn's, "Models of light reflection for computer
 * synthesized pictures", 1977: the cosine between the normal and half way from eye to light, to
 * the material's exponent. What a mirror reflects a diffuse surface below it does not get.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/whitted/direct.h"

#include "engine/whitted/lights.h"
#include "engine/whitted/optics.h"

#if PLT_WITH_WHITTED

#define FAR 3.0e38f
/* A shadow ray ends this much before the light: what shows the light may be there. */
#define BEFORE_LIGHT 0.9990234375f

void plt_direct_mirror(const plt_material *m, const plt_lit_pixel *p, float to[3]) {
    const float grazing = plt_optics_grazing(-plt_optics_dot(p->ray.dir, p->normal));
    for (int c = 0; c < 3; c++) {
        const float face_on = m->mirror * m->specular[c];
        to[c] = m->mirror > 0.0f ? face_on + (1.0f - face_on) * grazing : 0.0f;
    }
}

/* Linear light of an sRGB byte, off by less than half a byte's step: a polynomial of the third
 * degree. */
static float linear(uint8_t byte) {
    const float x = (float)byte / 255.0f;
    return x * (x * (x * 0.305306011f + 0.682171111f) + 0.012522878f);
}

/* What counts of diffuse light: as much as is neither reflected nor let through. */
static void set_diffuse(const plt_material *m, const plt_lit_pixel *p, float to[3]) {
    float mirror[3];
    plt_direct_mirror(m, p, mirror);
    for (int c = 0; c < 3; c++) {
        const float share = (1.0f - m->transparency) * (1.0f - mirror[c]);
        const float tint = p->tint[c] < 255 ? linear(p->tint[c]) : 1.0f;
        to[c] = p->ray.weight[c] * m->diffuse[c] * tint * share;
    }
}

static int is_black(const float x[3]) {
    return !(x[0] > 0.0f || x[1] > 0.0f || x[2] > 0.0f);
}

void plt_direct_begin(plt_whitted *w, plt_lit_pixel *p) {
    plt_material m;
    float diffuse[3], around[3];
    plt_materials_get(&w->materials, p->material, &m);
    set_diffuse(&m, p, diffuse);
    plt_light_sky(&w->lighting, plt_optics_dot(p->normal, w->up), around);
    plt_lit_add(p, p->ray.weight, m.emission);
    plt_lit_add(p, diffuse, around);
    p->is_lit = !is_black(diffuse) || !is_black(m.specular);
}

/* 0: its back is to the light. */
static float cosine_to(const plt_whitted *w, const plt_lit_pixel *p, float to_light[3]) {
    const plt_light *light = &w->lighting.light[w->light];
    const float bright =
        plt_light_towards(light, w->sample, p->turn, p->ray.org, to_light) / light->samples;
    float along[3] = {to_light[0], to_light[1], to_light[2]};
    if (!(bright > 0.0f) || !plt_normalise(along)) {
        return 0.0f;
    }
    const float cosine = plt_optics_dot(along, p->normal);
    return cosine > 0.0f && plt_optics_dot(along, p->side) > 0.0f ? cosine : 0.0f;
}

uint32_t plt_direct_find(plt_whitted *w) {
    uint32_t count = 0;
    for (uint32_t k = 0; k < w->pixels; k++) {
        const plt_lit_pixel *p = &w->pixel[k];
        float to_light[3];
        if (p->state == PLT_LIT_HIT && p->is_lit && cosine_to(w, p, to_light) > 0.0f) {
            w->slot[count++] = (uint8_t)k;
        }
    }
    return count;
}

float plt_direct_ray(const plt_whitted *w, const plt_lit_pixel *p, float org[3], float dir[3]) {
    const plt_light *light = &w->lighting.light[w->light];
    plt_light_towards(light, w->sample, p->turn, p->ray.org, dir);
    for (int a = 0; a < 3; a++) {
        const float lift = p->side[a] * w->lift;
        org[a] = p->ray.org[a] + lift;
        dir[a] = light->kind == PLT_LIGHT_POINT ? dir[a] - lift : dir[a];
    }
    return light->kind == PLT_LIGHT_POINT ? BEFORE_LIGHT : FAR;
}

/* The light of a sample that reaches a hit. */
static void light_up(const plt_whitted *w, plt_lit_pixel *p) {
    const plt_light *light = &w->lighting.light[w->light];
    plt_material m;
    float diffuse[3], to[3], half[3];
    plt_materials_get(&w->materials, p->material, &m);
    set_diffuse(&m, p, diffuse);
    const float bright =
        plt_light_towards(light, w->sample, p->turn, p->ray.org, to) / light->samples;
    plt_normalise(to);
    for (int a = 0; a < 3; a++) {
        half[a] = to[a] - p->ray.dir[a];
    }
    const float facing = plt_optics_dot(to, p->normal);
    const float glint =
        plt_normalise(half) ? plt_optics_dot(half, p->normal) : 0.0f; /* it may be above 1 */
    const float shine =
        plt_optics_power(glint < 1.0f ? (glint > 0.0f ? glint : 0.0f) : 1.0f, m.exponent);
    for (int c = 0; c < 3; c++) {
        const float share = diffuse[c] * facing + p->ray.weight[c] * m.specular[c] * shine;
        p->colour[c] += light->power[c] * bright * share;
    }
}

void plt_direct_take(plt_whitted *w, const plt_packet *packet) {
    for (uint32_t i = 0; i < w->rays; i++) {
        const plt_group_rays *g = &packet->rays[i / 4];
        if (g->id[i % 4] == PLT_MISS) {
            light_up(w, &w->pixel[w->slot[i]]);
        }
    }
}

#endif
