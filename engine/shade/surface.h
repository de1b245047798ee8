/* surface - from a hit to a colour
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_SURFACE_H
#define PLT_SHADE_SURFACE_H

#include "engine/planelet.h"

/* The colour of clay that faces the eye. */
#define PLT_CLAY_RED 1.0f
#define PLT_CLAY_GREEN 0.93f
#define PLT_CLAY_BLUE 0.84f

/* What the colours of all hits of a triangle have in common. */
typedef struct plt_surface {
    float normal[3]; /* its largest component is 1; or 0: a sliver */
    float squared;   /* normal . normal */
} plt_surface;

/* `normal`: of any length. */
void plt_surface_set(plt_surface *s, const float normal[3]);

/* What the colours of all hits that are seen along one direction have in common. */
typedef struct plt_sight {
    float dir[3];  /* its largest component is 1 or -1 */
    float squared; /* dir . dir */
} plt_sight;

/* |n . d| of both as unit vectors; of what is no sliver. */
static inline float plt_surface_facing(const plt_surface *s, const plt_sight *along) {
    const float *n = s->normal, *d = along->dir;
    const float dot = n[0] * d[0] + n[1] * d[1] + n[2] * d[2];
    return __builtin_sqrtf(dot * dot / (s->squared * along->squared));
}

/* Rounding may leave a facing some ulp above 1: only where clay is 1 that would show. */
static inline void plt_clay_colour(float facing, uint8_t rgb[3]) {
    const float limited = facing > 1.0f ? 1.0f : facing; /* never below 0 */
    rgb[0] = (uint8_t)(int32_t)(limited * PLT_CLAY_RED * 255.0f + 0.5f);
    rgb[1] = (uint8_t)(int32_t)(limited * PLT_CLAY_GREEN * 255.0f + 0.5f);
    rgb[2] = (uint8_t)(int32_t)(limited * PLT_CLAY_BLUE * 255.0f + 0.5f);
}

#if PLT_WITH_MIXES
/* `dir`: of any length. */
void plt_sight_set(plt_sight *s, const float dir[3]);

/* Colour of a hit of the triangle `id`, by any enum plt_shader. */
void plt_surface_any(const plt_surface *s, uint8_t shader, uint32_t id, const plt_sight *along,
                     uint8_t rgb[3]);

/* plt_surface_any, but eye light of what is no sliver is computed here, without a call. */
static inline void plt_surface_seen(const plt_surface *s, uint8_t shader, uint32_t id,
                                    const plt_sight *along, uint8_t rgb[3]) {
    if (s->squared == 0.0f || shader == PLT_SHADE_TRIANGLE || shader == PLT_SHADE_NORMAL) {
        plt_surface_any(s, shader, id, along, rgb);
    } else {
        plt_clay_colour(plt_surface_facing(s, along), rgb);
    }
}
#endif

/* Colour of one hit of the triangle `id`, seen along `dir`, which is of any length. `shader`: enum
 * plt_shader. */
void plt_surface_colour(const plt_surface *s, uint8_t shader, uint32_t id, const float dir[3],
                        uint8_t rgb[3]);

/* Colour where nothing is hit, in a frame's row `y` of pixels. */
void plt_surface_sky(const plt_frame *frame, uint32_t y, uint8_t rgb[3]);

#endif
