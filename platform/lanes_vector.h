/* lanes_vector - the 4-lane operations on vectors of GNU C: whatever a compiler has for them, in
 * either byte order
 *
 * For CPUs whose vectors are IEEE single precision with subnormals kept: RISC-V's V by clang,
 * z14's by gcc or clang, Altivec where VSCR[NJ] is 0 (PORTING.md). Where a CPU has no vector
 * divide or square root, compilers do these lane by lane. Wants gcc 12 or clang 12.
 *
 * Invariant: bit for bit the results of lanes_scalar.h. Comparisons give masks, and whatever
 * chooses does so by masks, never by the CPU's own minimum.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_LANES_VECTOR_H
#define PLT_LANES_VECTOR_H

#include <stdint.h>

#define PLT_LANES_REGISTERS 1

typedef float f4 __attribute__((vector_size(16)));
typedef uint32_t plt_lane_words __attribute__((vector_size(16)));
typedef int32_t plt_signed __attribute__((vector_size(16)));

typedef struct u4 {
    plt_lane_words v;
} u4;

typedef struct m4 {
    plt_lane_words v;
} m4;

/* What lies in memory: of any type, at any multiple of 4, or of 1. */
typedef f4 plt_f4_at_4 __attribute__((may_alias, aligned(4)));
typedef f4 plt_f4_at_16 __attribute__((may_alias, aligned(16)));
typedef plt_lane_words plt_lane_words_at_4 __attribute__((may_alias, aligned(4)));
typedef plt_lane_words plt_lane_words_at_1 __attribute__((may_alias, aligned(1)));
typedef float plt_f2_at_4 __attribute__((vector_size(8), may_alias, aligned(4)));
typedef uint8_t plt_bytes_at_1 __attribute__((vector_size(4), may_alias, aligned(1)));
typedef uint16_t plt_halves_at_1 __attribute__((vector_size(8), may_alias, aligned(1)));

static inline m4 plt_m4(plt_lane_words v) {
    const m4 r = {v};
    return r;
}

static inline u4 plt_u4(plt_lane_words v) {
    const u4 r = {v};
    return r;
}

static inline plt_lane_words plt_choose(plt_lane_words m, plt_lane_words a, plt_lane_words b) {
    return (m & a) | (~m & b);
}

static inline f4 f4_load(const float *from) {
    return *(const plt_f4_at_4 *)(const void *)from;
}

static inline f4 f4_load_16(const float *from) {
    return *(const plt_f4_at_16 *)(const void *)from;
}

static inline f4 f4_load_pair(const float *from) {
    const plt_f2_at_4 pair = *(const plt_f2_at_4 *)(const void *)from;
    return __builtin_shufflevector(pair, pair, 0, 1, 0, 1);
}

static inline void f4_store(float *to, f4 a) {
    *(plt_f4_at_4 *)(void *)to = a;
}

static inline u4 u4_load(const uint32_t *from) {
    return plt_u4(*(const plt_lane_words_at_4 *)(const void *)from);
}

static inline u4 u4_load_bytes(const unsigned char *from) {
    return plt_u4(*(const plt_lane_words_at_1 *)(const void *)from);
}

static inline void u4_store(uint32_t *to, u4 a) {
    *(plt_lane_words_at_4 *)(void *)to = a.v;
}

static inline f4 f4_all(float x) {
    const f4 r = {x, x, x, x};
    return r;
}

static inline u4 u4_all(uint32_t x) {
    const plt_lane_words r = {x, x, x, x};
    return plt_u4(r);
}

static inline f4 f4_zero(void) {
    return f4_all(0.0f);
}

static inline m4 m4_bits(unsigned bits) {
    const plt_lane_words lane = {1, 2, 4, 8};
    return plt_m4((plt_lane_words)((u4_all(bits).v & lane) == lane));
}

static inline u4 u4_three(uint32_t a, uint32_t b, uint32_t c) {
    const plt_lane_words r = {a, b, c, 0};
    return plt_u4(r);
}

static inline u4 u4_add(u4 a, u4 b) {
    return plt_u4(a.v + b.v);
}

static inline u4 u4_and(u4 a, u4 b) {
    return plt_u4(a.v & b.v);
}

static inline u4 u4_andnot(u4 a, u4 b) {
    return plt_u4(a.v & ~b.v);
}

static inline uint32_t u4_ones(u4 a) {
    plt_lane_words x = a.v;
    x -= x >> 1 & 0x55555555u;
    x = (x & 0x33333333u) + (x >> 2 & 0x33333333u);
    x = (x + (x >> 4)) & 0x0F0F0F0Fu;
    return (x[0] + x[1] + x[2] + x[3]) * 0x01010101u >> 24;
}

static inline f4 f4_of_u4(u4 a) {
    return __builtin_convertvector((plt_signed)a.v, f4);
}

static inline u4 u4_of_f4(f4 a) {
    return plt_u4((plt_lane_words) __builtin_convertvector(a, plt_signed));
}

static inline f4 f4_of_bytes(const unsigned char *from) {
    const plt_bytes_at_1 bytes = *(const plt_bytes_at_1 *)(const void *)from;
    return __builtin_convertvector(__builtin_convertvector(bytes, plt_signed), f4);
}

