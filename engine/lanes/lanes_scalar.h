/* lanes_scalar - the 4-lane operations in plain C: reference and fall-back
 *
 * Invariant: each lane is what lanes.h says of it, and nothing else.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_LANES_LANES_SCALAR_H
#define PLT_LANES_LANES_SCALAR_H

#include <stdint.h>
#include <string.h>

#include "engine/base/float_bits.h"
#include "engine/lanes/unroll.h"

#define PLT_LANES_REGISTERS 0

typedef struct f4 {
    float lane[4];
} f4;

typedef struct u4 {
    uint32_t lane[4];
} u4;

typedef struct m4 {
    uint32_t lane[4];
} m4;

/* One lane after another: `i` counts them. Unrolled (unroll.h), since as a loop
 * the lanes went through memory: 6,365 instructions per ray on the Cortex-M4F at
 * -O2, unrolled 2,822. */
#define PLT_EACH_LANE(type, expression)                                                            \
    type r;                                                                                        \
    PLT_UNROLLED for (int i = 0; i < 4; i++) {                                                     \
        r.lane[i] = (expression);                                                                  \
    }                                                                                              \
    return r

static inline f4 f4_load(const float *from) {
    f4 r;
    memcpy(r.lane, from, sizeof r.lane);
    return r;
}

static inline f4 f4_load_16(const float *from) {
    return f4_load(from);
}

static inline f4 f4_load_pair(const float *from) {
    const f4 r = {{from[0], from[1], from[0], from[1]}};
    return r;
}

static inline void f4_store(float *to, f4 a) {
    memcpy(to, a.lane, sizeof a.lane);
}

static inline u4 u4_load(const uint32_t *from) {
    u4 r;
    memcpy(r.lane, from, sizeof r.lane);
    return r;
}

static inline u4 u4_load_bytes(const unsigned char *from) {
    u4 r;
    memcpy(r.lane, from, sizeof r.lane);
    return r;
}

static inline void u4_store(uint32_t *to, u4 a) {
    memcpy(to, a.lane, sizeof a.lane);
}

static inline f4 f4_all(float x) {
    PLT_EACH_LANE(f4, x);
}

static inline u4 u4_all(uint32_t x) {
    PLT_EACH_LANE(u4, x);
}

static inline f4 f4_zero(void) {
    return f4_all(0.0f);
}

static inline m4 m4_bits(unsigned bits) {
    PLT_EACH_LANE(m4, 0u - ((bits >> i) & 1u));
}

static inline u4 u4_three(uint32_t a, uint32_t b, uint32_t c) {
    const u4 r = {{a, b, c, 0}};
    return r;
}

static inline u4 u4_add(u4 a, u4 b) {
    PLT_EACH_LANE(u4, a.lane[i] + b.lane[i]);
}

static inline u4 u4_and(u4 a, u4 b) {
    PLT_EACH_LANE(u4, a.lane[i] & b.lane[i]);
}

static inline u4 u4_andnot(u4 a, u4 b) {
    PLT_EACH_LANE(u4, a.lane[i] & ~b.lane[i]);
}

static inline uint32_t u4_ones(u4 a) {
    uint32_t ones = 0;
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        uint32_t x = a.lane[i];
        x -= x >> 1 & 0x55555555u;
        x = (x & 0x33333333u) + (x >> 2 & 0x33333333u);
        ones += ((x + (x >> 4)) & 0x0F0F0F0Fu) * 0x01010101u >> 24;
    }
    return ones;
}

static inline f4 f4_of_u4(u4 a) {
    PLT_EACH_LANE(f4, (float)(int32_t)a.lane[i]);
}

static inline u4 u4_of_f4(f4 a) {
    PLT_EACH_LANE(u4, (uint32_t)(int32_t)a.lane[i]);
}

static inline f4 f4_of_bytes(const unsigned char *from) {
    PLT_EACH_LANE(f4, (float)from[i]);
}

static inline f4 f4_of_halves(const unsigned char *from) {
    PLT_EACH_LANE(f4, (float)(from[2 * i] | from[2 * i + 1] << 8));
}

static inline f4 f4_add(f4 a, f4 b) {
    PLT_EACH_LANE(f4, a.lane[i] + b.lane[i]);
}

static inline f4 f4_sub(f4 a, f4 b) {
    PLT_EACH_LANE(f4, a.lane[i] - b.lane[i]);
}

static inline f4 f4_mul(f4 a, f4 b) {
    PLT_EACH_LANE(f4, a.lane[i] * b.lane[i]);
}

static inline f4 f4_div(f4 a, f4 b) {
    PLT_EACH_LANE(f4, a.lane[i] / b.lane[i]);
}

