/* model - see model.h
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "platform/wire/model.h"
#include "platform/wire/range.h"

/* How likely a 0 is in a new tile, in 1/256: measured over frames of the
 * scenes that planelet makes, exact and near. Learning begins as if 4 bits
 * had been seen. */
static const uint8_t start_chance[2][MODEL_CHANCES] = {
    {/* same */
     240, 193, 139, 134, 176, 129, 84, 111, 91, 114, 84, 51, 86, 77, 53, 26,
     /* first: zero, sign, six lengths, of each class */
     235, 124, 120, 70, 60, 52, 52, 52, 150, 124, 168, 150, 90, 76, 72, 64, 99, 130, 90, 90, 104,
     104, 104, 90, 108, 132, 62, 56, 62, 60, 60, 64, 78, 147, 64, 68, 76, 90, 72, 72, 76, 142, 34,
     23, 25, 27, 26, 42,
     /* exact: by distance of the first sample, and whether it was exact */
     215, 150, 90, 235, 140, 104,
     /* second, third */
     80, 126, 244, 225, 240, 160, 130, 64, 180, 240, 200, 224},
    {246, 194, 150, 136, 180, 135, 92,  110, 110, 120, 94,  59,  99,  90,  57,  30,  227,
     109, 166, 119, 109, 89,  102, 87,  142, 125, 184, 182, 138, 147, 150, 118, 101, 132,
     101, 136, 150, 150, 169, 148, 117, 138, 86,  95,  100, 106, 105, 59,  89,  154, 56,
     57,  57,  40,  34,  70,  81,  144, 31,  22,  26,  27,  23,  38,  238, 207, 210, 243,
     234, 224, 71,  138, 252, 232, 252, 229, 115, 111, 173, 246, 215, 249}};

void wire_model_start(wire_model *m, wire_tile_shape shape, unsigned flags) {
    memset(m, 0, sizeof *m);
    for (unsigned i = 0; i < MODEL_CHANCES; i++) {
        m->chance[i] = (uint16_t)(start_chance[(flags & MODEL_NEAR) != 0][i] << 8 | 4);
    }
    m->format = shape.format;
    m->width = shape.width;
    m->flags = (uint8_t)flags;
    m->step = (uint8_t)(2 * (flags & MODEL_NEAR) + 1);
    for (unsigned i = 0; i < 3; i++) {
        m->corner.v[i] = (uint8_t)(wire_sample_most(m->format, i) / 2);
    }
    m->guess = m->corner;
}

static int median(int left, int up, int corner) {
    const int low = left < up ? left : up, high = left < up ? up : left;
    return corner >= high ? low : corner <= low ? high : left + up - corner;
}

/* How rough it is around: 0 flat .. 5, and how many bits of a length are
 * taken as they are. */
static void classify(wire_model *m, int left, int up, int right) {
    static const uint8_t bound[5] = {1, 3, 7, 13, 25};
    static const uint8_t shift[6] = {0, 0, 0, 0, 1, 1};
    const int corner = m->corner.v[0];
    int rough = wire_distance(left, corner) + wire_distance(up, corner) + wire_distance(right, up);
    const int most = wire_sample_most(m->format, 0);
    rough = (most == 255 ? (rough + 2) / 4 : most == 15 ? rough * 4 : rough) / m->step;
    m->kind = 0;
    while (m->kind < 5 && rough >= bound[m->kind]) {
        m->kind++;
    }
    m->shift = (uint8_t)(shift[m->kind] + (most == 255 ? (m->kind > 0) + (m->kind > 2) : 0));
}

static void guess_first(wire_model *m) {
    const int x = m->x, y = m->y;
    const int up = m->row[x].v[0], left = x > 0 ? m->row[x - 1].v[0] : up;
    const int right = x + 1 < m->width ? m->row[x + 1].v[0] : up;
    if (y == 0) {
        m->guess.v[0] = x > 0 ? m->row[x - 1].v[0] : m->corner.v[0];
        m->kind = 3, m->shift = 0;
        return;
    }
    if (x == 0) {
        m->corner.v[0] = (uint8_t)up;
    }
    m->guess.v[0] = (uint8_t)median(left, up, m->corner.v[0]);
    classify(m, left, up, right);
}

