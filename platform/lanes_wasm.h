/* lanes_wasm - the 4-lane operations on WebAssembly with SIMD128
 *
 * Invariant: bit for bit the results of lanes_scalar.h. f32x4.min and max are not used: of a NaN
 * and a number they give a NaN, of two zeros the lower or the higher. pmin(x, y) is
 * y < x ? y : x and pmax(x, y) x < y ? y : x, so with the operands exchanged they are the rule of
 * lanes.h. Nothing of relaxed SIMD is used, as machines differ there.
 *
 * Source: WebAssembly core specification 2.0, section 4.3.3.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_LANES_WASM_H
#define PLT_LANES_WASM_H

#include <stdint.h>
#include <wasm_simd128.h>

#define PLT_LANES_REGISTERS 1

typedef struct f4 {
    v128_t v;
} f4;

typedef struct u4 {
    v128_t v;
} u4;

typedef struct m4 {
    v128_t v;
} m4;

static inline f4 plt_f4(v128_t v) {
    const f4 r = {v};
    return r;
}

static inline u4 plt_u4(v128_t v) {
    const u4 r = {v};
    return r;
}

static inline m4 plt_m4(v128_t v) {
    const m4 r = {v};
    return r;
}

static inline f4 f4_load(const float *from) {
    return plt_f4(wasm_v128_load(from));
}

static inline f4 f4_load_16(const float *from) {
    return plt_f4(wasm_v128_load(from));
}

static inline f4 f4_load_pair(const float *from) {
    return plt_f4(wasm_v128_load64_splat(from));
}

static inline void f4_store(float *to, f4 a) {
    wasm_v128_store(to, a.v);
}

static inline u4 u4_load(const uint32_t *from) {
    return plt_u4(wasm_v128_load(from));
}

static inline u4 u4_load_bytes(const unsigned char *from) {
    return plt_u4(wasm_v128_load(from));
}

static inline void u4_store(uint32_t *to, u4 a) {
    wasm_v128_store(to, a.v);
}

static inline f4 f4_all(float x) {
    return plt_f4(wasm_f32x4_splat(x));
}

static inline u4 u4_all(uint32_t x) {
    return plt_u4(wasm_u32x4_splat(x));
}

static inline f4 f4_zero(void) {
    return plt_f4(wasm_f32x4_const_splat(0.0f));
}

static inline m4 m4_bits(unsigned bits) {
    const v128_t lane = wasm_u32x4_const(1, 2, 4, 8);
    return plt_m4(wasm_i32x4_eq(wasm_v128_and(wasm_u32x4_splat(bits), lane), lane));
}

static inline u4 u4_three(uint32_t a, uint32_t b, uint32_t c) {
    return plt_u4(wasm_u32x4_make(a, b, c, 0));
}

static inline u4 u4_add(u4 a, u4 b) {
    return plt_u4(wasm_i32x4_add(a.v, b.v));
}

static inline u4 u4_and(u4 a, u4 b) {
    return plt_u4(wasm_v128_and(a.v, b.v));
}

static inline uint32_t u4_ones(u4 a) {
    const v128_t bytes = wasm_i8x16_popcnt(a.v);
    const v128_t sums = wasm_u32x4_extadd_pairwise_u16x8(wasm_u16x8_extadd_pairwise_u8x16(bytes));
    return wasm_u32x4_extract_lane(sums, 0) + wasm_u32x4_extract_lane(sums, 1) +
           wasm_u32x4_extract_lane(sums, 2) + wasm_u32x4_extract_lane(sums, 3);
}

static inline u4 u4_andnot(u4 a, u4 b) {
    return plt_u4(wasm_v128_andnot(a.v, b.v));
}

static inline f4 f4_of_u4(u4 a) {
    return plt_f4(wasm_f32x4_convert_i32x4(a.v));
}

static inline u4 u4_of_f4(f4 a) {
    return plt_u4(wasm_i32x4_trunc_sat_f32x4(a.v));
}

static inline f4 f4_of_bytes(const unsigned char *from) {
    const v128_t halves = wasm_u16x8_extend_low_u8x16(wasm_v128_load32_zero(from));
    return plt_f4(wasm_f32x4_convert_i32x4(wasm_u32x4_extend_low_u16x8(halves)));
}

static inline f4 f4_of_halves(const unsigned char *from) {
    return plt_f4(wasm_f32x4_convert_i32x4(wasm_u32x4_load16x4(from)));
}

static inline f4 f4_add(f4 a, f4 b) {
    return plt_f4(wasm_f32x4_add(a.v, b.v));
}

static inline f4 f4_sub(f4 a, f4 b) {
    return plt_f4(wasm_f32x4_sub(a.v, b.v));
}

static inline f4 f4_mul(f4 a, f4 b) {
    return plt_f4(wasm_f32x4_mul(a.v, b.v));
}

static inline f4 f4_div(f4 a, f4 b) {
    return plt_f4(wasm_f32x4_div(a.v, b.v));
}

static inline f4 f4_sqrt(f4 a) {
    return plt_f4(wasm_f32x4_sqrt(a.v));
}

static inline f4 f4_min(f4 a, f4 b) {
    return plt_f4(wasm_f32x4_pmin(b.v, a.v));
}

static inline f4 f4_max(f4 a, f4 b) {
    return plt_f4(wasm_f32x4_pmax(b.v, a.v));
}

static inline f4 f4_abs(f4 a) {
    return plt_f4(wasm_f32x4_abs(a.v));
}

static inline f4 f4_neg(f4 a) {
    return plt_f4(wasm_f32x4_neg(a.v));
}

static inline m4 f4_lt(f4 a, f4 b) {
    return plt_m4(wasm_f32x4_lt(a.v, b.v));
}

static inline m4 f4_le(f4 a, f4 b) {
    return plt_m4(wasm_f32x4_le(a.v, b.v));
}

static inline m4 f4_eq(f4 a, f4 b) {
    return plt_m4(wasm_f32x4_eq(a.v, b.v));
}

static inline m4 u4_lt(u4 a, u4 b) {
    return plt_m4(wasm_u32x4_lt(a.v, b.v));
}

static inline m4 u4_eq(u4 a, u4 b) {
    return plt_m4(wasm_i32x4_eq(a.v, b.v));
}

static inline m4 m4_and(m4 a, m4 b) {
    return plt_m4(wasm_v128_and(a.v, b.v));
}

static inline m4 m4_or(m4 a, m4 b) {
    return plt_m4(wasm_v128_or(a.v, b.v));
}

static inline m4 m4_andnot(m4 a, m4 b) {
    return plt_m4(wasm_v128_andnot(a.v, b.v));
}

static inline m4 m4_of_u4(u4 a) {
    return plt_m4(a.v);
}

static inline unsigned m4_mask(m4 a) {
    return wasm_i32x4_bitmask(a.v);
}

static inline f4 f4_select(m4 m, f4 a, f4 b) {
    return plt_f4(wasm_v128_bitselect(a.v, b.v, m.v));
}

/* Bits that differ, where set, are turned over in both. */
static inline void f4_swap(m4 m, f4 *a, f4 *b) {
    const v128_t differ = wasm_v128_and(wasm_v128_xor(a->v, b->v), m.v);
    a->v = wasm_v128_xor(a->v, differ);
    b->v = wasm_v128_xor(b->v, differ);
}

