/* model_code - the next pixel of a tile, to bits or from them
 *
 * Written once for encoder and decoder (range.h): `direction` is a constant of the
 * caller, and the encoder finds what the decoder will find. So they cannot disagree,
 * and an encoder with an error bound knows what its pixels become.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_MODEL_CODE_H
#define PLT_WIRE_MODEL_CODE_H

#include "platform/wire/model.h"
#include "platform/wire/range.h"

/* ---- how far off a prediction was ------------------------------------------------ */

/* 1 .. 255: how many bits, then those below the first. */
static inline unsigned wire_code_size(wire_range *c, enum wire_direction direction,
                                      uint16_t *chance, unsigned size) {
    unsigned bits = 0, value = 1;
    while (bits < MODEL_BITS) {
        const unsigned last = bits < MODEL_LENGTHS ? bits : MODEL_LENGTHS - 1;
        if (!wire_code(c, direction, chance + MODEL_LENGTH + last, size >> bits > 1)) {
            break;
        }
        bits++;
    }
    if (bits > 0) {
        value =
            2 | wire_code(c, direction, chance + MODEL_UPPER + (bits > 1), size >> (bits - 1) & 1);
        for (unsigned left = bits - 1; left > 0; left--) {
            value = value << 1 | wire_code_even(c, direction, size >> (left - 1) & 1);
        }
    }
    return value;
}

/* -255 .. 255 but 0. `sign`: which chance, 0 .. 2. */
static inline int wire_code_signed(wire_range *c, enum wire_direction direction, uint16_t *chance,
                                   unsigned sign, int steps) {
    const unsigned negative = wire_code(c, direction, chance + MODEL_SIGN + sign, steps < 0);
    const unsigned size = (unsigned)(steps < 0 ? -steps : steps);
    const int value = (int)wire_code_size(c, direction, chance, size);
    return negative ? -value : value;
}

/* What (value - guess) becomes in steps. */
static inline int wire_model_steps(int difference, int step) {
    const int half = step / 2;
    return step == 1         ? difference
           : difference >= 0 ? (difference + half) / step
                             : -((half - difference) / step);
}

static inline int wire_clamp(int value, int most) {
    return value < 0 ? 0 : value > most ? most : value;
}

/* ---- the first sample ------------------------------------------------------------- */

typedef struct wire_guess {
    int value;
    uint16_t *chance; /* of its class: how rough it is around */
    unsigned zero, sign;
} wire_guess;

static inline int wire_median(int left, int up, int corner) {
    const int low = left < up ? left : up, high = left < up ? up : left;
    return corner >= high ? low : corner <= low ? high : left + up - corner;
}

/* Classes 0 .. 4: from 0, 1, 3, 7 and 13 steps of 63 on. */
static inline unsigned wire_class(const wire_model *m, int rough) {
    static const uint8_t class_of[14] = {0, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 4};
    rough = m->format == WIRE_GREY4                 ? rough * 4
            : wire_sample_most(m->format, 0) == 255 ? (rough + 2) / 4
                                                    : rough;
    rough = m->step == 1 ? rough : rough / m->step;
    return class_of[rough < 13 ? rough : 13];
}

static inline wire_guess wire_guess_first(wire_model *m) {
    const int x = m->x, up = m->row[x].v[0], left = x > 0 ? m->row[x - 1].v[0] : up;
    wire_guess g = {left, m->chance + MODEL_FIRST + 3 * MODEL_SAMPLE, 0, 0};
    if (m->y == 0) {
        g.value = x > 0 ? left : m->corner.v[0];
        return g;
    }
    const int right = x + 1 < m->width ? m->row[x + 1].v[0] : up;
    const int corner = x > 0 ? m->corner.v[0] : up;
    g.zero = left == up;
    if (left == up && corner == up && right == up) { /* what is below comes to the same */
        g.chance = m->chance + MODEL_FIRST;
        return g;
    }
    const int rough =
        wire_distance(left, corner) + wire_distance(up, corner) + wire_distance(right, up);
    g.value = wire_median(left, up, corner);
    g.chance = m->chance + MODEL_FIRST + MODEL_SAMPLE * wire_class(m, rough);
    g.sign = left + up > 2 * g.value ? 1 : left + up < 2 * g.value ? 2 : 0;
    return g;
}

/* ---- the other samples --------------------------------------------------------------- */

enum { MODEL_FAR = 3 }; /* steps of green from which on a neighbour is another brightness */

static inline int wire_nearer(const wire_sample **best, int least, const wire_sample *s,
                              int first) {
    const int d = wire_distance(s->v[0], first);
    *best = d < least ? s : *best;
    return d < least ? d : least;
}

/* The neighbour whose first sample is nearest to `first`, and how near. */
static inline const wire_sample *wire_nearest(const wire_model *m, int first, int *distance) {
    const wire_sample *best = &m->corner, *const up = m->row + m->x;
    int least = 256;
    if (m->x > 0) {
        least = wire_nearer(&best, least, up - 1, first);
    }
    if (m->y > 0 && least > 0) {
        least = wire_nearer(&best, least, up, first);
        if (m->x + 1 < m->width && least > 0) {
            least = wire_nearer(&best, least, up + 1, first);
        }
        if (m->x > 0 && least > 0) {
            least = wire_nearer(&best, least, &m->corner, first);
        }
    }
    *distance = least;
    return best;
}

/* They follow that neighbour: in proportion when its brightness is another, else
 * by the difference. Returns 0 .. 2: how near it is. */
