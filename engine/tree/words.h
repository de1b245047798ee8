/* words - four words of an image as four lanes
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_WORDS_H
#define PLT_TREE_WORDS_H

#include "engine/base/bytes.h"
#include "engine/lanes/lanes.h"

#if PLT_LANES_REGISTERS && defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__

static inline f4 plt_words_load(const uint32_t *word) {
    return f4_load((const float *)(const void *)word);
}

/* One store, even where the next one covers its fourth word: three would take longer. */
static inline void plt_words_store(uint32_t *word, f4 a) {
    f4_store((float *)(void *)word, a);
}

#else

static inline f4 plt_words_load(const uint32_t *word) {
    float v[4];
    plt_get_floats(v, (const unsigned char *)word, 4);
    return f4_load(v);
}

static inline void plt_words_store(uint32_t *word, f4 a) {
    float v[4];
    f4_store(v, a);
    plt_put_floats((unsigned char *)word, v, 4);
}

#endif

#endif
