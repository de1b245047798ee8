/* record_rows - the corners of a record in registers
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_RECORD_ROWS_H
#define PLT_TREE_RECORD_ROWS_H

#include "engine/lanes/lanes.h"
#include "engine/tree/record.h"

/* A corner each, x, y, z; the fourth lane means nothing. Of the last it is not the id, which as a
 * float is subnormal: arithmetic on it took packets over the dragon 9 % of their time. */
static inline void plt_record_rows(const plt_record *r, f4 corner[3]) {
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    float c[3][3 + 1] = {{0.0f}};
    for (int i = 0; i < 9; i++) {
        c[i / 3][i % 3] = plt_record_float(r, i / 3, i % 3);
    }
    corner[0] = f4_load(c[0]);
    corner[1] = f4_load(c[1]);
    corner[2] = f4_load(c[2]);
#else
    const float *word = (const float *)(const void *)r->word;
    corner[0] = f4_load(word);
    corner[1] = f4_load(word + 3);
    corner[2] = f4_rotate(f4_load(word + 5));
#endif
}

#endif
