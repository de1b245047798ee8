/* canonical - the order of a triangle's corners
 *
 * The least corner, by x, then y, then z, comes first; the cyclic order stays. The
 * arithmetic on a triangle then does not depend on how a format stores it.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_CANONICAL_H
#define PLT_TREE_CANONICAL_H

#include <stdint.h>

/* Index of the least of corners a, b, c, of equals the first. Which it is cannot be
 * predicted, so there is no branch. */
static inline uint32_t plt_canonical_first(int b_below_a, int c_below_a, int c_below_b) {
    static const uint8_t first[8] = {0, 1, 2, 1, 0, 2, 2, 2};
    return first[(b_below_a != 0) | (c_below_a != 0) << 1 | (c_below_b != 0) << 2];
}

/* The rotation of a triangle whose corner `first` comes first now: its corner j became
 * corner (rotation + j) % 3. */
static inline uint32_t plt_canonical_rotation(uint32_t first) {
    return (first << 1 | first >> 1) & 3u; /* 3 - first, but 0 of 0 */
}

#endif
