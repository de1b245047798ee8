/* jpeg - writes baseline JPEG, the same bytes on every machine
 *
 * Integers only, nothing allocated: an encoder's state is 2.5 KB of stack, and files go where
 * the caller says. Quantisation tables are those of Annex K by the Independent JPEG
 * Group's scale of quality, Huffman tables those of Annex K: what displays have in their decoders.
 *
 * Source: CCITT T.81 (1992), Annexes A, F, K; ITU-T T.871 (2011), JFIF.
 *
 * SPDX-License-Identifier: MIT */
#ifndef JPEG_H
#define JPEG_H
#include "host_tools/picture/picture.h"

/* Of how many pixels one of each chroma sample is: 1x1, 2x1, 2x2. */
typedef enum jpeg_sampling { JPEG_444, JPEG_422, JPEG_420, JPEG_SAMPLINGS } jpeg_sampling;

enum { JPEG_QUALITY_LEAST = 1, JPEG_QUALITY_MOST = 100 };

/* What a file of so many pixels has at most: all bits of all coefficients, each byte stuffed. */
size_t jpeg_most(unsigned width, unsigned height);

/* Writes `p` to `file`, of `room` bytes. `quality` 1 .. 100. Returns the file's size; a size above
 * `room` is what it would have had, and `file` then is no file. */
size_t jpeg_write(const picture *p, jpeg_sampling sampling, unsigned quality, uint8_t *file,
                  size_t room);

/* The highest quality, `least` to `most`, whose file has at most `room` bytes, and that file; by
 * halves: files grow with quality, but for a byte here and there. Returns the size, above `room`
 * if no quality fits; `*quality` is the one that was written. */
size_t jpeg_fit(const picture *p, jpeg_sampling sampling, unsigned least, unsigned most,
                unsigned *quality, uint8_t *file, size_t room);

#endif
