/* texcoord_code - see texcoord_code.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/texcoord_code.h"

#include <math.h>

#include "engine/base/float_bits.h"
#include "host_tools/mesh/corners.h"

texcoord_code texcoord_code_begin(void) {
    return (texcoord_code){.low = {INFINITY, INFINITY}, .high = {-INFINITY, -INFINITY}};
}

void texcoord_code_add(texcoord_code *t, uint32_t u, uint32_t v) {
    const uint32_t bits[2] = {u, v};
    for (int a = 0; a < 2 && u != CORNER_NO_TEXCOORD; a++) {
        const float x = plt_float_of(bits[a]);
        t->low[a] = x < t->low[a] ? x : t->low[a];
        t->high[a] = x > t->high[a] ? x : t->high[a];
    }
}

/* The greatest number of steps: the last one of u means something else. */
static uint32_t steps_of(int axis, uint32_t bits) {
    return (1u << bits) - (axis == 0 ? 2 : 1);
}

static double step_of(const texcoord_code *t, int axis, uint32_t bits) {
    return ((double)t->high[axis] - (double)t->low[axis]) / steps_of(axis, bits);
}

void texcoord_code_end(texcoord_code *t, uint32_t bits) {
    uint32_t best = bits / 2;
    double least = fmax(step_of(t, 0, best), step_of(t, 1, bits - best));
    for (uint32_t u = PLT_TEXCOORD_BITS_LEAST; u <= PLT_TEXCOORD_BITS_MOST; u++) {
        if (bits - u < PLT_TEXCOORD_BITS_LEAST || bits - u > PLT_TEXCOORD_BITS_MOST) {
            continue;
        }
        const double worse = fmax(step_of(t, 0, u), step_of(t, 1, bits - u));
        if (worse < least * 0.99) { /* even shares, unless it is worth it */
            least = worse;
            best = u;
        }
    }
    for (int a = 0; a < 2; a++) {
        const int is_empty = !(t->low[a] <= t->high[a]);
        t->steps.bits[a] = a == 0 ? best : bits - best;
        t->steps.from[a] = is_empty ? 0 : t->low[a];
        t->steps.step[a] = is_empty ? 0 : (float)step_of(t, a, t->steps.bits[a]);
    }
}

static uint32_t nearest(const texcoord_code *t, int axis, uint32_t bits) {
    const double x = (double)plt_float_of(bits), step = (double)t->steps.step[axis];
    const double most = steps_of(axis, t->steps.bits[axis]);
    const double at = step > 0 ? (x - (double)t->steps.from[axis]) / step : 0;
    return (uint32_t)fmin(fmax(floor(at + 0.5), 0), most);
}

uint32_t texcoord_code_value(texcoord_code *t, uint32_t u, uint32_t v) {
    const uint32_t split = plt_texcoord_split(&t->steps);
    if (u == CORNER_NO_TEXCOORD) {
        return split | 1u << t->steps.bits[0]; /* none: a v that is not 0 */
    }
    const uint32_t value = nearest(t, 0, u) | nearest(t, 1, v) << t->steps.bits[0];
    float is[2];
    plt_texcoord_decode(&t->steps, value, is);
    t->off = fmax(t->off, fabs((double)is[0] - (double)plt_float_of(u)));
    t->off = fmax(t->off, fabs((double)is[1] - (double)plt_float_of(v)));
    return value;
}
