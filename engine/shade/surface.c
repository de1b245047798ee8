/* surface - see surface.h
 *
 * Eye-light shading is the thesis's (section 5.1): a surface is as bright as
 * it faces the eye, |n . d| of unit vectors. Colours are our choice.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/surface.h"

#include "engine/lanes/unroll.h"

/* 0 .. 1 to 0 .. 255, to nearest. */
static uint8_t byte_of(float x) {
    const float limited = x < 0.0f ? 0.0f : (x > 1.0f ? 1.0f : x);
    return (uint8_t)(limited * 255.0f + 0.5f);
}

static float dot(const float a[3], const float b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Brings the largest component to 1 (or leaves zero), so that a dot product
 * of any mesh's normals neither vanishes nor overflows. */
static inline void even_out(const float v[3], float to[3]) {
    const float x = __builtin_fabsf(v[0]), y = __builtin_fabsf(v[1]), z = __builtin_fabsf(v[2]);
    float most = x > y ? x : y;
    most = z > most ? z : most;
    most = most > 0.0f ? most : 1.0f;
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        to[a] = v[a] / most;
    }
}

/* The sky: a little lighter towards the ground; or the background. */
void plt_surface_sky(const plt_frame *frame, uint32_t y, uint8_t rgb[3]) {
    static const float top[3] = {0.10f, 0.12f, 0.16f}, bottom[3] = {0.30f, 0.34f, 0.40f};
#if PLT_WITH_BACKGROUND
    if (frame->has_background) {
        rgb[0] = frame->background[0];
        rgb[1] = frame->background[1];
        rgb[2] = frame->background[2];
        return;
    }
#endif
    const float down = ((float)y + 0.5f) / (float)frame->height;
    for (int c = 0; c < 3; c++) {
        rgb[c] = byte_of(top[c] + down * (bottom[c] - top[c]));
    }
}

static void flat_colour(uint32_t id, float facing, uint8_t rgb[3]) {
    uint32_t mixed = (id + 1) * 0x9E3779B1u; /* golden ratio: neighbours differ */
    mixed ^= mixed >> 15;
    for (int c = 0; c < 3; c++) {
        const float tint = 0.35f + 0.65f * (float)(mixed >> 8 * c & 0xFF) / 255.0f;
        rgb[c] = byte_of(tint * (0.4f + 0.6f * facing));
    }
}

static void normal_colour(const float normal[3], float squared, float along, uint8_t rgb[3]) {
    const float length = __builtin_sqrtf(squared);
    for (int c = 0; c < 3; c++) {
        const float to_eye = (along > 0.0f ? -normal[c] : normal[c]) / length;
        rgb[c] = byte_of(0.5f + 0.5f * to_eye);
    }
}

void plt_surface_set(plt_surface *s, const float normal[3]) {
    even_out(normal, s->normal);
    s->squared = dot(s->normal, s->normal);
}

static inline void look_along(plt_sight *s, const float dir[3]) {
    even_out(dir, s->dir);
    s->squared = dot(s->dir, s->dir);
}

static inline void any_colour(const plt_surface *s, uint8_t shader, uint32_t id,
                              const plt_sight *along, uint8_t rgb[3]) {
    plt_surface facing_eye;
    if (s->squared == 0.0f) { /* a sliver: as if it faced the eye */
        for (int a = 0; a < 3; a++) {
            facing_eye.normal[a] = -along->dir[a];
        }
        facing_eye.squared = along->squared;
        s = &facing_eye;
    }
    const float facing = plt_surface_facing(s, along);
    switch (shader) {
    case PLT_SHADE_TRIANGLE:
        flat_colour(id, facing, rgb);
        break;
    case PLT_SHADE_NORMAL:
        normal_colour(s->normal, s->squared, dot(s->normal, along->dir), rgb);
        break;
    default:
        plt_clay_colour(facing, rgb);
        break;
    }
}

#if PLT_WITH_MIXES
__attribute__((noinline)) void plt_sight_set(plt_sight *s, const float dir[3]) {
    look_along(s, dir);
}

void plt_surface_any(const plt_surface *s, uint8_t shader, uint32_t id, const plt_sight *along,
                     uint8_t rgb[3]) {
    any_colour(s, shader, id, along, rgb);
}
#endif

void plt_surface_colour(const plt_surface *s, uint8_t shader, uint32_t id, const float dir[3],
                        uint8_t rgb[3]) {
    plt_sight along;
#if PLT_WITH_MIXES
    plt_sight_set(&along, dir);
    plt_surface_seen(s, shader, id, &along, rgb);
#else
    look_along(&along, dir);
    any_colour(s, shader, id, &along, rgb);
#endif
}
