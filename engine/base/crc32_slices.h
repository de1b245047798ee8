/* crc32_slices - the remainders of eight bytes at once, from eight tables
 *
 * What a byte adds to the remainder of a message is linear in its bits, so each entry is a sum
 * of the eight remainders of single bits, which the compiler makes of the 64 below.
 *
 * Source: Kounavis & Berry, "A Systematic Approach to Building High Performance Software-based CRC
 * Generators", 2005 (slicing by 8).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BASE_CRC32_SLICES_H
#define PLT_BASE_CRC32_SLICES_H

#include "engine/base/bytes.h"

#define PLT_CRC_BIT(byte, bit, remainder) ((byte) >> (bit)&1 ? (remainder) : 0u)
#define PLT_CRC_1(byte, r7, r6, r5, r4, r3, r2, r1, r0)                                            \
    (PLT_CRC_BIT(byte, 7, r7) ^ PLT_CRC_BIT(byte, 6, r6) ^ PLT_CRC_BIT(byte, 5, r5) ^              \
     PLT_CRC_BIT(byte, 4, r4) ^ PLT_CRC_BIT(byte, 3, r3) ^ PLT_CRC_BIT(byte, 2, r2) ^              \
     PLT_CRC_BIT(byte, 1, r1) ^ PLT_CRC_BIT(byte, 0, r0))
#define PLT_CRC_4(byte, ...)                                                                       \
    PLT_CRC_1(byte, __VA_ARGS__), PLT_CRC_1((byte) + 1, __VA_ARGS__),                              \
        PLT_CRC_1((byte) + 2, __VA_ARGS__), PLT_CRC_1((byte) + 3, __VA_ARGS__)
#define PLT_CRC_16(byte, ...)                                                                      \
    PLT_CRC_4(byte, __VA_ARGS__), PLT_CRC_4((byte) + 4, __VA_ARGS__),                              \
        PLT_CRC_4((byte) + 8, __VA_ARGS__), PLT_CRC_4((byte) + 12, __VA_ARGS__)
#define PLT_CRC_64(byte, ...)                                                                      \
    PLT_CRC_16(byte, __VA_ARGS__), PLT_CRC_16((byte) + 16, __VA_ARGS__),                           \
        PLT_CRC_16((byte) + 32, __VA_ARGS__), PLT_CRC_16((byte) + 48, __VA_ARGS__)
#define PLT_CRC_TABLE(...)                                                                         \
    PLT_CRC_64(0, __VA_ARGS__), PLT_CRC_64(64, __VA_ARGS__), PLT_CRC_64(128, __VA_ARGS__),         \
        PLT_CRC_64(192, __VA_ARGS__)

/* Row i: the remainders of bytes that i bytes of 0 follow; of bit 7 alone to bit 0 alone. */
static const uint32_t plt_crc32_slice[8][256] = {
    {PLT_CRC_TABLE(0xEDB88320, 0x76DC4190, 0x3B6E20C8, 0x1DB71064, 0x0EDB8832, 0x076DC419,
                   0xEE0E612C, 0x77073096)},
    {PLT_CRC_TABLE(0x3B83984B, 0xF0794F05, 0x958424A2, 0x4AC21251, 0xC8D98A08, 0x646CC504,
                   0x32366282, 0x191B3141)},
    {PLT_CRC_TABLE(0xE1351B80, 0x709A8DC0, 0x384D46E0, 0x1C26A370, 0x0E1351B8, 0x0709A8DC,
                   0x0384D46E, 0x01C26A37)},
    {PLT_CRC_TABLE(0xED59B63B, 0x9B14583D, 0xA032AF3E, 0x5019579F, 0xC5B428EF, 0x8F629757,
                   0xAA09C88B, 0xB8BC6765)},
    {PLT_CRC_TABLE(0xB1E6B092, 0x58F35849, 0xC1C12F04, 0x60E09782, 0x30704BC1, 0xF580A6C0,
                   0x7AC05360, 0x3D6029B0)},
    {PLT_CRC_TABLE(0x1EB014D8, 0x0F580A6C, 0x07AC0536, 0x03D6029B, 0xEC53826D, 0x9B914216,
                   0x4DC8A10B, 0xCB5CD3A5)},
    {PLT_CRC_TABLE(0x8816EAF2, 0x440B7579, 0xCFBD399C, 0x67DE9CCE, 0x33EF4E67, 0xF44F2413,
                   0x979F1129, 0xA6770BB4)},
    {PLT_CRC_TABLE(0x533B85DA, 0x299DC2ED, 0xF9766256, 0x7CBB312B, 0xD3E51BB5, 0x844A0EFA,
                   0x4225077D, 0xCCAA009E)}};

/* The remainder after eight bytes more. */
static inline uint32_t plt_crc32_eight(uint32_t crc, const unsigned char *at) {
    const uint32_t a = crc ^ plt_get_u32(at), b = plt_get_u32(at + 4);
    return plt_crc32_slice[7][a & 255] ^ plt_crc32_slice[6][a >> 8 & 255] ^
           plt_crc32_slice[5][a >> 16 & 255] ^ plt_crc32_slice[4][a >> 24] ^
           plt_crc32_slice[3][b & 255] ^ plt_crc32_slice[2][b >> 8 & 255] ^
           plt_crc32_slice[1][b >> 16 & 255] ^ plt_crc32_slice[0][b >> 24];
}

static inline uint32_t plt_crc32_one(uint32_t crc, unsigned char byte) {
    return crc >> 8 ^ plt_crc32_slice[0][(crc ^ byte) & 255];
}

#endif
