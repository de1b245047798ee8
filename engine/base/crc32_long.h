/* crc32_long - the CRC-32 of many bytes, by exclusive ors of whole words
 *
 * The same checksum as plt_crc32, for 3 instructions per byte of a Cortex-M4 instead of 7, and no
 * table more. It takes scratch; the more, the less is moved.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BASE_CRC32_LONG_H
#define PLT_BASE_CRC32_LONG_H

#include <stddef.h>
#include <stdint.h>

/* plt_crc32(0, bytes, count); with fewer `words` of scratch than 455, no faster. */
uint32_t plt_crc32_long(const void *bytes, size_t count, uint32_t *scratch, size_t words);

#endif
