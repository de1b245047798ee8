/* leaf_block - up to four triangles side by side, for one ray
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_LEAF_BLOCK_H
#define PLT_TRACE_LEAF_BLOCK_H

#include "engine/base/bytes.h"
#include "engine/lanes/lanes.h"
#include "engine/tree/bvh4.h"
#include "engine/tree/record.h"

/* Four words of the image. */
static inline f4 plt_words(const uint32_t word[4]) {
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    return f4_load((const float *)(const void *)word);
#else
    uint32_t own[4];
    for (int i = 0; i < 4; i++) {
        own[i] = plt_get_u32(&word[i]);
    }
    return f4_load((const float *)(const void *)own);
#endif
}

/* The longest sides of four triangles' boxes. */
static inline f4 plt_block_longest(const plt_bvh4_block *b) {
    f4 side[3];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 p = f4_load(b->corner[0][a]), q = f4_load(b->corner[1][a]),
                 s = f4_load(b->corner[2][a]);
        side[a] = f4_sub(f4_max(f4_max(p, q), s), f4_min(f4_min(p, q), s));
    }
    return f4_max(f4_max(side[0], side[1]), side[2]);
}

/* Corners are there, in all four lanes; `count` of them are triangles (bvh4.h). */
static inline void plt_block_count(plt_bvh4_block *b, unsigned count) {
    float longest[4];
    f4_store(longest, plt_block_longest(b));
    for (unsigned lane = 0; lane < 4; lane++) {
        b->longest[lane] = lane < count ? longest[lane] : -__builtin_inff();
    }
}

/* From records; those behind the first `count` may be any. */
static inline void plt_block_of_records(plt_bvh4_block *b, const plt_record *const at[4],
                                        unsigned count) {
    f4 row[3][4];
    PLT_UNROLLED for (unsigned lane = 0; lane < 4; lane++) {
        row[0][lane] = plt_words(&at[lane]->word[0]);
        row[1][lane] = plt_words(&at[lane]->word[4]);
        row[2][lane] = plt_words(&at[lane]->word[6]);
    }
    PLT_UNROLLED for (unsigned i = 0; i < 3; i++) {
        f4_transpose(&row[i][0], &row[i][1], &row[i][2], &row[i][3]);
    }
    PLT_UNROLLED for (unsigned i = 0; i < 4; i++) {
        f4_store(b->corner[i / 3][i % 3], row[0][i]);
        f4_store(b->corner[(i + 4) / 3][(i + 4) % 3], row[1][i]);
    }
    f4_store(b->corner[2][2], row[2][2]);
    f4_store((float *)(void *)b->word, row[2][3]); /* bits are moved, not computed with */
    plt_block_count(b, count);
}

#endif
