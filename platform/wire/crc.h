/* crc - the CRC-32 of ISO 3309, four bits at a time
 *
 * A table of 64 bytes: on a microcontroller flash is dearer than the few
 * cycles a byte that a large table would save.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_CRC_H
#define PLT_WIRE_CRC_H

#include <stddef.h>
#include <stdint.h>

/* Of what `crc` covers followed by `bytes`; start with 0. */
uint32_t wire_crc(uint32_t crc, const void *bytes, size_t count);

#endif
