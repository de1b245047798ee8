/* jpeg_codes - see jpeg_codes.h
 *
 * Codes are numbered from the lists of T.81, tables K.3 to K.6, as a decoder does.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/jpeg_codes.h"

#include <string.h>

#include "host_tools/picture/jpeg_block.h"

enum {
    LENGTHS = 16,
    LENGTH_BITS = 5,
    DC_VALUES = JPEG_DC_CODES,
    AC_VALUES = 162,
    END_OF_BLOCK = 0x00, /* of AC: run of zeros in the upper half, bits that follow in the lower */
    SIXTEEN_ZEROS = 0xF0
};

/* ---- tables ---------------------------------------------------------------------------- */

typedef struct code_list {
    uint8_t of_length[LENGTHS]; /* codes of 1, 2, ... bits */
    const uint8_t *values;
    uint8_t count;
} code_list;

static const uint8_t dc_values[DC_VALUES] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};

static const uint8_t ac_values[2][AC_VALUES] = {
    {0x01, 0x02, 0x03, 0x00, 0x04, 0x11, 0x05, 0x12, 0x21, 0x31, 0x41, 0x06, 0x13, 0x51, 0x61,
     0x07, 0x22, 0x71, 0x14, 0x32, 0x81, 0x91, 0xA1, 0x08, 0x23, 0x42, 0xB1, 0xC1, 0x15, 0x52,
     0xD1, 0xF0, 0x24, 0x33, 0x62, 0x72, 0x82, 0x09, 0x0A, 0x16, 0x17, 0x18, 0x19, 0x1A, 0x25,
     0x26, 0x27, 0x28, 0x29, 0x2A, 0x34, 0x35, 0x36, 0x37, 0x38, 0x39, 0x3A, 0x43, 0x44, 0x45,
     0x46, 0x47, 0x48, 0x49, 0x4A, 0x53, 0x54, 0x55, 0x56, 0x57, 0x58, 0x59, 0x5A, 0x63, 0x64,
     0x65, 0x66, 0x67, 0x68, 0x69, 0x6A, 0x73, 0x74, 0x75, 0x76, 0x77, 0x78, 0x79, 0x7A, 0x83,
     0x84, 0x85, 0x86, 0x87, 0x88, 0x89, 0x8A, 0x92, 0x93, 0x94, 0x95, 0x96, 0x97, 0x98, 0x99,
     0x9A, 0xA2, 0xA3, 0xA4, 0xA5, 0xA6, 0xA7, 0xA8, 0xA9, 0xAA, 0xB2, 0xB3, 0xB4, 0xB5, 0xB6,
     0xB7, 0xB8, 0xB9, 0xBA, 0xC2, 0xC3, 0xC4, 0xC5, 0xC6, 0xC7, 0xC8, 0xC9, 0xCA, 0xD2, 0xD3,
     0xD4, 0xD5, 0xD6, 0xD7, 0xD8, 0xD9, 0xDA, 0xE1, 0xE2, 0xE3, 0xE4, 0xE5, 0xE6, 0xE7, 0xE8,
     0xE9, 0xEA, 0xF1, 0xF2, 0xF3, 0xF4, 0xF5, 0xF6, 0xF7, 0xF8, 0xF9, 0xFA},
    {0x00, 0x01, 0x02, 0x03, 0x11, 0x04, 0x05, 0x21, 0x31, 0x06, 0x12, 0x41, 0x51, 0x07, 0x61,
     0x71, 0x13, 0x22, 0x32, 0x81, 0x08, 0x14, 0x42, 0x91, 0xA1, 0xB1, 0xC1, 0x09, 0x23, 0x33,
     0x52, 0xF0, 0x15, 0x62, 0x72, 0xD1, 0x0A, 0x16, 0x24, 0x34, 0xE1, 0x25, 0xF1, 0x17, 0x18,
     0x19, 0x1A, 0x26, 0x27, 0x28, 0x29, 0x2A, 0x35, 0x36, 0x37, 0x38, 0x39, 0x3A, 0x43, 0x44,
     0x45, 0x46, 0x47, 0x48, 0x49, 0x4A, 0x53, 0x54, 0x55, 0x56, 0x57, 0x58, 0x59, 0x5A, 0x63,
     0x64, 0x65, 0x66, 0x67, 0x68, 0x69, 0x6A, 0x73, 0x74, 0x75, 0x76, 0x77, 0x78, 0x79, 0x7A,
     0x82, 0x83, 0x84, 0x85, 0x86, 0x87, 0x88, 0x89, 0x8A, 0x92, 0x93, 0x94, 0x95, 0x96, 0x97,
     0x98, 0x99, 0x9A, 0xA2, 0xA3, 0xA4, 0xA5, 0xA6, 0xA7, 0xA8, 0xA9, 0xAA, 0xB2, 0xB3, 0xB4,
     0xB5, 0xB6, 0xB7, 0xB8, 0xB9, 0xBA, 0xC2, 0xC3, 0xC4, 0xC5, 0xC6, 0xC7, 0xC8, 0xC9, 0xCA,
     0xD2, 0xD3, 0xD4, 0xD5, 0xD6, 0xD7, 0xD8, 0xD9, 0xDA, 0xE2, 0xE3, 0xE4, 0xE5, 0xE6, 0xE7,
     0xE8, 0xE9, 0xEA, 0xF2, 0xF3, 0xF4, 0xF5, 0xF6, 0xF7, 0xF8, 0xF9, 0xFA}};

