/* lanes_mve - the 4-lane operations on Arm's M-profile vectors (MVE, "Helium"), with floats
 *
 * Invariant: bit for bit the results of lanes_scalar.h, or plt_flushed(). MVE takes subnormals
 * for zero, whatever FPSCR says, and sets IDC for one that it was given and UFC for one that it
 * would have made; both stay set. Division and roots are done by the scalar unit, which keeps
 * subnormals. LT and LE of MVE are true of a NaN, GT and GE are not: Armv8-M Architecture Reference
 * Manual (DDI 0553), VCMP (floating-point). By intrinsics alone, as gcc 12 takes generic
 * vectors apart.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_LANES_MVE_H
#define PLT_LANES_MVE_H

#include <arm_mve.h>
#include <stdint.h>
#include <string.h>

#define PLT_LANES_REGISTERS 1
#define PLT_LANES_FLUSH 1

typedef float32x4_t f4;

typedef struct u4 {
    uint32x4_t v;
} u4;

/* A bit per byte, in a core register. */
typedef struct m4 {
    uint32_t p;
} m4;

static inline m4 plt_m4(uint32_t p) {
    const m4 r = {p};
    return r;
}

static inline u4 plt_u4(uint32x4_t v) {
    const u4 r = {v};
    return r;
}

/* UFC and IDC of FPSCR. What lies at `results` is stored before, and so was computed before. */
static inline unsigned plt_flushed(const void *results) {
    unsigned status;
    __asm__ volatile("vmrs %0, fpscr" : "=r"(status) : "r"(results) : "memory");
    return status & 0x88u;
}

static inline void plt_flushed_clear(void) {
    unsigned status;
    __asm__ volatile("vmrs %0, fpscr\n\tbic %0, %0, #0x88\n\tvmsr fpscr, %0"
                     : "=r"(status)
                     :
                     : "memory");
}

static inline f4 f4_load(const float *from) {
    return vldrwq_f32(from);
}

static inline f4 f4_load_16(const float *from) {
    return vldrwq_f32(from);
}

static inline f4 f4_load_pair(const float *from) {
    uint64_t pair;
    memcpy(&pair, from, sizeof pair);
    const uint32_t low = (uint32_t)pair, high = (uint32_t)(pair >> 32);
    uint32x4_t v = vdupq_n_u32(low);
    v = vsetq_lane_u32(high, v, 1);
    v = vsetq_lane_u32(high, v, 3);
    return vreinterpretq_f32_u32(v);
}

static inline void f4_store(float *to, f4 a) {
    vstrwq_f32(to, a);
}

static inline u4 u4_load(const uint32_t *from) {
    return plt_u4(vldrwq_u32(from));
}

static inline u4 u4_load_bytes(const unsigned char *from) {
    return plt_u4(vreinterpretq_u32_u8(vldrbq_u8(from)));
}

static inline void u4_store(uint32_t *to, u4 a) {
    vstrwq_u32(to, a.v);
}

static inline f4 f4_all(float x) {
    return vdupq_n_f32(x);
}

static inline u4 u4_all(uint32_t x) {
    return plt_u4(vdupq_n_u32(x));
}

static inline f4 f4_zero(void) {
    return vreinterpretq_f32_u32(vdupq_n_u32(0));
}

static inline m4 m4_bits(unsigned bits) {
    const uint32x4_t lane = {1, 2, 4, 8};
    return plt_m4(vcmpeqq_u32(vandq_u32(vdupq_n_u32(bits), lane), lane));
}

static inline u4 u4_three(uint32_t a, uint32_t b, uint32_t c) {
    uint32x4_t v = vdupq_n_u32(0);
    v = vsetq_lane_u32(a, v, 0);
    v = vsetq_lane_u32(b, v, 1);
    return plt_u4(vsetq_lane_u32(c, v, 2));
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
    const uint8x16_t twos = vdupq_n_u8(0x33), fours = vdupq_n_u8(0x0F);
    uint8x16_t x = vreinterpretq_u8_u32(a.v);
    x = vsubq_u8(x, vandq_u8(vshrq_n_u8(x, 1), vdupq_n_u8(0x55)));
    x = vaddq_u8(vandq_u8(x, twos), vandq_u8(vshrq_n_u8(x, 2), twos));
    x = vandq_u8(vaddq_u8(x, vshrq_n_u8(x, 4)), fours);
    return vaddvq_u8(x);
}