static int clamp(int value, int most) {
    return value < 0 ? 0 : value > most ? most : value;
}

static void nearer(const wire_sample **best, int *least, const wire_sample *s, int first) {
    const int d = wire_distance(s->v[0], first);
    if (d < *least) {
        *least = d;
        *best = s;
    }
}

/* The other samples go with the neighbour whose first sample is nearest. */
static void guess_others(wire_model *m, int is_exact) {
    const int x = m->x, y = m->y, first = m->guess.v[0];
    const wire_sample *best = &m->corner;
    int least = 256;
    if (x > 0) {
        nearer(&best, &least, &m->row[x - 1], first);
    }
    if (y > 0) {
        nearer(&best, &least, &m->row[x], first);
        if (x + 1 < m->width) {
            nearer(&best, &least, &m->row[x + 1], first);
        }
        if (x > 0) {
            nearer(&best, &least, &m->corner, first);
        }
    }
    int more = first - best->v[0];
    more = m->format == WIRE_RGB565 ? more / 2 : more;
    for (int i = 1; i < 3; i++) {
        m->guess.v[i] = (uint8_t)clamp(best->v[i] + more, wire_sample_most(m->format, 1));
    }
    m->kind = (uint8_t)((least == 0 ? 0 : least < MODEL_FAR ? 1 : 2) + (is_exact ? 3 : 0));
}

void wire_model_pixel(wire_model *m) {
    m->which = 0;
    if (m->format == WIRE_MONO1) {
        m->stage = AT_MONO;
    } else {
        m->stage = m->flags & MODEL_DELTA ? AT_SAME : AT_ZERO;
        guess_first(m);
    }
}

/* Bits of `mask` at x-1, x, x+1 of a row. */
static unsigned around(unsigned mask, unsigned x) {
    return (mask << 1 >> x) & 7;
}

static unsigned mono_chance(const wire_model *m) {
    const unsigned x = m->x;
    const unsigned left = x > 1 ? m->here >> (x - 2) & 3 : (unsigned)m->here << (2 - x) & 3;
    const unsigned last = m->flags & MODEL_DELTA ? m->old.v[0] : m->above2 >> x & 1;
    return left | around(m->above, x) << 2 | last << 5;
}

static unsigned length_chance(const wire_model *m, unsigned from, unsigned most) {
    return from + (m->count < most ? m->count : most - 1);
}

static unsigned value_chance(const wire_model *m) {
    const unsigned from = MODEL_FIRST + 8u * m->kind;
    switch (m->which) {
    case 0:
        return m->stage == AT_ZERO   ? from
               : m->stage == AT_SIGN ? from + 1
                                     : length_chance(m, from + 2, 6);
    case 1:
        return m->stage == AT_ZERO   ? MODEL_SECOND
               : m->stage == AT_SIGN ? MODEL_SECOND + 1
                                     : length_chance(m, MODEL_SECOND + 2, 3);
    default:
        return m->stage == AT_ZERO   ? MODEL_THIRD
               : m->stage == AT_SIGN ? MODEL_THIRD + 1u + m->second_sign
                                     : length_chance(m, MODEL_THIRD + 4, 3);
    }
}

uint16_t *wire_model_chance(wire_model *m) {
    switch (m->stage) {
    case AT_SAME:
        return m->chance + MODEL_SAME +
               (around(m->above, m->x) | (m->x > 0 ? m->here >> (m->x - 1) & 1 : 0) << 3);
    case AT_MONO:
        return m->chance + mono_chance(m);
    case AT_EXACT:
        return m->chance + MODEL_EXACT + m->kind;
    case AT_GAMMA:
    case AT_REST:
    case AT_SUFFIX:
        return NULL;
    default:
        return m->chance + value_chance(m);
    }
}

