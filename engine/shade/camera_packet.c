/* camera_packet - the rays of a camera in groups of four, see camera.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/camera.h"

static void set_group(const plt_view *v, const plt_box *scene, plt_packet *p, unsigned index,
                      const uint32_t px[4], const uint32_t py[4], unsigned lanes) {
    f4 org[3], dir[3];
    float d[4][3];
    for (int i = 0; i < 4; i++) {
        plt_view_direction(v, px[i], py[i], d[i]);
    }
    for (int a = 0; a < 3; a++) {
        const float all[4] = {d[0][a], d[1][a], d[2][a], d[3][a]};
        org[a] = f4_all(v->eye[a]);
        dir[a] = f4_load(all);
    }
    /* Lanes outside the frame get an empty interval. */
    const f4 tmax = f4_select(m4_bits(lanes), f4_all(PLT_VIEW_FAR), f4_all(-1.0f));
    plt_packet_set_group(p, index, scene, org, dir, f4_zero(), tmax, 4);
}

void plt_view_packet(const plt_view *v, const plt_box *scene, plt_packet *p,
                     const plt_pixels *pixels) {
    const uint32_t rays = pixels->side * pixels->side;
    plt_packet_begin(p, rays / 4, 0);
    for (uint32_t k = 0; k < rays; k += 4) {
        uint32_t px[4], py[4];
        unsigned lanes = 0;
        for (uint32_t i = 0; i < 4; i++) {
            px[i] = pixels->x + plt_z_order_x(k + i);
            py[i] = pixels->y + plt_z_order_y(k + i);
            lanes |= (unsigned)(px[i] < pixels->x_end && py[i] < pixels->y_end) << i;
        }
        set_group(v, scene, p, k / 4, px, py, lanes);
    }
    plt_packet_finish(p);
}
