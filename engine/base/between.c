/* between - see between.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/between.h"

#include "engine/base/float_bits.h"

#define MINUS_ZERO UINT32_MAX /* in the order of floats; 0, which equals it, is next to it */

static uint32_t order_of(float x, uint32_t of_zero) {
    return x == 0.0f ? of_zero : plt_float_order(plt_bits_of(x));
}

void plt_between_set(plt_between axis[3], const float lo[3], const float hi[3]) {
    for (int a = 0; a < 3; a++) {
        const int is_range = lo[a] <= hi[a];
        axis[a].least = is_range ? order_of(lo[a], MINUS_ZERO) : MINUS_ZERO;
        axis[a].span = is_range ? order_of(hi[a], 0) - axis[a].least : 0;
    }
}
