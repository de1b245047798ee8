/* surface - from a hit to a colour
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_SURFACE_H
#define PLT_SHADE_SURFACE_H

#include "engine/engine.h"

/* Colour of ray `lane` of group `g`, seen from pixel row `y` of the frame. */
void plt_surface_colour(const plt_engine *e, const plt_group *g, unsigned lane, uint32_t y,
                        uint8_t rgb[3]);

#endif
