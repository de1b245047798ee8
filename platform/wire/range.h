/* range - binary arithmetic coding with adaptive probabilities
 *
 * A chance is 16 bits: the upper 12 say how likely a 0 is, in 1/4096, the
 * lower 4 how much was learnt (which makes learning slower). Invariant: the
 * 12 bits stay within 32 .. 4064, so that with range >= 2^24 both parts of
 * an interval hold at least 2^17, and a bit moves the coder by 1 byte at most.
 *
 * The number that the coded bytes stand for, a binary fraction, lies in
 * [low, low + range); bytes beyond the last are zeros, and the coder leaves
 * away those it can.
 *
 * Source: G. N. N. Martin, "Range encoding", 1979; carry into bytes already
 * written, as in Witten, Neal, Cleary, "Arithmetic coding for data
 * compression", 1987. SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_RANGE_H
#define PLT_WIRE_RANGE_H

#include <stdint.h>

enum { WIRE_RANGE_LEAST = 1 << 24, WIRE_CHANCE_EVEN = 2048 << 4 };

static inline void wire_chance_learn(uint16_t *chance, unsigned bit) {
    /* 65536 / (n + 1.5), and 1/16 or so in the end */
    static const uint16_t rate[16] = {32768, 26214, 18725, 14564, 11916, 10082, 8738, 7710,
                                      6899,  6242,  5699,  5243,  4855,  4520,  4228, 3972};
    const int count = *chance & 15;
    int p = *chance >> 4;
    p += ((bit ? 0 : 4095) - p) * (int)rate[count] / 65536;
    p = p < 32 ? 32 : p > 4064 ? 4064 : p;
    *chance = (uint16_t)(p << 4 | (count < 15 ? count + 1 : count));
}

/* ---- encoder: into to[0 .. room - 1]; `used` > room: it did not fit ----------- */

typedef struct wire_range_out {
    uint8_t *to;
    uint32_t used, room, low, range;
} wire_range_out;

static inline void wire_range_carry(wire_range_out *c) {
    uint32_t i = c->used < c->room ? c->used : c->room;
    while (i > 0 && ++c->to[--i] == 0) {
    }
}

static inline void wire_range_byte(wire_range_out *c) {
    if (c->used < c->room) {
        c->to[c->used] = (uint8_t)(c->low >> 24);
    }
    c->used++;
    c->low <<= 8;
    c->range <<= 8;
}

static inline void wire_range_put(wire_range_out *c, uint32_t bound, unsigned bit) {
    if (bit) {
        c->low += bound;
        if (c->low < bound) {
            wire_range_carry(c);
        }
        c->range -= bound;
    } else {
        c->range = bound;
    }
    while (c->range < WIRE_RANGE_LEAST) {
        wire_range_byte(c);
    }
}

/* The fewest bytes that end inside the interval. */
static inline void wire_range_end(wire_range_out *c) {
    uint32_t keep = 0; /* bits of low that stay, then up to the next multiple */
    uint32_t value;
    do {
        const uint32_t below = keep == 32 ? 0 : UINT32_MAX >> keep;
        value = (c->low + below) & ~below;
        if (value - c->low < c->range) {
            break;
        }
        keep += 8;
    } while (keep <= 32);
    if (value < c->low) {
        wire_range_carry(c);
    }
    c->low = value;
    for (; keep > 0; keep -= 8) {
        wire_range_byte(c);
    }
    while (c->used > 0 && c->used <= c->room && c->to[c->used - 1] == 0) {
        c->used--;
    }
}

/* ---- decoder ------------------------------------------------------------------ */

typedef struct wire_range_in {
    uint32_t code, range; /* code: the number less low */
} wire_range_in;

static inline unsigned wire_range_get(wire_range_in *c, uint32_t bound) {
    if (c->code < bound) {
        c->range = bound;
        return 0;
    }
    c->code -= bound;
    c->range -= bound;
    return 1;
}

#endif