static inline f4 f4_of_u4(u4 a) {
    return vcvtq_f32_s32(vreinterpretq_s32_u32(a.v));
}

static inline u4 u4_of_f4(f4 a) {
    return plt_u4(vreinterpretq_u32_s32(vcvtq_s32_f32(a)));
}

static inline f4 f4_of_bytes(const unsigned char *from) {
    return vcvtq_f32_u32(vldrbq_u32(from));
}

/* By bytes, as halves at odd addresses are a fault. */
static inline f4 f4_of_halves(const unsigned char *from) {
    const uint32x4_t at = {0, 2, 4, 6};
    const uint32x4_t low = vldrbq_gather_offset_u32(from, at);
    const uint32x4_t high = vldrbq_gather_offset_u32(from + 1, at);
    return vcvtq_f32_u32(vorrq_u32(low, vshlq_n_u32(high, 8)));
}

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
    f4 r = a;
    r = vsetq_lane_f32(vgetq_lane_f32(a, 0) / vgetq_lane_f32(b, 0), r, 0);
    r = vsetq_lane_f32(vgetq_lane_f32(a, 1) / vgetq_lane_f32(b, 1), r, 1);
    r = vsetq_lane_f32(vgetq_lane_f32(a, 2) / vgetq_lane_f32(b, 2), r, 2);
    return vsetq_lane_f32(vgetq_lane_f32(a, 3) / vgetq_lane_f32(b, 3), r, 3);
}

static inline f4 f4_sqrt(f4 a) {
    f4 r = a;
    r = vsetq_lane_f32(__builtin_sqrtf(vgetq_lane_f32(a, 0)), r, 0);
    r = vsetq_lane_f32(__builtin_sqrtf(vgetq_lane_f32(a, 1)), r, 1);
    r = vsetq_lane_f32(__builtin_sqrtf(vgetq_lane_f32(a, 2)), r, 2);
    return vsetq_lane_f32(__builtin_sqrtf(vgetq_lane_f32(a, 3)), r, 3);
}

/* a where a REL b, else b. By intrinsics gcc 12 takes the predicate to a core register and back. */
#define PLT_CHOOSE(rel, a, b)                                                                      \
    f4 r;                                                                                          \
    mve_pred16_t p;                                                                                \
    __asm__("vcmp.f32 " rel "\n\tvpsel %q0, %q2, %q3" : "=&w"(r), "=Up"(p) : "w"(a), "w"(b));      \
    (void)p;                                                                                       \
    return r

static inline f4 f4_min(f4 a, f4 b) {
    PLT_CHOOSE("gt, %q3, %q2", a, b);
}

static inline f4 f4_max(f4 a, f4 b) {
    PLT_CHOOSE("gt, %q2, %q3", a, b);
}

#undef PLT_CHOOSE

static inline f4 f4_abs(f4 a) {
    return vabsq_f32(a);
}

static inline f4 f4_neg(f4 a) {
    return vnegq_f32(a);
}

/* By intrinsics the predicate is taken for a signed number of 16 bits, and cut to that. */
#define PLT_COMPARE(rel, a, b)                                                                     \
    uint32_t bits;                                                                                 \
    mve_pred16_t p;                                                                                \
    __asm__("vcmp.f32 " rel "\n\tvmrs %0, p0" : "=r"(bits), "=Up"(p) : "w"(a), "w"(b));            \
    (void)p;                                                                                       \
    return plt_m4(bits)

static inline m4 f4_lt(f4 a, f4 b) {
    PLT_COMPARE("gt, %q3, %q2", a, b);
}

static inline m4 f4_le(f4 a, f4 b) {
    PLT_COMPARE("ge, %q3, %q2", a, b);
}

