/* packet_shade - the colours of a packet's rays
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_PACKET_SHADE_H
#define PLT_SHADE_PACKET_SHADE_H

#include <string.h>

#include "engine/shade/camera.h"
#include "engine/shade/surface.h"
#include "engine/trace/packet.h"

/* Where the pixels of a packet of side^2 rays, in Z order, go: to x, y of a piece of the picture;
 * those that lie beyond it are left out. */
typedef struct plt_square {
    uint32_t side, x, y, width, height;
} plt_square;

static inline void plt_shade_lane(const plt_frame *frame, const plt_group_rays *g, unsigned lane,
                                  const uint8_t sky[3], uint8_t rgb[3]) {
    if (!(g->valid >> lane & 1u) || g->id[lane] == PLT_MISS) {
        memcpy(rgb, sky, 3);
        return;
    }
    const float normal[3] = {g->normal[0][lane], g->normal[1][lane], g->normal[2][lane]};
    const float dir[3] = {g->dir[0][lane], g->dir[1][lane], g->dir[2][lane]};
    plt_surface surface;
    plt_surface_set(&surface, normal);
    plt_surface_colour(&surface, frame->shader, g->id[lane], dir, rgb);
}

/* `sky`: three bytes per row of the piece; `rgb`: its rows. */
static inline void plt_packet_shade(const plt_packet *p, const plt_frame *frame,
                                    const plt_square *s, const uint8_t *sky, uint8_t *rgb) {
    for (uint32_t k = 0; k < s->side * s->side; k++) {
        const uint32_t x = s->x + plt_z_order_x(k), y = s->y + plt_z_order_y(k);
        if (x < s->width && y < s->height) {
            plt_shade_lane(frame, &p->rays[k / 4], k % 4, &sky[3 * y],
                           &rgb[3 * (y * s->width + x)]);
        }
    }
}

#endif
