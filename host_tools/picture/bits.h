/* bits - a growing string of bits, least significant first
 *
 * Invariant: `held` is below 8 between calls. When memory runs out `failed`
 * is set, later calls do nothing, and one check at the end is enough.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BITS_H
#define BITS_H
#include <stddef.h>
#include <stdint.h>

typedef struct bits {
    uint8_t *bytes; /* owned: bits_free */
    size_t size, room;
    uint64_t hold; /* bits not yet in `bytes` */
    unsigned held;
    int failed;
} bits;

/* Appends the low `count` (0 .. 32) bits of `value`; the rest must be 0. */
void bits_put(bits *b, uint32_t value, unsigned count);
void bits_align(bits *b); /* zero bits up to a whole byte */

/* Appends whole bytes; `b` must be aligned. */
void bits_bytes(bits *b, const uint8_t *bytes, size_t count);
void bits_big32(bits *b, uint32_t value); /* big-endian; aligned */
void bits_free(bits *b);

#endif
