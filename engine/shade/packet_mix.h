/* packet_mix - the colours of a packet of samples, and of distances
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_PACKET_MIX_H
#define PLT_SHADE_PACKET_MIX_H

#include "engine/shade/sampling.h"

/* Of a square of samples that plt_view_packet has set up and that is traced, the pixels that lie in
 * the frame; `sky`: of each row of pixels where nothing is hit, 3 bytes; rows are `row_bytes`
 * apart. Adaptive: also sets s->mixed. */
void plt_packet_mix(const plt_packet *packet, plt_sampling *s, const plt_pixels *pixels,
                    const uint8_t *sky, uint8_t *rgb, uint32_t row_bytes);

#endif
