/* planelet_crc32 - the CRC-32 of ISO 3309 (as in zip and PNG), for images and the wire
 *
 * Bit-reversed polynomial 0xEDB88320. A table of 64 bytes; 7 instructions per byte on a
 * Cortex-M4; with PLT_CRC32_SLICES (planelet_config.h) 8 KB, and 2 on x86-64. It needs nothing else
 * of the engine.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_PLANELET_CRC32_H
#define PLT_PLANELET_CRC32_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The checksum of what `crc` covers followed by `bytes`; start with 0. */
uint32_t plt_crc32(uint32_t crc, const void *bytes, size_t count);

#ifdef __cplusplus
}
#endif
#endif