static inline f4 f4_of_halves(const unsigned char *from) {
    plt_halves_at_1 halves = *(const plt_halves_at_1 *)(const void *)from;
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    halves = halves << 8 | halves >> 8;
#endif
    return __builtin_convertvector(__builtin_convertvector(halves, plt_signed), f4);
}

static inline f4 f4_add(f4 a, f4 b) {
    return a + b;
}

static inline f4 f4_sub(f4 a, f4 b) {
    return a - b;
}

static inline f4 f4_mul(f4 a, f4 b) {
    return a * b;
}

static inline f4 f4_div(f4 a, f4 b) {
    return a / b;
}

static inline f4 f4_sqrt(f4 a) {
    const f4 r = {__builtin_sqrtf(a[0]), __builtin_sqrtf(a[1]), __builtin_sqrtf(a[2]),
                  __builtin_sqrtf(a[3])};
    return r;
}

static inline f4 f4_min(f4 a, f4 b) {
    return (f4)plt_choose((plt_lane_words)(a < b), (plt_lane_words)a, (plt_lane_words)b);
}

static inline f4 f4_max(f4 a, f4 b) {
    return (f4)plt_choose((plt_lane_words)(a > b), (plt_lane_words)a, (plt_lane_words)b);
}

static inline f4 f4_abs(f4 a) {
    return (f4)((plt_lane_words)a & 0x7FFFFFFFu);
}

static inline f4 f4_neg(f4 a) {
    return (f4)((plt_lane_words)a ^ 0x80000000u);
}

static inline m4 f4_lt(f4 a, f4 b) {
    return plt_m4((plt_lane_words)(a < b));
}

static inline m4 f4_le(f4 a, f4 b) {
    return plt_m4((plt_lane_words)(a <= b));
}

static inline m4 f4_eq(f4 a, f4 b) {
    return plt_m4((plt_lane_words)(a == b));
}

static inline m4 u4_lt(u4 a, u4 b) {
    return plt_m4((plt_lane_words)(a.v < b.v));
}

static inline m4 u4_eq(u4 a, u4 b) {
    return plt_m4((plt_lane_words)(a.v == b.v));
}

static inline m4 m4_and(m4 a, m4 b) {
    return plt_m4(a.v & b.v);
}

static inline m4 m4_or(m4 a, m4 b) {
    return plt_m4(a.v | b.v);
}

static inline m4 m4_andnot(m4 a, m4 b) {
    return plt_m4(a.v & ~b.v);
}

static inline unsigned m4_mask(m4 a) {
    const plt_lane_words lane = {1, 2, 4, 8};
    const plt_lane_words bits = a.v & lane;
    return bits[0] | bits[1] | bits[2] | bits[3];
}

static inline f4 f4_select(m4 m, f4 a, f4 b) {
    return (f4)plt_choose(m.v, (plt_lane_words)a, (plt_lane_words)b);
}

static inline void f4_swap(m4 m, f4 *a, f4 *b) {
    const plt_lane_words differ = ((plt_lane_words)*a ^ (plt_lane_words)*b) & m.v;
    *a = (f4)((plt_lane_words)*a ^ differ);
    *b = (f4)((plt_lane_words)*b ^ differ);
}

static inline u4 u4_select(m4 m, u4 a, u4 b) {
    return plt_u4(plt_choose(m.v, a.v, b.v));
}

static inline float f4_min_lane(f4 a) {
    const f4 pairs = f4_min(a, __builtin_shufflevector(a, a, 2, 3, 0, 1));
    return pairs[0] < pairs[1] ? pairs[0] : pairs[1];
}

static inline void f4_transpose(f4 *a, f4 *b, f4 *c, f4 *d) {
    const f4 ab_low = __builtin_shufflevector(*a, *b, 0, 4, 1, 5);
    const f4 ab_high = __builtin_shufflevector(*a, *b, 2, 6, 3, 7);
    const f4 cd_low = __builtin_shufflevector(*c, *d, 0, 4, 1, 5);
    const f4 cd_high = __builtin_shufflevector(*c, *d, 2, 6, 3, 7);
    *a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
    *b = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
    *c = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
    *d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
}

/* A macro, as the lane is part of the instruction. */
#define f4_lane(a, lane) __builtin_shufflevector((a), (a), (lane), (lane), (lane), (lane))

static inline m4 m4_of_u4(u4 a) {
    return plt_m4(a.v);
}

static inline f4 f4_turn(f4 a) {
    return __builtin_shufflevector(a, a, 1, 2, 0, 3);
}

static inline f4 f4_rotate(f4 a) {
    return __builtin_shufflevector(a, a, 1, 2, 3, 0);
}

static inline void f4_store_pairs(uint32_t (*to)[2], const uint8_t at[4], u4 a, f4 b) {
    const plt_lane_words bits = (plt_lane_words)b;
    for (int i = 0; i < 4; i++) {
        to[at[i]][0] = a.v[i];
        to[at[i]][1] = bits[i];
    }
}

/* Always inlined: gcc 12 takes a function of nothing but prefetches for one without effects, and
 * drops the calls to it before it inlines them. */
__attribute__((always_inline)) static inline void plt_prefetch(const void *at) {
    __builtin_prefetch(at);
}

#endif
