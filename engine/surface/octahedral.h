/* octahedral - a direction in 16 bits
 *
 * The sphere is pressed flat onto an octahedron, |x| + |y| + |z| = 1, whose lower half is
 * folded outwards over the upper one: a square, of which a code holds x and y in 8 bits each,
 * -127 to 127. Codes with a byte of -128 are none of them.
 *
 * Source: Z. H. Cigolle, S. Donow, D. Evangelakos, M. Mara, M. McGuire and Q. Meyer, JCGT 3 (2),
 * 2014, which compares such codes.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SURFACE_OCTAHEDRAL_H
#define PLT_SURFACE_OCTAHEDRAL_H

#include <stdint.h>

#define PLT_NORMAL_SPLIT 0x8080u /* triangles that meet in a corner have different ones */
#define PLT_NORMAL_NONE 0x8000u  /* the corner has none */

/* -128 .. 127, of the lowest 8 bits. */
static inline int32_t plt_signed_byte(uint32_t byte) {
    return (int32_t)((byte & 0xFFu) ^ 0x80u) - 128;
}

/* Of any 16 bits a vector whose sizes of components are between 1/3 and 2 in sum, so not 0; whole
 * numbers over 127, before it is normalised. */
static inline void plt_octahedral_vector(uint32_t code, float to[3]) {
    const int32_t x = plt_signed_byte(code), y = plt_signed_byte(code >> 8);
    const int32_t across = x < 0 ? -x : x, along = y < 0 ? -y : y;
    const int32_t z = 127 - across - along;
    const int32_t folded_x = x < 0 ? along - 127 : 127 - along;
    const int32_t folded_y = y < 0 ? across - 127 : 127 - across;
    to[0] = (float)(z < 0 ? folded_x : x);
    to[1] = (float)(z < 0 ? folded_y : y);
    to[2] = (float)z;
}

/* The same, of length 1 up to rounding. */
static inline void plt_octahedral_normal(uint32_t code, float to[3]) {
    plt_octahedral_vector(code, to);
    const float length = __builtin_sqrtf(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
    for (int a = 0; a < 3; a++) {
        to[a] = to[a] / length;
    }
}

#endif
