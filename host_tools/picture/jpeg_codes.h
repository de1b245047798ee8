/* jpeg_codes - coefficients as bits of a JPEG file
 *
 * SPDX-License-Identifier: MIT */
#ifndef JPEG_CODES_H
#define JPEG_CODES_H
#include <stddef.h>
#include <stdint.h>

enum { JPEG_DC_CODES = 12, JPEG_AC_CODES = 256 };

/* The code of each value, and its length in the lowest 5 bits; 0: there is none. */
typedef struct jpeg_book {
    uint32_t dc[JPEG_DC_CODES], ac[JPEG_AC_CODES];
} jpeg_book;

/* The tables of T.81, K.3 and K.5, or K.4 and K.6. */
void jpeg_book_set(jpeg_book *book, int chrominance);

/* A file that grows to `size`; what lies beyond `room` is counted only. */
typedef struct jpeg_file {
    uint8_t *bytes;
    size_t size, room;
    uint32_t hold; /* the lowest `held` bits are not yet in `bytes` */
    unsigned held; /* below 8 */
} jpeg_file;

void jpeg_byte(jpeg_file *f, unsigned byte);

/* Appends the low `count` (0 .. 24) bits of `bits`, the highest first; a byte of ones is stuffed
 * (T.81, F.1.2.3). */
void jpeg_bits(jpeg_file *f, uint32_t bits, unsigned count);

/* Fills a byte that has begun with ones. */
void jpeg_pad(jpeg_file *f);

/* Appends both segments of a kind's tables without their marker: the list of code lengths and the
 * values (T.81, B.2.4.2). */
void jpeg_code_tables(jpeg_file *f, int chrominance);

/* Appends a block of coefficients, -1023 .. 1023, row by row; `*dc` is that of the block of the
 * same component before, and becomes this one's (T.81, F.1.2). */
void jpeg_code_block(jpeg_file *f, const int16_t *block, const jpeg_book *book, int *dc);

#endif