static inline u4 u4_select(m4 m, u4 a, u4 b) {
    return plt_u4(wasm_v128_bitselect(a.v, b.v, m.v));
}

static inline float f4_min_lane(f4 a) {
    const v128_t pairs = wasm_f32x4_pmin(a.v, wasm_i32x4_shuffle(a.v, a.v, 1, 0, 3, 2));
    const v128_t all = wasm_f32x4_pmin(pairs, wasm_i32x4_shuffle(pairs, pairs, 2, 3, 0, 1));
    return wasm_f32x4_extract_lane(all, 0);
}

static inline void f4_transpose(f4 *a, f4 *b, f4 *c, f4 *d) {
    const v128_t ab_low = wasm_i32x4_shuffle(a->v, b->v, 0, 4, 1, 5);
    const v128_t ab_high = wasm_i32x4_shuffle(a->v, b->v, 2, 6, 3, 7);
    const v128_t cd_low = wasm_i32x4_shuffle(c->v, d->v, 0, 4, 1, 5);
    const v128_t cd_high = wasm_i32x4_shuffle(c->v, d->v, 2, 6, 3, 7);
    a->v = wasm_i32x4_shuffle(ab_low, cd_low, 0, 1, 4, 5);
    b->v = wasm_i32x4_shuffle(ab_low, cd_low, 2, 3, 6, 7);
    c->v = wasm_i32x4_shuffle(ab_high, cd_high, 0, 1, 4, 5);
    d->v = wasm_i32x4_shuffle(ab_high, cd_high, 2, 3, 6, 7);
}

/* A macro, as the lane is part of the instruction. */
#define f4_lane(a, lane)                                                                           \
    plt_f4(wasm_i32x4_shuffle((a).v, (a).v, (lane)&3, (lane)&3, (lane)&3, (lane)&3))

static inline f4 f4_turn(f4 a) {
    return plt_f4(wasm_i32x4_shuffle(a.v, a.v, 1, 2, 0, 3));
}

static inline f4 f4_rotate(f4 a) {
    return plt_f4(wasm_i32x4_shuffle(a.v, a.v, 1, 2, 3, 0));
}

static inline void f4_store_pairs(uint32_t (*to)[2], const uint8_t at[4], u4 a, f4 b) {
    const v128_t low = wasm_i32x4_shuffle(a.v, b.v, 0, 4, 1, 5);
    const v128_t high = wasm_i32x4_shuffle(a.v, b.v, 2, 6, 3, 7);
    wasm_v128_store64_lane(to[at[0]], low, 0);
    wasm_v128_store64_lane(to[at[1]], low, 1);
    wasm_v128_store64_lane(to[at[2]], high, 0);
    wasm_v128_store64_lane(to[at[3]], high, 1);
}

/* There is no such instruction. */
static inline void plt_prefetch(const void *at) {
    (void)at;
}

#endif
