/* camera - rays through pixel centres
 *
 * Pixel (x, y) looks along corner + x * right + y * down, computed in this
 * order: the same bits in every packet and on every machine.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_CAMERA_H
#define PLT_SHADE_CAMERA_H

#include "engine/engine.h"

/* Fills corner, right and down. PLT_ERR_ARGUMENT: eye and look coincide, up
 * runs along the view, or a value is out of range. */
int plt_camera_setup(plt_rendering *r);

/* Sets up the packet whose top left pixel is (x, y); pixels from `x_end` and
 * `y_end` on get no rays. */
void plt_camera_packet(plt_engine *e, uint32_t x, uint32_t y, uint32_t x_end, uint32_t y_end);

/* Pixel k of a packet in Z order: x from the even bits, y from the odd ones. */
static inline uint32_t plt_z_order_x(uint32_t k) {
    return (k & 1u) | (k >> 1 & 2u) | (k >> 2 & 4u) | (k >> 3 & 8u);
}

static inline uint32_t plt_z_order_y(uint32_t k) {
    return plt_z_order_x(k >> 1);
}

#endif
