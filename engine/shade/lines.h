/* lines - columns and rows of pixels between two coordinates, told by the bits of floats
 *
 * Coordinates are kept 16 pixels higher than they are: so those in a square, whose pixels lie on
 * whole numbers, are floats from 16 up to 32, all of one exponent, and their bits above the
 * fraction count its lines. Bits of other floats are numbers before the first line, or after the
 * last: those of negative ones, too. No number is converted, which would have to fit.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_LINES_H
#define PLT_SHADE_LINES_H

#include <stdint.h>

#include "engine/base/float_bits.h"
#include "engine/planelet_config.h"

#define PLT_LINE_FIRST 16.0f
#define PLT_LINE_BITS 19 /* of the fraction of a pixel, from 16 up to 32 */
#define PLT_LINE_NUMBER (0x41800000 >> PLT_LINE_BITS) /* of the first line: the bits of 16.0f */
#define PLT_LINE_WIDEST (1 << 30)                     /* a margin that leaves out nothing */

_Static_assert(PLT_PACKET_SIDE_MAX <= 16, "a square's coordinates have one exponent");
/* cppcheck-suppress shiftNegativeLHS ; that is what is asked */
_Static_assert(-1 >> 1 == -1, "the shift of a negative number leaves it negative");

/* Lines after `before`, up to `last`: their numbers. */
typedef struct plt_lines {
    int32_t before, last;
} plt_lines;

/* Between two coordinates, `least` as much lower as `margin` says, in 2^-18, at most
 * PLT_LINE_WIDEST: above 32 that is more, and below 16 there is no line. The bits are halved first,
 * so that nothing overflows. */
static inline plt_lines plt_lines_between(float least, float most, int32_t margin) {
    const plt_lines l = {(((int32_t)plt_bits_of(least) >> 1) - margin) >> (PLT_LINE_BITS - 1),
                         (int32_t)plt_bits_of(most) >> PLT_LINE_BITS};
    return l;
}

/* Whether there is one of the square, whose last line is `end`. */
static inline int plt_lines_any(plt_lines l, int32_t end) {
    return l.before < l.last && l.last >= PLT_LINE_NUMBER && l.before < end;
}

/* The first and the last, if there is one, counted from the square's first. */
static inline uint32_t plt_lines_first(plt_lines l) {
    return l.before < PLT_LINE_NUMBER ? 0 : (uint32_t)(l.before + 1 - PLT_LINE_NUMBER);
}

static inline uint32_t plt_lines_last(plt_lines l, int32_t end) {
    return (uint32_t)((l.last < end ? l.last : end) - PLT_LINE_NUMBER);
}

/* The coordinate of a line of the square, counted from its first. */
static inline float plt_line_at(uint32_t line) {
    return plt_float_of((line + PLT_LINE_NUMBER) << PLT_LINE_BITS);
}

#endif
