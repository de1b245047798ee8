/* record_put - the corners of a triangle into its record
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_RECORD_PUT_H
#define PLT_TREE_RECORD_PUT_H

#include "engine/tree/canonical.h"
#include "engine/tree/record.h"

/* By x, then y, then z. Which it is cannot be predicted, so there is no jump. */
static inline int plt_corner_below(const float a[3], const float b[3]) {
    const int y = (a[1] < b[1]) | ((a[1] == b[1]) & (a[2] < b[2]));
    return (a[0] < b[0]) | ((a[0] == b[0]) & y);
}

/* Index of the least of three corners. Mostly x alone decides, which is what a jump is for. */
static inline uint32_t plt_corners_first(const float corner[9]) {
    const float a = corner[0], b = corner[3], c = corner[6];
    if ((a == b) | (a == c) | (b == c)) {
        return plt_canonical_first(plt_corner_below(corner + 3, corner),
                                   plt_corner_below(corner + 6, corner),
                                   plt_corner_below(corner + 6, corner + 3));
    }
    return plt_canonical_first(b < a, c < a, c < b);
}

/* Nine floats, x, y and z of three corners, in canonical order; the id word keeps what it has but
 * for the rotation. */
static inline void plt_record_put(plt_record *r, const float corner[9]) {
    static const uint8_t at[3][3] = {{0, 3, 6}, {3, 6, 0}, {6, 0, 3}};
    const uint32_t first = plt_corners_first(corner);
    const uint32_t word = plt_get_u32(&r->word[9]) & ~(3u << PLT_PRIMITIVE_ROTATION_SHIFT);
    unsigned char *to = (unsigned char *)r->word;
    plt_put_floats(to, corner + at[first][0], 3);
    plt_put_floats(to + 12, corner + at[first][1], 3);
    plt_put_floats(to + 24, corner + at[first][2], 3);
    plt_put_u32(&r->word[9], word | plt_canonical_rotation(first) << PLT_PRIMITIVE_ROTATION_SHIFT);
}

#endif
