/* corners - see corners.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/corners.h"

#include "engine/lanes/lanes.h"
#include "engine/motion/least_corners.h"
#include "engine/planelet.h"
#include "engine/tree/record_put.h"
#include "engine/tree/words.h"

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

/* Asks for the corners of record `i`. */
static inline void ask_for(const plt_record *records, uint32_t i, uint32_t count,
                           const float (*corners)[9]) {
    const float *next = corners[id_of(&records[i < count ? i : count - 1])];
    plt_prefetch(next);
    plt_prefetch(next + 8);
}

#if PLT_LANES_REGISTERS

enum { FOUR = 4 };

/* The corners of four triangles in lanes; and each one's as nine words from any of them on. */
typedef struct corners_of_four {
    f4 lanes[3][FOUR];
    float round[FOUR][16];
} corners_of_four;

/* The last corner is had without the word behind it, of which there may be none. */
PLT_INLINED void look_up(corners_of_four *to, uint32_t i, const float corner[9]) {
    const f4 a = f4_load(corner), b = f4_load(corner + 3), c = f4_rotate(f4_load(corner + 5));
    to->lanes[0][i] = a;
    to->lanes[1][i] = b;
    to->lanes[2][i] = c;
    f4_store(&to->round[i][0], a);
    f4_store(&to->round[i][3], b);
    f4_store(&to->round[i][6], c);
    f4_store(&to->round[i][9], a);
    f4_store(&to->round[i][12], b);
}

PLT_INLINED void find_first(plt_least4 *to, const corners_of_four *from) {
    plt_corner4 corner[3];
    for (int k = 0; k < 3; k++) {
        const f4 *lanes = from->lanes[k];
        corner[k] = plt_corner4_of(lanes[0], lanes[1], lanes[2], lanes[3]);
    }
    plt_least_corners(to, corner);
}

/* Its word is read before corners are written, whose fourth lane covers it for a while. */
PLT_INLINED void put_one(plt_record *r, const float *first, uint32_t rotation) {
    const uint32_t rest = plt_get_u32(&r->word[9]) & ~(3u << PLT_PRIMITIVE_ROTATION_SHIFT);
    plt_words_store(&r->word[0], f4_load(first));
    plt_words_store(&r->word[3], f4_load(first + 3));
    plt_words_store(&r->word[6], f4_load(first + 6));
    plt_put_u32(&r->word[9], rest | rotation);
}

void plt_corners_put(plt_record *records, uint32_t count, const float (*corners)[9]) {
    uint32_t i = 0;
    for (; i + FOUR <= count; i += FOUR) {
        corners_of_four four;
        plt_least4 least;
        PLT_UNROLLED for (uint32_t k = 0; k < FOUR; k++) {
            ask_for(records, i + k + AHEAD, count, corners);
            look_up(&four, k, corners[id_of(&records[i + k])]);
        }
        find_first(&least, &four);
        PLT_UNROLLED for (uint32_t k = 0; k < FOUR; k++) {
            put_one(&records[i + k], &four.round[k][3 * least.first[k]], least.rotation[k]);
        }
    }
    for (; i < count; i++) {
        plt_record_put(&records[i], corners[id_of(&records[i])]);
    }
}

#else

void plt_corners_put(plt_record *records, uint32_t count, const float (*corners)[9]) {
    for (uint32_t i = 0; i < count; i++) {
        ask_for(records, i + AHEAD, count, corners);
        plt_record_put(&records[i], corners[id_of(&records[i])]);
    }
}

#endif
