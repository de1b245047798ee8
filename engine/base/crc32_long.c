/* crc32_long - see crc32_long.h
 *
 * Words of 32 bits are coefficients of a polynomial in y = x^32. As squaring is linear modulo 2,
 * Q(x)^32 = Q(x^32): a multiple of the CRC's polynomial in x is one in y, too. This one has only
 * five terms:
 *
 *     y^300 + y^155 + y^117 + y^89 + 1
 *
 * So a word may be taken away from the message if it is added to the words that are 145, 183, 211
 * and 300 behind it, and the checksum stays the same. All are taken away but the last 300, for
 * which plt_crc32 is left.
 *
 * Source: Russell, "Chorba: a novel CRC32 implementation", 2024.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/crc32_long.h"

#include <string.h>

#include "engine/base/bytes.h"
#include "engine/planelet_crc32.h"

enum { NEAR = 145, MIDDLE = 183, FAR = 211, ALL = 300 };

/* A word of the message with what is added to it, of the words before it. */
static inline uint32_t sum_at(const uint32_t *before, const unsigned char *bytes) {
    uint32_t word; /* in the machine's order, as all are */
    memcpy(&word, bytes, sizeof word);
    return word ^ before[0] ^ before[ALL - FAR] ^ before[ALL - MIDDLE] ^ before[ALL - NEAR];
}

/* A multiple of 4 of them. */
static void add(uint32_t *to, const uint32_t *before, size_t words, const unsigned char *bytes) {
    for (const unsigned char *end = bytes + 4 * words; bytes != end; bytes += 16) {
        to[0] = sum_at(before, bytes);
        to[1] = sum_at(before + 1, bytes + 4);
        to[2] = sum_at(before + 2, bytes + 8);
        to[3] = sum_at(before + 3, bytes + 12);
        to += 4;
        before += 4;
    }
}

uint32_t plt_crc32_long(const void *bytes, size_t count, uint32_t *scratch, size_t words) {
    const unsigned char *from = bytes;
    if (count < 16 * ALL || words < 2 * ALL - NEAR) {
        return plt_crc32(0, bytes, count);
    }
    memset(scratch, 0, 4 * ALL);
    plt_put_u32(scratch, UINT32_MAX); /* what the checksum begins with, on the first word */
    for (size_t left = count / 16 * 4 - ALL; left > 0;) {
        const size_t room = (words - ALL) / 4 * 4, now = left < room ? left : room;
        add(scratch + ALL, scratch, now, from);
        for (int i = 0; i < ALL; i++) {
            scratch[i] = scratch[now + i];
        }
        from += 4 * now;
        left -= now;
    }
    memset(scratch + ALL, 0, 4 * (ALL - NEAR)); /* the last words are added to none */
    add(scratch, scratch, ALL, from);
    return plt_crc32(plt_crc32(UINT32_MAX, scratch, 4 * ALL), from + 4 * ALL, count % 16);
}
