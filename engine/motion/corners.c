/* corners - see corners.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/corners.h"

#include "engine/lanes/lanes.h"
#include "engine/planelet.h"
#include "engine/tree/canonical.h"

/* Triangles whose corners are asked for before their turn: records lie in the order of the tree. */
enum { AHEAD = 12 };

static int in_range(f4 x) {
    const m4 below = f4_le(x, f4_all(PLT_COORD_MAX)), above = f4_le(f4_all(-PLT_COORD_MAX), x);
    return (m4_mask(below) & m4_mask(above)) == 15; /* not for a NaN */
}

/* Of four triangles, 36 floats. */
static int all_in_range(const float *corners) {
    unsigned all = 1;
    for (unsigned k = 0; k < 36; k += 4) {
        all &= (unsigned)in_range(f4_load(corners + k));
    }
    return (int)all;
}

static int is_in_range(const float corner[9]) {
    return in_range(f4_load(corner)) && in_range(f4_load(corner + 4)) &&
           in_range(f4_all(corner[8]));
}

uint32_t plt_corners_refused(const float (*corners)[9], uint32_t count) {
    uint32_t i = 0;
    while (i + 4 <= count && all_in_range(corners[i])) {
        i += 4;
    }
    while (i < count && is_in_range(corners[i])) {
        i++;
    }
    return i;
}

/* Which it is cannot be predicted, so there is no jump. */
static inline int is_below(const float a[3], const float b[3]) {
    const int y = (a[1] < b[1]) | ((a[1] == b[1]) & (a[2] < b[2]));
    return (a[0] < b[0]) | ((a[0] == b[0]) & y);
}

static inline void put(plt_record *r, const float corner[9]) {
    const uint32_t first =
        plt_canonical_first(is_below(corner + 3, corner), is_below(corner + 6, corner),
                            is_below(corner + 6, corner + 3));
    const uint32_t second = first < 2 ? first + 1 : 0, third = second < 2 ? second + 1 : 0;
    const uint32_t word = plt_get_u32(&r->word[9]) & ~(3u << PLT_PRIMITIVE_ROTATION_SHIFT);
    unsigned char *at = (unsigned char *)r->word;
    plt_put_floats(at, corner + 3 * first, 3);
    plt_put_floats(at + 12, corner + 3 * second, 3);
    plt_put_floats(at + 24, corner + 3 * third, 3);
    plt_put_u32(&r->word[9], word | plt_canonical_rotation(first) << PLT_PRIMITIVE_ROTATION_SHIFT);
}

static inline uint32_t id_of(const plt_record *r) {
    return plt_primitive_id(plt_get_u32(&r->word[9]));
}

void plt_corners_put(plt_record *records, uint32_t count, const float (*corners)[9]) {
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t ahead = i + AHEAD < count ? i + AHEAD : i;
        const float *next = corners[id_of(&records[ahead])];
        plt_prefetch(next);
        plt_prefetch(next + 8);
        put(&records[i], corners[id_of(&records[i])]);
    }
}
