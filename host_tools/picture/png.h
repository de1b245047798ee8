/* png - what reading and writing PNG have in common, and the reader
 *
 * Source: W3C, "Portable Network Graphics (PNG) Specification", third edition,
 * 2025, sections 5.2 (signature) and 9.4 (Paeth).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PNG_H
#define PNG_H
#include <stdlib.h>

#include "host_tools/picture/picture.h"

enum { PNG_SIGNATURE_BYTES = 8, PNG_FILTERS = 5 };

static const uint8_t png_signature[PNG_SIGNATURE_BYTES] = {0x89, 'P', 'N', 'G', 13, 10, 26, 10};

/* The neighbour that is nearest to left + up - corner. */
static inline uint8_t png_paeth(int left, int up, int corner) {
    const int guess = left + up - corner;
    const int l = abs(guess - left), u = abs(guess - up), c = abs(guess - corner);
    return (uint8_t)(l <= u && l <= c ? left : u <= c ? up : corner);
}

/* Makes `to`, which is zero or a picture, the one in `file`: 8 bits per channel,
 * grey, colour or palette, not interlaced; alpha is laid on black. Any bytes may
 * come. Memory: as much again as the picture has. `name` is for errors; on failure
 * `to` is zero or what it was. */
int png_read(picture *to, const uint8_t *file, size_t bytes, const char *name, fail *f);

#endif
