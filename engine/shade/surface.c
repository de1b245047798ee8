/* surface - see surface.h
 *
 * Eye-light shading is the thesis's (section 5.1): a surface is as bright as
 * it faces the eye, |n . d| of unit vectors. Colours are our choice.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/surface.h"

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
static void even_out(float v[3]) {
    float most = 0.0f;
    for (int a = 0; a < 3; a++) {
        const float size = __builtin_fabsf(v[a]);
        most = size > most ? size : most;
    }
    for (int a = 0; a < 3 && most > 0.0f; a++) {
        v[a] /= most;
    }
}

/* The sky: a little lighter towards the ground. */
static void background(const plt_frame *frame, uint32_t y, uint8_t rgb[3]) {
    static const float top[3] = {0.10f, 0.12f, 0.16f}, bottom[3] = {0.30f, 0.34f, 0.40f};
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

void plt_surface_colour(const plt_frame *frame, const plt_group_rays *g, unsigned lane, uint32_t y,
                        uint8_t rgb[3]) {
    static const float clay[3] = {1.0f, 0.93f, 0.84f};
    if (!(g->valid >> lane & 1u) || g->id[lane] == PLT_MISS) {
        background(frame, y, rgb);
        return;
    }
    float normal[3] = {g->normal[0][lane], g->normal[1][lane], g->normal[2][lane]};
    float dir[3] = {g->dir[0][lane], g->dir[1][lane], g->dir[2][lane]};
    even_out(normal);
    even_out(dir);
    if (dot(normal, normal) == 0.0f) { /* a sliver: as if it faced the eye */
        for (int a = 0; a < 3; a++) {
            normal[a] = -dir[a];
        }
    }
    const float along = dot(normal, dir);
    const float facing = __builtin_sqrtf(along * along / (dot(normal, normal) * dot(dir, dir)));
    if (frame->shader == PLT_SHADE_TRIANGLE) {
        flat_colour(g->id[lane], facing, rgb);
        return;
    }
    const float length = __builtin_sqrtf(dot(normal, normal));
    for (int c = 0; c < 3; c++) {
        const float to_eye = (along > 0.0f ? -normal[c] : normal[c]) / length;
        rgb[c] = frame->shader == PLT_SHADE_NORMAL ? byte_of(0.5f + 0.5f * to_eye)
                                                   : byte_of(facing * clay[c]);
    }
}
