/* mutations - damage to an image, always the same from the same seed
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOSTILE_MUTATIONS_H
#define HOSTILE_MUTATIONS_H

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "engine/base/bytes.h"
#include "tests/reference/random.h"

/* PLANELET_SOAK=1 asks for a hundred times as many. */
static inline uint32_t mutations_of(uint32_t usual) {
    const char *soak = getenv("PLANELET_SOAK");
    return usual * (soak != NULL && soak[0] == '1' ? 100 : 1);
}

/* Counts, offsets and floats at the ends of what is valid, and beyond. */
static inline uint32_t mutation_word(random_state *r) {
    static const uint32_t words[] = {
        0,          1,          2,          3,          8,          31,         33,
        48,         63,         64,         255,        0xFFFF,     0x07FFFFFF, 0x53800000,
        0x53800001, 0x7F800000, 0x7FC00000, 0x7FFFFFFF, 0x80000000, 0xFF800000, 0xFFFFFFFF};
    return words[random_below(r, sizeof words / sizeof words[0])];
}

/* Byte `at`, or the word it is in, becomes something else. An image has 4 bytes or more. */
static inline void mutate_at(unsigned char *image, uint32_t size, uint32_t at, random_state *r) {
    static const uint32_t steps[] = {1, 4, 32};
    unsigned char *word = image + (at & ~3u) % (size - 3);
    switch (random_below(r, 6)) {
    case 0:
        image[at] ^= (unsigned char)(1u << random_below(r, 8));
        break;
    case 1:
        image[at] = (unsigned char)random_bits(r);
        break;
    case 2:
    case 3:
        plt_put_u32(word, mutation_word(r));
        break;
    case 4:
        plt_put_u32(word, plt_get_u32(word) + steps[random_below(r, 3)] * (random_below(r, 7) - 3));
        break;
    default:
        memmove(word, image + (random_below(r, size) & ~3u) % (size - 3), 4);
    }
}

#endif
