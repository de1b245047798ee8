/* pixel_shade - the colours of a packet, pixel by pixel
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_PIXEL_SHADE_H
#define PLT_SHADE_PIXEL_SHADE_H

#include <string.h>

#include "engine/shade/camera.h"
#include "engine/shade/surface.h"

static inline void plt_shade_lane(const plt_frame *frame, const plt_group_rays *g, int is_empty,
                                  unsigned lane, const uint8_t sky[3], uint8_t rgb[3]) {
    if (is_empty || !(g->valid >> lane & 1u) || g->id[lane] == PLT_MISS) {
        memcpy(rgb, sky, 3);
        return;
    }
    float normal[3], dir[3];
    plt_surface surface;
    for (int a = 0; a < 3; a++) {
        normal[a] = g->normal[a][lane];
        dir[a] = g->dir[a][lane];
    }
    plt_surface_set(&surface, normal);
    plt_surface_colour(&surface, frame->shader, g->id[lane], dir, rgb);
}

/* Of a square of pixels that plt_view_packet has set up and that is traced, those in the frame;
 * `sky`: of each row where nothing is hit, 3 bytes; rows of pixels are `row_bytes` apart.
 * `is_empty`: the packet has no ray, and its groups may not be set up. */
static inline void plt_shade_pixels(const plt_packet *p, int is_empty, const plt_frame *frame,
                                    const plt_pixels *pixels, const uint8_t *sky, uint8_t *rgb,
                                    uint32_t row_bytes) {
    const uint32_t columns = pixels->x_end - pixels->x, rows = pixels->y_end - pixels->y;
    for (uint32_t k = 0; k < pixels->side * pixels->side; k++) {
        const uint32_t x = plt_z_order_x(k), y = plt_z_order_y(k);
        if (x < columns && y < rows) {
            plt_shade_lane(frame, &p->rays[k / 4], is_empty, k % 4, &sky[3 * y],
                           &rgb[y * row_bytes + 3 * x]);
        }
    }
}

#endif
