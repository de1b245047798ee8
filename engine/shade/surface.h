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

/* Colour of a hit of the triangle `id`, seen along `dir`. `shader`: enum plt_shader. */
void plt_surface_colour(const plt_surface *s, uint8_t shader, uint32_t id, const float dir[3],
                        uint8_t rgb[3]);

/* Colour where nothing is hit, in a frame's row `y` of pixels. */
void plt_surface_sky(const plt_frame *frame, uint32_t y, uint8_t rgb[3]);

#endif
