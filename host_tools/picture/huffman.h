/* huffman - prefix codes of bounded length for deflate
 *
 * SPDX-License-Identifier: MIT */
#ifndef HUFFMAN_H
#define HUFFMAN_H
#include <stdint.h>

#define HUFFMAN_SYMBOLS 288 /* of the largest alphabet */
#define HUFFMAN_LIMIT 15    /* longest code of deflate, in bits */

/* RFC 1951, 3.2.7: the order in which a block sends the lengths of the code for
 * its code lengths. */
#define HUFFMAN_LENGTH_CODES 19
extern const uint8_t huffman_length_order[HUFFMAN_LENGTH_CODES];

/* length[s] becomes the code length, 0 where count[s] is 0, of a code for
 * `symbols` (<= HUFFMAN_SYMBOLS) symbols no longer than `limit` (7 .. 15).
 * The code is complete unless fewer than two symbols occur. */
void huffman_lengths(const uint32_t *count, unsigned symbols, unsigned limit, uint8_t *length);

/* The canonical codes, bits reversed as deflate sends them. */
void huffman_codes(const uint8_t *length, unsigned symbols, uint16_t *code);

#endif
