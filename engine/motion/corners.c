/* corners - see corners.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/corners.h"

#include "engine/lanes/lanes.h"
#include "engine/planelet.h"
#include "engine/tree/record_put.h"

/* Triangles whose corners are asked for before their turn: records lie in the order of the tree. */
enum { AHEAD = 24 };

static int in_range(f4 x) {
    return m4_mask(f4_le(f4_abs(x), f4_all(PLT_COORD_MAX))) == 15; /* not for a NaN */
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

static inline uint32_t id_of(const plt_record *r) {
    return plt_primitive_id(plt_get_u32(&r->word[9]));
}

void plt_corners_put(plt_record *records, uint32_t count, const float (*corners)[9]) {
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t ahead = i + AHEAD < count ? i + AHEAD : i;
        const float *next = corners[id_of(&records[ahead])];
        plt_prefetch(next);
        plt_prefetch(next + 8);
        plt_record_put(&records[i], corners[id_of(&records[i])]);
    }
}