static int pixel_done(wire_model *m, wire_sample s) {
    m->corner = m->row[m->x];
    m->row[m->x] = s;
    if (++m->x == m->width) {
        m->x = 0;
        m->y++;
        m->above2 = m->above;
        m->above = m->here;
        m->here = 0;
    }
    return 1;
}

/* The sample is known: on to the next, or done. */
static int sample_done(wire_model *m, int steps) {
    const unsigned i = m->which;
    m->guess.v[i] = (uint8_t)clamp(m->guess.v[i] + steps * m->step, wire_sample_most(m->format, i));
    if (i == 2 || !wire_has_colour(m->format)) {
        return pixel_done(m, m->guess);
    }
    m->which++;
    if (i == 0) {
        guess_others(m, steps == 0);
        m->stage = AT_EXACT;
        return 0;
    }
    m->second_sign = (uint8_t)(steps == 0 ? 0 : steps < 0 ? 1 : 2);
    m->stage = steps == 0 ? AT_SIGN : AT_ZERO; /* not both are zero */
    return 0;
}

static int take_sign(wire_model *m, unsigned bit) {
    m->negative = (uint8_t)bit;
    m->count = 0;
    m->stage = AT_LENGTH;
    return 0;
}

static int take_suffix(wire_model *m, unsigned bits_left, unsigned bit) {
    m->suffix = (uint8_t)(m->suffix << 1 | bit);
    if (bits_left > 1) {
        m->kind--;
        return 0;
    }
    const int size = (m->count << m->shift) + m->suffix + 1;
    return sample_done(m, m->negative ? -size : size);
}

/* The length is known: its last bits come as they are. */
static int length_done(wire_model *m) {
    const unsigned shift = m->which == 0 ? m->shift : 0;
    if (shift == 0) {
        const int size = m->count + 1;
        return sample_done(m, m->negative ? -size : size);
    }
    m->suffix = 0;
    m->kind = (uint8_t)shift; /* counts the bits left */
    m->stage = AT_SUFFIX;
    return 0;
}

static int take_length(wire_model *m, unsigned bit) {
    if (!bit) {
        return length_done(m);
    }
    if (++m->count == MODEL_UNARY) {
        m->kind = 0; /* counts the bits of the gamma code */
        m->stage = AT_GAMMA;
    }
    return 0;
}

static int take_gamma(wire_model *m, unsigned bit) {
    if (bit) {
        return ++m->kind > MODEL_GAMMA_BITS ? -1 : 0;
    }
    m->suffix = 1;
    m->stage = AT_REST;
    return m->kind > 0 ? 0 : length_done(m);
}

static int take_rest(wire_model *m, unsigned bit) {
    m->suffix = (uint8_t)(m->suffix << 1 | bit);
    if (--m->kind > 0) {
        return 0;
    }
    m->count = (uint8_t)(MODEL_UNARY + m->suffix - 1);
    return length_done(m);
}

int wire_model_bit(wire_model *m, unsigned bit) {
    switch (m->stage) {
    case AT_SAME:
        m->here |= (uint16_t)(bit << m->x);
        m->stage = AT_ZERO;
        return bit ? 0 : pixel_done(m, m->old);
    case AT_MONO:
        m->here |= (uint16_t)(bit << m->x);
        return pixel_done(m, (wire_sample){{(uint8_t)bit, 0, 0}});
    case AT_ZERO:
        m->stage = AT_SIGN;
        return bit ? 0 : sample_done(m, 0);
    case AT_SIGN:
        return take_sign(m, bit);
    case AT_LENGTH:
        return take_length(m, bit);
    case AT_GAMMA:
        return take_gamma(m, bit);
    case AT_REST:
        return take_rest(m, bit);
    case AT_SUFFIX:
        return take_suffix(m, m->kind, bit);
    default: /* AT_EXACT */
        m->stage = AT_ZERO;
        return bit ? 0 : pixel_done(m, m->guess);
    }
}