/* By chrominance. */
static const code_list dc_lists[2] = {
    {{0, 1, 5, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0}, dc_values, DC_VALUES},
    {{0, 3, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0}, dc_values, DC_VALUES}};
static const code_list ac_lists[2] = {
    {{0, 2, 1, 3, 3, 2, 4, 3, 5, 5, 4, 4, 0, 0, 1, 125}, ac_values[0], AC_VALUES},
    {{0, 2, 1, 2, 4, 4, 3, 4, 7, 5, 4, 4, 0, 1, 2, 119}, ac_values[1], AC_VALUES}};

static void put_list(jpeg_file *f, unsigned name, const code_list *list) {
    jpeg_byte(f, name);
    for (unsigned i = 0; i < LENGTHS; i++) {
        jpeg_byte(f, list->of_length[i]);
    }
    for (unsigned i = 0; i < list->count; i++) {
        jpeg_byte(f, list->values[i]);
    }
}

void jpeg_code_tables(jpeg_file *f, int chrominance) {
    put_list(f, (unsigned)chrominance, &dc_lists[chrominance]);
    put_list(f, 0x10u + (unsigned)chrominance, &ac_lists[chrominance]);
}

/* Codes of a length follow each other; the next length begins at twice what follows (C.2). */
static void number_codes(uint32_t *codes, const code_list *list) {
    uint32_t code = 0;
    const uint8_t *value = list->values;
    for (unsigned length = 1; length <= LENGTHS; length++) {
        for (unsigned i = 0; i < list->of_length[length - 1]; i++) {
            codes[*value++] = code++ << LENGTH_BITS | length;
        }
        code <<= 1;
    }
}

void jpeg_book_set(jpeg_book *book, int chrominance) {
    memset(book, 0, sizeof *book);
    number_codes(book->dc, &dc_lists[chrominance]);
    number_codes(book->ac, &ac_lists[chrominance]);
}

/* ---- bits ------------------------------------------------------------------------------ */

void jpeg_byte(jpeg_file *f, unsigned byte) {
    if (f->size < f->room) {
        f->bytes[f->size] = (uint8_t)byte;
    }
    f->size++;
}

void jpeg_bits(jpeg_file *f, uint32_t bits, unsigned count) {
    f->hold = f->hold << count | bits;
    f->held += count;
    while (f->held >= 8) {
        f->held -= 8;
        const unsigned byte = f->hold >> f->held & 0xFF;
        jpeg_byte(f, byte);
        if (byte == 0xFF) {
            jpeg_byte(f, 0);
        }
    }
}

void jpeg_pad(jpeg_file *f) {
    if (f->held > 0) {
        jpeg_bits(f, (1u << (8 - f->held)) - 1, 8 - f->held);
    }
}

/* ---- blocks ---------------------------------------------------------------------------- */

static void put_code(jpeg_file *f, uint32_t code) {
    jpeg_bits(f, code >> LENGTH_BITS, code & ((1u << LENGTH_BITS) - 1));
}

static unsigned bits_of(int value) {
    unsigned size = (unsigned)(value < 0 ? -value : value), bits = 0;
    for (; size > 0; size >>= 1) {
        bits++;
    }
    return bits;
}

/* `bits` of it; one below 0 is that of 1 less, whose first bit is 0. */
static void put_value(jpeg_file *f, int value, unsigned bits) {
    const uint32_t of = (uint32_t)(value < 0 ? value - 1 : value);
    jpeg_bits(f, of & ((1u << bits) - 1), bits);
}

void jpeg_code_block(jpeg_file *f, const int16_t *block, const jpeg_book *book, int *dc) {
    const int difference = block[0] - *dc;
    const unsigned dc_bits = bits_of(difference);
    unsigned zeros = 0;
    *dc = block[0];
    put_code(f, book->dc[dc_bits]);
    put_value(f, difference, dc_bits);
    for (unsigned i = 1; i < JPEG_BLOCK; i++) {
        const int value = block[jpeg_zigzag[i]];
        if (value == 0) {
            zeros++;
            continue;
        }
        for (; zeros > 15; zeros -= 16) {
            put_code(f, book->ac[SIXTEEN_ZEROS]);
        }
        const unsigned bits = bits_of(value);
        put_code(f, book->ac[zeros << 4 | bits]);
        put_value(f, value, bits);
        zeros = 0;
    }
    if (zeros > 0) {
        put_code(f, book->ac[END_OF_BLOCK]);
    }
}
