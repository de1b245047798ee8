/* model_wish - the encoder's half of the model: which bit leads to a pixel
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/model.h"

static int steps_to(const wire_model *m, wire_sample pixel, unsigned i) {
    return wire_model_steps(pixel.v[i] - m->guess.v[i], m->step);
}

static int is_near(const wire_model *m, wire_sample a) {
    return wire_distance(a.v[0], m->old.v[0]) <= m->step / 2 &&
           wire_distance(a.v[1], m->old.v[1]) <= m->step / 2 &&
           wire_distance(a.v[2], m->old.v[2]) <= m->step / 2;
}

unsigned wire_model_wish(const wire_model *m, wire_sample pixel) {
    if (m->stage == AT_SAME) {
        return !is_near(m, pixel);
    }
    if (m->stage == AT_MONO) {
        return pixel.v[0];
    }
    if (m->stage == AT_EXACT) {
        return steps_to(m, pixel, 1) != 0 || steps_to(m, pixel, 2) != 0;
    }
    const int steps = steps_to(m, pixel, m->which);
    const unsigned size = (unsigned)(steps < 0 ? -steps : steps) - 1; /* not for AT_ZERO */
    const unsigned shift = m->which == 0 ? m->shift : 0;
    switch (m->stage) {
    case AT_ZERO:
        return steps != 0;
    case AT_SIGN:
        return steps < 0;
    case AT_LENGTH:
        return size >> shift > m->count;
    case AT_GAMMA:
        return ((size >> shift) - MODEL_UNARY + 1) >> m->kind > 1;
    case AT_REST:
        return ((size >> shift) - MODEL_UNARY + 1) >> (m->kind - 1) & 1;
    default: /* AT_SUFFIX: class bits are left */
        return size >> (m->kind - 1) & 1;
    }
}