static inline f4 f4_sqrt(f4 a) {
    PLT_EACH_LANE(f4, __builtin_sqrtf(a.lane[i]));
}

static inline f4 f4_min(f4 a, f4 b) {
    PLT_EACH_LANE(f4, a.lane[i] < b.lane[i] ? a.lane[i] : b.lane[i]);
}

static inline f4 f4_max(f4 a, f4 b) {
    PLT_EACH_LANE(f4, a.lane[i] > b.lane[i] ? a.lane[i] : b.lane[i]);
}

static inline f4 f4_abs(f4 a) {
    PLT_EACH_LANE(f4, __builtin_fabsf(a.lane[i])); /* IEEE abs and -: the sign bit alone */
}

static inline f4 f4_neg(f4 a) {
    PLT_EACH_LANE(f4, -a.lane[i]);
}

static inline m4 f4_lt(f4 a, f4 b) {
    PLT_EACH_LANE(m4, 0u - (uint32_t)(a.lane[i] < b.lane[i]));
}

static inline m4 f4_le(f4 a, f4 b) {
    PLT_EACH_LANE(m4, 0u - (uint32_t)(a.lane[i] <= b.lane[i]));
}

static inline m4 f4_eq(f4 a, f4 b) {
    PLT_EACH_LANE(m4, 0u - (uint32_t)(a.lane[i] == b.lane[i]));
}

static inline m4 u4_lt(u4 a, u4 b) {
    PLT_EACH_LANE(m4, 0u - (uint32_t)(a.lane[i] < b.lane[i]));
}

static inline m4 u4_eq(u4 a, u4 b) {
    PLT_EACH_LANE(m4, 0u - (uint32_t)(a.lane[i] == b.lane[i]));
}

static inline m4 m4_and(m4 a, m4 b) {
    PLT_EACH_LANE(m4, a.lane[i] & b.lane[i]);
}

static inline m4 m4_or(m4 a, m4 b) {
    PLT_EACH_LANE(m4, a.lane[i] | b.lane[i]);
}

static inline m4 m4_andnot(m4 a, m4 b) {
    PLT_EACH_LANE(m4, a.lane[i] & ~b.lane[i]);
}

static inline unsigned m4_mask(m4 a) {
    return (a.lane[0] & 1u) | (a.lane[1] & 2u) | (a.lane[2] & 4u) | (a.lane[3] & 8u);
}

static inline f4 f4_select(m4 m, f4 a, f4 b) {
    PLT_EACH_LANE(f4, plt_float_of(m.lane[i] ? plt_bits_of(a.lane[i]) : plt_bits_of(b.lane[i])));
}

static inline void f4_swap(m4 m, f4 *a, f4 *b) {
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        const float x = a->lane[i], y = b->lane[i];
        a->lane[i] = m.lane[i] ? y : x;
        b->lane[i] = m.lane[i] ? x : y;
    }
}

static inline u4 u4_select(m4 m, u4 a, u4 b) {
    PLT_EACH_LANE(u4, m.lane[i] ? a.lane[i] : b.lane[i]);
}

static inline float f4_min_lane(f4 a) {
    const float x = a.lane[0] < a.lane[1] ? a.lane[0] : a.lane[1];
    const float y = a.lane[2] < a.lane[3] ? a.lane[2] : a.lane[3];
    return x < y ? x : y;
}

static inline void f4_transpose(f4 *a, f4 *b, f4 *c, f4 *d) {
    const f4 row[4] = {*a, *b, *c, *d};
    for (int i = 0; i < 4; i++) {
        a->lane[i] = row[i].lane[0];
        b->lane[i] = row[i].lane[1];
        c->lane[i] = row[i].lane[2];
        d->lane[i] = row[i].lane[3];
    }
}

static inline f4 f4_lane(f4 a, int lane) {
    PLT_EACH_LANE(f4, a.lane[lane]);
}

static inline f4 f4_turn(f4 a) {
    const f4 r = {{a.lane[1], a.lane[2], a.lane[0], a.lane[3]}};
    return r;
}

static inline m4 m4_of_u4(u4 a) {
    PLT_EACH_LANE(m4, a.lane[i]);
}

static inline f4 f4_rotate(f4 a) {
    PLT_EACH_LANE(f4, a.lane[(i + 1) & 3]);
}

static inline void f4_store_pairs(uint32_t (*to)[2], const uint8_t at[4], u4 a, f4 b) {
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        to[at[i]][0] = a.lane[i];
        to[at[i]][1] = plt_bits_of(b.lane[i]);
    }
}

static inline void plt_prefetch(const void *at) {
    (void)at;
}

#undef PLT_EACH_LANE

#endif