static inline m4 f4_eq(f4 a, f4 b) {
    PLT_COMPARE("eq, %q2, %q3", a, b);
}

#undef PLT_COMPARE

static inline m4 u4_lt(u4 a, u4 b) {
    return plt_m4(vcmphiq_u32(b.v, a.v));
}

static inline m4 u4_eq(u4 a, u4 b) {
    return plt_m4(vcmpeqq_u32(a.v, b.v));
}

static inline m4 m4_and(m4 a, m4 b) {
    return plt_m4(a.p & b.p);
}

static inline m4 m4_or(m4 a, m4 b) {
    return plt_m4(a.p | b.p);
}

static inline m4 m4_andnot(m4 a, m4 b) {
    return plt_m4(a.p & ~b.p);
}

/* Bits 0, 4, 8 and 12, by two shifts; the constant is one of Thumb's. */
static inline unsigned m4_mask(m4 a) {
    uint32_t x = a.p & 0x11111111u;
    x |= x >> 3;
    x |= x >> 6;
    return x & 15u;
}

static inline f4 f4_select(m4 m, f4 a, f4 b) {
    return vpselq_f32(a, b, (mve_pred16_t)m.p);
}

static inline u4 u4_select(m4 m, u4 a, u4 b) {
    return plt_u4(vpselq_u32(a.v, b.v, (mve_pred16_t)m.p));
}

static inline void f4_swap(m4 m, f4 *a, f4 *b) {
    const f4 x = *a, y = *b;
    *a = f4_select(m, y, x);
    *b = f4_select(m, x, y);
}

static inline float f4_min_lane(f4 a) {
    const float p = vgetq_lane_f32(a, 0), q = vgetq_lane_f32(a, 1);
    const float r = vgetq_lane_f32(a, 2), s = vgetq_lane_f32(a, 3);
    const float x = p < q ? p : q, y = r < s ? r : s;
    return x < y ? x : y;
}

/* Stored interleaved, and loaded as they lie. */
static inline void f4_transpose(f4 *a, f4 *b, f4 *c, f4 *d) {
    float lanes[16];
    const float32x4x4_t rows = {{*a, *b, *c, *d}};
    vst4q_f32(lanes, rows);
    *a = vldrwq_f32(lanes);
    *b = vldrwq_f32(lanes + 4);
    *c = vldrwq_f32(lanes + 8);
    *d = vldrwq_f32(lanes + 12);
}

/* A macro, as the lane is part of the instruction. */
#define f4_lane(a, lane) vdupq_n_f32(vgetq_lane_f32(a, lane))

static inline m4 m4_of_u4(u4 a) {
    return plt_m4(vcmpeqq_u32(a.v, vdupq_n_u32(0xFFFFFFFFu)));
}

static inline f4 f4_turn(f4 a) {
    f4 r = vsetq_lane_f32(vgetq_lane_f32(a, 1), a, 0);
    r = vsetq_lane_f32(vgetq_lane_f32(a, 2), r, 1);
    return vsetq_lane_f32(vgetq_lane_f32(a, 0), r, 2);
}

static inline f4 f4_rotate(f4 a) {
    f4 r = vsetq_lane_f32(vgetq_lane_f32(a, 1), a, 0);
    r = vsetq_lane_f32(vgetq_lane_f32(a, 2), r, 1);
    r = vsetq_lane_f32(vgetq_lane_f32(a, 3), r, 2);
    return vsetq_lane_f32(vgetq_lane_f32(a, 0), r, 3);
}

static inline void f4_store_pairs(uint32_t (*to)[2], const uint8_t at[4], u4 a, f4 b) {
    const uint32x4_t bytes = vshlq_n_u32(vldrbq_u32(at), 3);
    vstrwq_scatter_offset_u32(to[0], bytes, a.v);
    vstrwq_scatter_offset_u32(to[0] + 1, bytes, vreinterpretq_u32_f32(b));
}

static inline void plt_prefetch(const void *at) {
    (void)at;
}

#endif