static inline unsigned wire_guess_others(const wire_model *m, int guess[3]) {
    int distance;
    const wire_sample *near = wire_nearest(m, guess[0], &distance);
    const int most = wire_sample_most(m->format, 1), base = near->v[0], more = guess[0] - base;
    guess[1] = near->v[1];
    guess[2] = near->v[2];
    if (distance == 0) {
        return 0;
    }
    for (int i = 1; i < 3; i++) {
        const int value = distance < MODEL_FAR - 1 || base == 0
                              ? guess[i] + (m->format == WIRE_RGB565 ? more / 2 : more)
                              : (2 * guess[i] * guess[0] + base) / (2 * base);
        guess[i] = wire_clamp(value, most);
    }
    return distance < MODEL_FAR ? 1 : 2;
}

static inline void wire_code_others(wire_model *m, wire_range *c, enum wire_direction direction,
                                    unsigned is_exact, int value[3], const wire_sample *pixel) {
    const unsigned kind = wire_guess_others(m, value) + (is_exact ? 3 : 0);
    int second = 0, third = 0;
    if (direction == WIRE_ENCODES) {
        second = wire_model_steps(pixel->v[1] - value[1], m->step);
        third = wire_model_steps(pixel->v[2] - value[2], m->step);
    }
    if (!wire_code(c, direction, m->chance + MODEL_EXACT + kind, (second | third) != 0)) {
        return;
    }
    uint16_t *const chance = m->chance + MODEL_SECOND;
    unsigned sign = 0;
    if (wire_code(c, direction, chance + MODEL_ZERO, second != 0)) {
        second = wire_code_signed(c, direction, chance, 0, second);
        value[1] = wire_clamp(value[1] + second * m->step, wire_sample_most(m->format, 1));
        sign = second < 0 ? 1 : 2;
    }
    if (sign == 0 ||
        wire_code(c, direction, chance + MODEL_SAMPLE, third != 0)) { /* not both are zero */
        third = wire_code_signed(c, direction, chance + MODEL_SAMPLE, sign, third);
        value[2] = wire_clamp(value[2] + third * m->step, wire_sample_most(m->format, 2));
    }
}

/* ---- a pixel ---------------------------------------------------------------------------- */

/* Bits of `mask` at x-1, x, x+1 of a row. */
static inline unsigned wire_around(unsigned mask, unsigned x) {
    return (mask << 1 >> x) & 7;
}

static inline unsigned wire_is_same(const wire_model *m, const wire_sample *a,
                                    const wire_sample *b) {
    const int near = m->step / 2;
    return wire_distance(a->v[0], b->v[0]) <= near && wire_distance(a->v[1], b->v[1]) <= near &&
           wire_distance(a->v[2], b->v[2]) <= near;
}

/* Chosen by which neighbours changed, and by how well the old pixel fits them. */
static inline uint16_t *wire_same_chance(wire_model *m, const wire_sample *old, int guess) {
    const unsigned left = m->x > 0 ? m->here >> (m->x - 1) & 1 : 0;
    const int off = wire_distance(old->v[0], guess) / m->step;
    return m->chance + MODEL_SAME + (off < 2 ? 8 * off : 16) +
           (left << 2 | (wire_around(m->above, m->x) & 3));
}

static inline uint16_t *wire_mono_chance(wire_model *m, const wire_sample *old) {
    const unsigned x = m->x;
    const unsigned left = x > 1 ? m->here >> (x - 2) & 3 : (unsigned)m->here << (2 - x) & 3;
    const unsigned last = m->flags & MODEL_DELTA ? old->v[0] : m->above2 >> x & 1;
    return m->chance + (left | wire_around(m->above, x) << 2 | last << 5);
}

static inline void wire_pixel_done(wire_model *m, const wire_sample *pixel) {
    m->corner = m->row[m->x];
    m->row[m->x] = *pixel;
    if (++m->x == m->width) {
        m->x = 0;
        m->y++;
        m->above2 = m->above;
        m->above = m->here;
        m->here = 0;
    }
}

static inline void wire_code_grey(wire_model *m, wire_range *c, enum wire_direction direction,
                                  const wire_sample *old, wire_sample *pixel) {
    const wire_guess g = wire_guess_first(m);
    if (m->flags & MODEL_DELTA) {
        const unsigned differs = direction == WIRE_ENCODES && !wire_is_same(m, pixel, old);
        if (!wire_code(c, direction, wire_same_chance(m, old, g.value), differs)) {
            *pixel = *old;
            return;
        }
        m->here |= (uint16_t)(1u << m->x);
    }
    int value[3] = {g.value, 0, 0};
    int steps = direction == WIRE_ENCODES ? wire_model_steps(pixel->v[0] - g.value, m->step) : 0;
    if (wire_code(c, direction, g.chance + g.zero, steps != 0)) {
        steps = wire_code_signed(c, direction, g.chance, g.sign, steps);
        value[0] = wire_clamp(g.value + steps * m->step, wire_sample_most(m->format, 0));
    }
    if (wire_has_colour(m->format)) {
        wire_code_others(m, c, direction, steps == 0, value, pixel);
    }
    for (int i = 0; i < 3; i++) {
        pixel->v[i] = (uint8_t)value[i];
    }
}

/* Codes `pixel`, which becomes what the decoder gets, or decodes it. `old`:
 * what the panel shows there, with MODEL_DELTA; else not looked at. */
static inline void wire_code_pixel(wire_model *m, wire_range *c, enum wire_direction direction,
                                   const wire_sample *old, wire_sample *pixel) {
    if (m->format == WIRE_MONO1) {
        pixel->v[0] = (uint8_t)wire_code(c, direction, wire_mono_chance(m, old), pixel->v[0]);
        m->here |= (uint16_t)(pixel->v[0] << m->x);
    } else {
        wire_code_grey(m, c, direction, old, pixel);
    }
    wire_pixel_done(m, pixel);
}

#endif
