/* lanes_neon - the 4-lane operations on Arm: AArch64, and NEON of Armv7
 *
 * Invariant: bit for bit the results of lanes_scalar.h. Vectors of AArch64 do what its scalar unit
 * does. Those of Armv7 flush subnormals, in sums and products as in comparisons, and have no
 * divide: there, floats are computed lane by lane, and compared as the integers that have the order
 * of their numbers. VMIN and VMAX are not lanes.h's: compare and select.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_LANES_NEON_H
#define PLT_LANES_NEON_H

#include <arm_neon.h>
#include <stdint.h>

#if defined(__ARM_BIG_ENDIAN) || defined(__AARCH64EB__)
#error "lanes_neon.h is for little-endian Arm: LANES=scalar serves both"
#endif

#define PLT_LANES_REGISTERS 1

typedef float32x4_t f4;

typedef struct u4 {
    uint32x4_t v;
} u4;

typedef struct m4 {
    uint32x4_t v;
} m4;

/* What lies in memory: of any type, at any multiple of 4, or of 1. */
typedef float32x4_t plt_f4_at_4 __attribute__((may_alias, aligned(4)));
typedef float32x2_t plt_f2_at_4 __attribute__((may_alias, aligned(4)));
typedef uint32x4_t plt_u4_at_4 __attribute__((may_alias, aligned(4)));
typedef uint32x2_t plt_u2_at_4 __attribute__((may_alias, aligned(4)));

static inline m4 plt_m4(uint32x4_t v) {
    const m4 r = {v};
    return r;
}

static inline u4 plt_u4(uint32x4_t v) {
    const u4 r = {v};
    return r;
}

static inline f4 f4_load(const float *from) {
    return *(const plt_f4_at_4 *)(const void *)from;
}

static inline f4 f4_load_16(const float *from) {
    return f4_load(from);
}

static inline f4 f4_load_pair(const float *from) {
    const float32x2_t pair = *(const plt_f2_at_4 *)(const void *)from;
    return vcombine_f32(pair, pair);
}

static inline void f4_store(float *to, f4 a) {
    *(plt_f4_at_4 *)(void *)to = a;
}

static inline u4 u4_load(const uint32_t *from) {
    return plt_u4(*(const plt_u4_at_4 *)(const void *)from);
}

static inline u4 u4_load_bytes(const unsigned char *from) {
    return plt_u4(vreinterpretq_u32_u8(vld1q_u8(from)));
}

static inline void u4_store(uint32_t *to, u4 a) {
    *(plt_u4_at_4 *)(void *)to = a.v;
}

static inline f4 f4_all(float x) {
    return vdupq_n_f32(x);
}

static inline u4 u4_all(uint32_t x) {
    return plt_u4(vdupq_n_u32(x));
}

static inline f4 f4_zero(void) {
    return vdupq_n_f32(0.0f);
}

static inline m4 m4_bits(unsigned bits) {
    const uint32x4_t lane = {1, 2, 4, 8};
    return plt_m4(vtstq_u32(vdupq_n_u32(bits), lane));
}

static inline u4 u4_three(uint32_t a, uint32_t b, uint32_t c) {
    const uint32x4_t r = {a, b, c, 0};
    return plt_u4(r);
}

static inline u4 u4_add(u4 a, u4 b) {
    return plt_u4(vaddq_u32(a.v, b.v));
}

static inline u4 u4_and(u4 a, u4 b) {
    return plt_u4(vandq_u32(a.v, b.v));
}

static inline u4 u4_andnot(u4 a, u4 b) {
    return plt_u4(vbicq_u32(a.v, b.v));
}

static inline uint32_t u4_ones(u4 a) {
    const uint8x16_t ones = vcntq_u8(vreinterpretq_u8_u32(a.v));
#ifdef __aarch64__
    return vaddvq_u8(ones);
#else
    const uint64x2_t halves = vpaddlq_u32(vpaddlq_u16(vpaddlq_u8(ones)));
    return (uint32_t)(vgetq_lane_u64(halves, 0) + vgetq_lane_u64(halves, 1));
#endif
}

static inline f4 f4_of_u4(u4 a) {
    return vcvtq_f32_s32(vreinterpretq_s32_u32(a.v));
}

static inline u4 u4_of_f4(f4 a) {
    return plt_u4(vreinterpretq_u32_s32(vcvtq_s32_f32(a)));
}

static inline f4 f4_of_bytes(const unsigned char *from) {
    const uint8_t four[8] = {from[0], from[1], from[2], from[3], 0, 0, 0, 0};
    return vcvtq_f32_u32(vmovl_u16(vget_low_u16(vmovl_u8(vld1_u8(four)))));
}

