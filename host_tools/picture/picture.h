/* picture - 8-bit RGB pixels in memory
 *
 * SPDX-License-Identifier: MIT */
#ifndef PICTURE_H
#define PICTURE_H
#include <stddef.h>
#include <stdint.h>

#include "host_tools/base/fail.h"

#define PICTURE_SIDE_MAX 32768u

typedef struct picture {
    uint8_t *rgb;           /* 3 bytes per pixel, rows top down, no padding; owned */
    unsigned width, height; /* 1 .. PICTURE_SIDE_MAX */
} picture;

/* Refuses a size that no picture may have. */
int picture_check_size(unsigned width, unsigned height, fail *f);

/* A black picture; on failure `p` is all zero, and may be freed. */
int picture_make(picture *p, unsigned width, unsigned height, fail *f);
void picture_free(picture *p);

/* Gives `p`, made before or zero, this size: pixels are kept if it has it already,
 * else black. */
int picture_resize(picture *p, unsigned width, unsigned height, fail *f);

#endif
