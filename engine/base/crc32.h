/* crc32 - the CRC-32 of ISO 3309 (as in zip and PNG)
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BASE_CRC32_H
#define PLT_BASE_CRC32_H

#include <stddef.h>
#include <stdint.h>

/* The checksum of what `crc` covers followed by `bytes`; start with 0. */
uint32_t plt_crc32(uint32_t crc, const void *bytes, size_t count);

#endif
