/* packet_shade - the colours of a packet of groups
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_PACKET_SHADE_H
#define PLT_SHADE_PACKET_SHADE_H

#include "engine/shade/pixel_shade.h"

#define PLT_SHADES_IN_LANES (PLT_LANES_REGISTERS && PLT_WITH_HULLS)

#if PLT_SHADES_IN_LANES
/* As plt_shade_pixels. */
void plt_packet_shade(const plt_packet *packet, const plt_frame *frame, const plt_pixels *pixels,
                      const uint8_t *sky, uint8_t *rgb, uint32_t row_bytes);
#else
static inline void plt_packet_shade(const plt_packet *packet, const plt_frame *frame,
                                    const plt_pixels *pixels, const uint8_t *sky, uint8_t *rgb,
                                    uint32_t row_bytes) {
    plt_shade_pixels(packet, 0, frame, pixels, sky, rgb, row_bytes);
}
#endif

#endif
