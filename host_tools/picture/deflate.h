/* deflate - lossless compression as PNG wants it
 *
 * SPDX-License-Identifier: MIT */
#ifndef DEFLATE_H
#define DEFLATE_H
#include "host_tools/picture/bits.h"

/* Appends to `out` (aligned) a zlib stream holding data[0 .. size), size
 * below 2^32 - 1. Needs 0.4 MB of scratch; -1 when memory is out. The same
 * bytes come out on every machine. */
int deflate_zlib(bits *out, const uint8_t *data, size_t size);

#endif