static inline f4 f4_of_halves(const unsigned char *from) {
    return vcvtq_f32_u32(vmovl_u16(vreinterpret_u16_u8(vld1_u8(from))));
}

#ifdef __aarch64__

static inline f4 f4_add(f4 a, f4 b) {
    return vaddq_f32(a, b);
}

static inline f4 f4_sub(f4 a, f4 b) {
    return vsubq_f32(a, b);
}

static inline f4 f4_mul(f4 a, f4 b) {
    return vmulq_f32(a, b);
}

static inline f4 f4_div(f4 a, f4 b) {
    return vdivq_f32(a, b);
}

static inline f4 f4_sqrt(f4 a) {
    return vsqrtq_f32(a);
}

static inline m4 f4_lt(f4 a, f4 b) {
    return plt_m4(vcltq_f32(a, b));
}

static inline m4 f4_le(f4 a, f4 b) {
    return plt_m4(vcleq_f32(a, b));
}

static inline m4 f4_eq(f4 a, f4 b) {
    return plt_m4(vceqq_f32(a, b));
}

#else

/* By the scalar unit, which keeps subnormals. The compiler must not see four lanes of one kind, or
 * it makes a vector of them again. */
#define PLT_ALONE(x, expression)                                                                   \
    float x = (expression);                                                                        \
    __asm__("" : "+t"(x))
#define PLT_EACH_LANE(of_a, of_b, operation)                                                       \
    PLT_ALONE(x0, vgetq_lane_f32(of_a, 0) operation vgetq_lane_f32(of_b, 0));                      \
    PLT_ALONE(x1, vgetq_lane_f32(of_a, 1) operation vgetq_lane_f32(of_b, 1));                      \
    PLT_ALONE(x2, vgetq_lane_f32(of_a, 2) operation vgetq_lane_f32(of_b, 2));                      \
    PLT_ALONE(x3, vgetq_lane_f32(of_a, 3) operation vgetq_lane_f32(of_b, 3));                      \
    const f4 r = {x0, x1, x2, x3};                                                                 \
    return r

static inline f4 f4_add(f4 a, f4 b) {
    PLT_EACH_LANE(a, b, +);
}

static inline f4 f4_sub(f4 a, f4 b) {
    PLT_EACH_LANE(a, b, -);
}

static inline f4 f4_mul(f4 a, f4 b) {
    PLT_EACH_LANE(a, b, *);
}

static inline f4 f4_div(f4 a, f4 b) {
    PLT_EACH_LANE(a, b, /);
}

static inline f4 f4_sqrt(f4 a) {
    PLT_ALONE(x0, __builtin_sqrtf(vgetq_lane_f32(a, 0)));
    PLT_ALONE(x1, __builtin_sqrtf(vgetq_lane_f32(a, 1)));
    PLT_ALONE(x2, __builtin_sqrtf(vgetq_lane_f32(a, 2)));
    PLT_ALONE(x3, __builtin_sqrtf(vgetq_lane_f32(a, 3)));
    const f4 r = {x0, x1, x2, x3};
    return r;
}

#undef PLT_EACH_LANE
#undef PLT_ALONE

/* Integers in the order of the numbers: -0 is 0. */
static inline int32x4_t plt_order(f4 a) {
    const int32x4_t bits = vreinterpretq_s32_f32(a), sign = vshrq_n_s32(bits, 31);
    return vsubq_s32(veorq_s32(vandq_s32(bits, vdupq_n_s32(0x7FFFFFFF)), sign), sign);
}

/* Lanes without NaN: a subnormal is equal to itself, flushed or not. */
static inline uint32x4_t plt_ordered(f4 a, f4 b) {
    return vandq_u32(vceqq_f32(a, a), vceqq_f32(b, b));
}

static inline m4 f4_lt(f4 a, f4 b) {
    return plt_m4(vandq_u32(vcltq_s32(plt_order(a), plt_order(b)), plt_ordered(a, b)));
}

static inline m4 f4_le(f4 a, f4 b) {
    return plt_m4(vandq_u32(vcleq_s32(plt_order(a), plt_order(b)), plt_ordered(a, b)));
}

static inline m4 f4_eq(f4 a, f4 b) {
    return plt_m4(vandq_u32(vceqq_s32(plt_order(a), plt_order(b)), plt_ordered(a, b)));
}

#endif

static inline f4 f4_min(f4 a, f4 b) {
    return vbslq_f32(f4_lt(a, b).v, a, b);
}

