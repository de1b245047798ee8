/* letters - five by seven dots for each letter, and two rows below the base line
 *
 * SPDX-License-Identifier: MIT */
#ifndef LETTERS_H
#define LETTERS_H
#include <stdint.h>

enum { LETTER_COLUMNS = 5, LETTER_ROWS = 7, LETTER_BELOW = 2 };

/* LETTER_ROWS + LETTER_BELOW rows from the top, the left dot in bit 4. Of what is not printable
 * ASCII a frame. */
const uint8_t *letter_rows(char c);

#endif
