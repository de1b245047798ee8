/* range - binary arithmetic coding with adaptive probabilities
 *
 * A chance says in 16 bits how likely a 0 is. Invariant: it stays within
 * WIRE_CHANCE_LEAST .. WIRE_CHANCE_MOST (learning moves it towards one of
 * them by a sixteenth of the distance). With range >= 2^24 both parts of an
 * interval then hold at least 2^17, and a bit moves the coder by 1 byte at most.
 *
 * Encoding and decoding are one function with a constant direction: what it
 * decides cannot differ between them, and each is compiled without the other.
 *
 * The number that the coded bytes stand for, a binary fraction, lies in
 * [low, low + range); bytes beyond the last are zeros, and the encoder omits
 * the zeros at the end.
 *
 * Source: G. N. N. Martin, "Range encoding", 1979; carry into bytes already
 * written, as in Witten, Neal, Cleary, "Arithmetic coding for data
 * compression", 1987. SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_RANGE_H
#define PLT_WIRE_RANGE_H

#include <stdint.h>

enum {
    WIRE_RANGE_LEAST = 1 << 24,
    WIRE_CHANCE_LEAST = 32 << 4,
    WIRE_CHANCE_MOST = 4064 << 4,
    WIRE_CHANCE_SHIFT = 4
};

enum wire_direction { WIRE_ENCODES, WIRE_DECODES };

typedef struct wire_range {
    uint8_t *bytes; /* byte n is bytes[n & mask] */
    uint32_t mask;
    uint32_t low;  /* decoding: the number less low */
    uint32_t used; /* bytes written or read; beyond `room` while encoding: it did not fit */
    uint32_t room, range;
} wire_range;

/* Adds 1 to the number that is written. */
static inline void wire_range_carry(wire_range *c) {
    uint32_t i = c->used < c->room ? c->used : c->room;
    while (i > 0 && ++c->bytes[--i] == 0) {
    }
}

static inline void wire_range_put(wire_range *c) {
    if (c->used < c->room) {
        c->bytes[c->used] = (uint8_t)(c->low >> 24);
    }
    c->used++;
    c->low <<= 8;
    c->range <<= 8;
}

static inline void wire_range_get(wire_range *c) {
    const uint32_t byte = c->used < c->room ? c->bytes[c->used++ & c->mask] : 0;
    c->low = c->low << 8 | byte;
    c->range <<= 8;
}

/* The part above `bound`, which stands for a 1. */
static inline void wire_range_upper(wire_range *c, enum wire_direction direction, uint32_t bound) {
    c->range -= bound;
    if (direction == WIRE_DECODES) {
        c->low -= bound;
        return;
    }
    c->low += bound;
    if (c->low < bound) {
        wire_range_carry(c);
    }
}

static inline void wire_range_widen(wire_range *c, enum wire_direction direction) {
    if (c->range < WIRE_RANGE_LEAST && direction == WIRE_ENCODES) {
        wire_range_put(c);
    } else if (c->range < WIRE_RANGE_LEAST) {
        wire_range_get(c);
    }
}

/* A bit with a chance, which learns from it. Encodes `bit`, or decodes and
 * ignores it; returns the bit. */
static inline unsigned wire_code(wire_range *c, enum wire_direction direction, uint16_t *chance,
                                 unsigned bit) {
    const uint32_t p = *chance, bound = (c->range >> 12) * (p >> 4);
    if (direction == WIRE_DECODES) {
        bit = c->low >= bound;
    }
    if (bit) {
        wire_range_upper(c, direction, bound);
        *chance = (uint16_t)(p - ((p - WIRE_CHANCE_LEAST) >> WIRE_CHANCE_SHIFT));
    } else {
        c->range = bound;
        *chance = (uint16_t)(p + ((WIRE_CHANCE_MOST - p) >> WIRE_CHANCE_SHIFT));
    }
    wire_range_widen(c, direction);
    return bit;
}

/* A bit that is 0 as often as 1. One function for both kinds of bit would branch a
 * second time to learn: 2 % of what encoding costs, 4 % when it is near. */
static inline unsigned wire_code_even(wire_range *c, enum wire_direction direction, unsigned bit) {
    const uint32_t bound = c->range >> 1;
    if (direction == WIRE_DECODES) {
        bit = c->low >= bound;
    }
    if (bit) {
        wire_range_upper(c, direction, bound);
    } else {
        c->range = bound;
    }
    wire_range_widen(c, direction);
    return bit;
}

/* Encoder: the fewest bytes that end inside the interval. */
static inline void wire_range_end(wire_range *c) {
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
        wire_range_put(c);
    }
    while (c->used > 0 && c->used <= c->room && c->bytes[c->used - 1] == 0) {
        c->used--;
    }
}

#endif
