/* block_decoder_bytes - bits, numbers and checksums, one bit at a time
 *
 * A read beyond the end returns 0 and sets `overrun`; memory there is not accessed.
 *
 * Source: SPEC.md, sections 2, 4.1 and 4.8.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_BLOCK_DECODER_BYTES_H
#define REFERENCE_BLOCK_DECODER_BYTES_H
#include <stddef.h>
#include <stdint.h>

typedef struct decoder_bytes {
    const unsigned char *at;
    size_t size;
    int overrun; /* a read beyond the end was requested */
} decoder_bytes;

/* The number of `width` bits, 32 at most, whose least bit is bit `bit`. */
uint32_t decoder_bits(decoder_bytes *bytes, size_t bit, unsigned width);

/* Little-endian numbers at byte `at`. */
uint32_t decoder_u16(decoder_bytes *bytes, size_t at);
uint32_t decoder_u32(decoder_bytes *bytes, size_t at);
float decoder_float(decoder_bytes *bytes, size_t at);

/* Ones among bits from .. to - 1 of the string that begins at bit `string`. */
uint32_t decoder_ones(decoder_bytes *bytes, size_t string, uint32_t from, uint32_t to);

/* Whether all bits from .. to - 1 are 0. */
int decoder_is_zero(decoder_bytes *bytes, size_t from, size_t to);

/* The least w with x < 2^w. */
unsigned decoder_width(uint32_t x);

/* CRC-32 of `size` bytes; the `hole_bytes` from `hole` on are taken as 0. */
uint32_t decoder_crc(const unsigned char *bytes, size_t size, size_t hole, size_t hole_bytes);

#endif
