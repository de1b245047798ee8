/* camera_packet - the rays of a camera in groups of four, see camera.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/camera.h"

/* Four pixels, as plt_view_direction has each: two by two from (x, y) on. Whole numbers this
 * small are exact. */
static void set_group(const plt_view *v, plt_packet *p, unsigned index, uint32_t x, uint32_t y,
                      unsigned lanes) {
    static const float right[4] = {0, 1, 0, 1}, below[4] = {0, 0, 1, 1};
    const f4 px = f4_add(f4_all((float)x), f4_load(right));
    const f4 py = f4_add(f4_all((float)y), f4_load(below));
    f4 org[3], dir[3];
    for (int a = 0; a < 3; a++) {
        const f4 along_row = f4_add(f4_all(v->corner[a]), f4_mul(px, f4_all(v->right[a])));
        org[a] = f4_all(v->eye[a]);
        dir[a] = f4_add(along_row, f4_mul(py, f4_all(v->down[a])));
    }
    /* Lanes outside the frame get an empty interval. */
    const f4 tmax = f4_select(m4_bits(lanes), f4_all(PLT_VIEW_FAR), f4_all(-1.0f));
    plt_packet_set_group(p, index, org, dir, f4_zero(), tmax, 4);
}

void plt_view_packet(const plt_view *v, const plt_box *scene, plt_packet *p,
                     const plt_pixels *pixels) {
    const uint32_t rays = pixels->side * pixels->side;
    plt_packet_begin(p, scene, rays / 4, 0);
    plt_packet_want_normals(p);
    for (uint32_t k = 0; k < rays; k += 4) {
        const uint32_t x = pixels->x + plt_z_order_x(k), y = pixels->y + plt_z_order_y(k);
        const unsigned columns = (x < pixels->x_end ? 5u : 0u) | (x + 1 < pixels->x_end ? 10u : 0u);
        const unsigned rows = (y < pixels->y_end ? 3u : 0u) | (y + 1 < pixels->y_end ? 12u : 0u);
        set_group(v, p, k / 4, x, y, columns & rows);
    }
    plt_packet_finish(p);
}
