/* between - whether floats of an image are in a range, by integers
 *
 * The bits of a float, if it is negative with all but the sign inverted, are in the order of
 * floats. So two comparisons are a subtraction and one, and no float is loaded.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BASE_BETWEEN_H
#define PLT_BASE_BETWEEN_H

#include "engine/base/bytes.h"

/* least .. least + span, in that order; -0 is the one next to 0. */
typedef struct plt_between {
    uint32_t least, span;
} plt_between;

/* lo .. hi of each axis; where not lo <= hi, nothing but -0 is between. */
void plt_between_set(plt_between axis[3], const float lo[3], const float hi[3]);

static inline uint32_t plt_float_order(uint32_t bits) {
    return bits ^ (0u - (bits >> 31)) >> 1;
}

/* lo <= x and x <= hi, of the float at `at`; false for a NaN. */
static inline int plt_is_between(const plt_between *b, const void *at) {
    return plt_float_order(plt_get_u32(at)) - b->least <= b->span;
}

#endif