static inline f4 f4_max(f4 a, f4 b) {
    return vbslq_f32(f4_lt(b, a).v, a, b);
}

static inline f4 f4_abs(f4 a) {
    return vabsq_f32(a);
}

static inline f4 f4_neg(f4 a) {
    return vnegq_f32(a);
}

static inline m4 u4_lt(u4 a, u4 b) {
    return plt_m4(vcltq_u32(a.v, b.v));
}

static inline m4 u4_eq(u4 a, u4 b) {
    return plt_m4(vceqq_u32(a.v, b.v));
}

static inline m4 m4_and(m4 a, m4 b) {
    return plt_m4(vandq_u32(a.v, b.v));
}

static inline m4 m4_or(m4 a, m4 b) {
    return plt_m4(vorrq_u32(a.v, b.v));
}

static inline m4 m4_andnot(m4 a, m4 b) {
    return plt_m4(vbicq_u32(a.v, b.v));
}

static inline unsigned m4_mask(m4 a) {
    const uint32x4_t lane = {1, 2, 4, 8};
    const uint32x4_t bits = vandq_u32(a.v, lane);
#ifdef __aarch64__
    return vaddvq_u32(bits);
#else
    const uint32x2_t pairs = vorr_u32(vget_low_u32(bits), vget_high_u32(bits));
    return vget_lane_u32(pairs, 0) | vget_lane_u32(pairs, 1);
#endif
}

static inline f4 f4_select(m4 m, f4 a, f4 b) {
    return vbslq_f32(m.v, a, b);
}

static inline void f4_swap(m4 m, f4 *a, f4 *b) {
    const f4 x = *a, y = *b;
    *a = vbslq_f32(m.v, y, x);
    *b = vbslq_f32(m.v, x, y);
}

static inline u4 u4_select(m4 m, u4 a, u4 b) {
    return plt_u4(vbslq_u32(m.v, a.v, b.v));
}

static inline float f4_min_lane(f4 a) {
#ifdef __aarch64__
    return vminvq_f32(a);
#else
    const f4 pairs = f4_min(a, vcombine_f32(vget_high_f32(a), vget_low_f32(a)));
    const float x = vgetq_lane_f32(pairs, 0), y = vgetq_lane_f32(pairs, 1);
    return x < y ? x : y;
#endif
}

static inline void f4_transpose(f4 *a, f4 *b, f4 *c, f4 *d) {
    const float32x4x2_t ab = vtrnq_f32(*a, *b), cd = vtrnq_f32(*c, *d);
    *a = vcombine_f32(vget_low_f32(ab.val[0]), vget_low_f32(cd.val[0]));
    *b = vcombine_f32(vget_low_f32(ab.val[1]), vget_low_f32(cd.val[1]));
    *c = vcombine_f32(vget_high_f32(ab.val[0]), vget_high_f32(cd.val[0]));
    *d = vcombine_f32(vget_high_f32(ab.val[1]), vget_high_f32(cd.val[1]));
}

/* A macro, as the lane is part of the instruction. */
#define f4_lane(a, lane) vdupq_lane_f32((lane) < 2 ? vget_low_f32(a) : vget_high_f32(a), (lane)&1)

static inline m4 m4_of_u4(u4 a) {
    return plt_m4(a.v);
}

static inline f4 f4_turn(f4 a) {
    const f4 next = vextq_f32(a, a, 1);
    return vcombine_f32(vget_low_f32(next), vrev64_f32(vget_high_f32(next)));
}

static inline f4 f4_rotate(f4 a) {
    return vextq_f32(a, a, 1);
}

static inline void f4_store_pairs(uint32_t (*to)[2], const uint8_t at[4], u4 a, f4 b) {
    const uint32x4x2_t pairs = vzipq_u32(a.v, vreinterpretq_u32_f32(b));
    *(plt_u2_at_4 *)(void *)to[at[0]] = vget_low_u32(pairs.val[0]);
    *(plt_u2_at_4 *)(void *)to[at[1]] = vget_high_u32(pairs.val[0]);
    *(plt_u2_at_4 *)(void *)to[at[2]] = vget_low_u32(pairs.val[1]);
    *(plt_u2_at_4 *)(void *)to[at[3]] = vget_high_u32(pairs.val[1]);
}

/* Always inlined: gcc 12 takes a function of nothing but prefetches for one without effects, and
 * drops the calls to it before it inlines them. */
__attribute__((always_inline)) static inline void plt_prefetch(const void *at) {
    __builtin_prefetch(at);
}

#endif
