/* crc32 - see engine/planelet_crc32.h
 *
 * Where constants are to be few, by halves of bytes: with words loaded whole it takes as many
 * instructions as by bytes, whose table is 16 times as large.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/planelet_crc32.h"

#include "engine/planelet_config.h"

#if PLT_CRC32_SLICES

#include "engine/base/crc32_slices.h"

uint32_t plt_crc32(uint32_t crc, const void *bytes, size_t count) {
    const unsigned char *at = bytes, *end = at + count;
    crc = ~crc;
    for (const unsigned char *eights_end = at + count / 8 * 8; at < eights_end; at += 8) {
        crc = plt_crc32_eight(crc, at);
    }
    while (at < end) {
        crc = plt_crc32_one(crc, *at++);
    }
    return ~crc;
}

#else

#include "engine/base/bytes.h"

/* Entry i: the remainder of 4 bits, bit-reversed polynomial 0xEDB88320. */
static const uint32_t remainder_of[16] = {
    0x00000000, 0x1DB71064, 0x3B6E20C8, 0x26D930AC, 0x76DC4190, 0x6B6B51F4, 0x4DB26158, 0x5005713C,
    0xEDB88320, 0xF00F9344, 0xD6D6A3E8, 0xCB61B38C, 0x9B64C2B0, 0x86D3D2D4, 0xA00AE278, 0xBDBDF21C,
};

static inline uint32_t without_byte(uint32_t crc) {
    crc = crc >> 4 ^ remainder_of[crc & 15];
    return crc >> 4 ^ remainder_of[crc & 15];
}

uint32_t plt_crc32(uint32_t crc, const void *bytes, size_t count) {
    const unsigned char *at = bytes, *end = at + count;
    crc = ~crc;
    for (const unsigned char *words_end = at + count / 4 * 4; at < words_end; at += 4) {
        crc ^= plt_get_u32(at);
        crc = without_byte(without_byte(without_byte(without_byte(crc))));
    }
    while (at < end) {
        crc = without_byte(crc ^ *at++);
    }
    return ~crc;
}

#endif
