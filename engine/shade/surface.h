/* surface - from a hit to a colour
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_SURFACE_H
#define PLT_SHADE_SURFACE_H

#include "engine/trace/packet.h"

/* Colour of ray `lane` of the group, in a frame's row `y` of pixels. */
void plt_surface_colour(const plt_frame *frame, const plt_group_rays *rays, unsigned lane,
                        uint32_t y, uint8_t rgb[3]);

#endif
