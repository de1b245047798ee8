/* jpeg_block - see jpeg_block.h
 *
 * The transform of eight samples splits into sums and differences of those that mirror each other;
 * sums again into the four even coefficients, differences are four odd ones by a matrix of 4x4.
 * Factors are cosines times 2^16. Rows first, which keep 4 bits more than integers; a coefficient
 * is off by less than 0.1 before it is rounded (tests/host_tools/test_jpeg.c).
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/jpeg_block.h"

const uint8_t jpeg_zigzag[JPEG_BLOCK] = {
    0,  1,  8,  16, 9,  2,  3,  10, 17, 24, 32, 25, 18, 11, 4,  5,  12, 19, 26, 33, 40, 48,
    41, 34, 27, 20, 13, 6,  7,  14, 21, 28, 35, 42, 49, 56, 57, 50, 43, 36, 29, 22, 15, 23,
    30, 37, 44, 51, 58, 59, 52, 45, 38, 31, 39, 46, 53, 60, 61, 54, 47, 55, 62, 63};

/* ---- steps ----------------------------------------------------------------------------- */

static const uint8_t table_k1[JPEG_BLOCK] = {
    16, 11, 10, 16, 24,  40,  51,  61,  12, 12, 14, 19, 26,  58,  60,  55,
    14, 13, 16, 24, 40,  57,  69,  56,  14, 17, 22, 29, 51,  87,  80,  62,
    18, 22, 37, 56, 68,  109, 103, 77,  24, 35, 55, 64, 81,  104, 113, 92,
    49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98, 112, 100, 103, 99};

/* Table K.2 is 99 but in its first four rows and columns. */
static const uint8_t table_k2[4][4] = {
    {17, 18, 24, 47}, {18, 21, 26, 66}, {24, 26, 56, 99}, {47, 66, 99, 99}};

void jpeg_steps(unsigned quality, int chrominance, uint8_t steps[JPEG_BLOCK]) {
    const unsigned scale = quality < 50 ? 5000 / quality : 200 - 2 * quality;
    for (unsigned i = 0; i < JPEG_BLOCK; i++) {
        const unsigned row = i / JPEG_SIDE, column = i % JPEG_SIDE;
        const unsigned of = !chrominance            ? table_k1[i]
                            : row < 4 && column < 4 ? table_k2[row][column]
                                                    : 99;
        const unsigned step = (of * scale + 50) / 100;
        steps[i] = (uint8_t)(step < 1 ? 1 : step > 255 ? 255 : step);
    }
}

/* ---- transform ------------------------------------------------------------------------- */

/* cos(k pi / 16) / 2, and cos(pi / 4) / 2, times 2^16 */
enum { C1 = 32138, C2 = 30274, C3 = 27246, C4 = 23170, C5 = 18205, C6 = 12540, C7 = 6393 };

static int32_t rounded(int32_t value, unsigned bits) {
    return (value + (1 << (bits - 1))) >> bits;
}

/* Eight values, `stride` apart, become coefficients times 2^(16 - bits). */
static void transform_line(int16_t *v, unsigned stride, unsigned bits) {
    int32_t sum[4], difference[4];
    for (unsigned i = 0; i < 4; i++) {
        const int32_t a = v[i * stride], b = v[(7 - i) * stride];
        sum[i] = a + b;
        difference[i] = a - b;
    }
    const int32_t even[4] = {
        (sum[0] + sum[1] + sum[2] + sum[3]) * C4, (sum[0] - sum[3]) * C2 + (sum[1] - sum[2]) * C6,
        (sum[0] - sum[1] - sum[2] + sum[3]) * C4, (sum[0] - sum[3]) * C6 - (sum[1] - sum[2]) * C2};
    static const int16_t odd[4][4] = {
        {C1, C3, C5, C7}, {C3, -C7, -C1, -C5}, {C5, -C1, C7, C3}, {C7, -C5, C3, -C1}};
    for (unsigned k = 0; k < 4; k++) {
        const int32_t of = difference[0] * odd[k][0] + difference[1] * odd[k][1] +
                           difference[2] * odd[k][2] + difference[3] * odd[k][3];
        v[2 * k * stride] = (int16_t)rounded(even[k], bits);
        v[(2 * k + 1) * stride] = (int16_t)rounded(of, bits);
    }
}

/* Over its step; `value` is in sixteenths. */
static int16_t quantised(int32_t value, int32_t step) {
    const int32_t size = value < 0 ? -value : value;
    int32_t steps = (size + 8 * step) / (16 * step);
    steps = steps > 1023 ? 1023 : steps;
    return (int16_t)(value < 0 ? -steps : steps);
}

void jpeg_transform(int16_t block[JPEG_BLOCK], const uint8_t steps[JPEG_BLOCK]) {
    for (unsigned row = 0; row < JPEG_SIDE; row++) {
        transform_line(block + JPEG_SIDE * row, 1, 12);
    }
    for (unsigned column = 0; column < JPEG_SIDE; column++) {
        transform_line(block + column, JPEG_SIDE, 16);
    }
    for (unsigned i = 0; i < JPEG_BLOCK; i++) {
        block[i] = quantised(block[i], steps[i]);
    }
}
