/* lanes_sse - the 4-lane operations on x86: SSE2, and SSE4.1 where compiled
 * for it (one instruction instead of three for select)
 *
 * Invariant: bit for bit the results of lanes_scalar.h. MINPS and MAXPS give
 * the second operand for NaN and for two zeros, which is the rule of lanes.h.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_LANES_SSE_H
#define PLT_LANES_SSE_H

#include <emmintrin.h>
#ifdef __SSE4_1__
#include <smmintrin.h>
#endif
#include <stdint.h>
#include <string.h>

#define PLT_LANES_REGISTERS 1

typedef __m128 f4;

typedef struct u4 {
    __m128i v;
} u4;

typedef struct m4 {
    __m128 v;
} m4;

static inline m4 plt_m4(__m128 v) {
    const m4 r = {v};
    return r;
}

static inline u4 plt_u4(__m128i v) {
    const u4 r = {v};
    return r;
}

static inline f4 f4_load(const float *from) {
    return _mm_loadu_ps(from);
}

static inline f4 f4_load_16(const float *from) {
    return _mm_load_ps(from);
}

static inline f4 f4_load_pair(const float *from) {
    const __m128 pair = _mm_castsi128_ps(_mm_loadl_epi64((const __m128i *)(const void *)from));
    return _mm_movelh_ps(pair, pair);
}

static inline void f4_store(float *to, f4 a) {
    _mm_storeu_ps(to, a);
}

static inline u4 u4_load(const uint32_t *from) {
    return plt_u4(_mm_loadu_si128((const __m128i *)(const void *)from));
}

static inline u4 u4_load_bytes(const unsigned char *from) {
    return plt_u4(_mm_loadu_si128((const __m128i *)(const void *)from));
}

static inline void u4_store(uint32_t *to, u4 a) {
    _mm_storeu_si128((__m128i *)(void *)to, a.v);
}

static inline f4 f4_all(float x) {
    return _mm_set1_ps(x);
}

static inline u4 u4_all(uint32_t x) {
    return plt_u4(_mm_set1_epi32((int)x));
}

static inline f4 f4_zero(void) {
    return _mm_setzero_ps();
}

static inline m4 m4_bits(unsigned bits) {
    const __m128i lane = _mm_set_epi32(8, 4, 2, 1);
    const __m128i on = _mm_and_si128(_mm_set1_epi32((int)bits), lane);
    return plt_m4(_mm_castsi128_ps(_mm_cmpeq_epi32(on, lane)));
}

static inline u4 u4_three(uint32_t a, uint32_t b, uint32_t c) {
    return plt_u4(_mm_set_epi32(0, (int)c, (int)b, (int)a));
}

static inline u4 u4_add(u4 a, u4 b) {
    return plt_u4(_mm_add_epi32(a.v, b.v));
}

static inline u4 u4_and(u4 a, u4 b) {
    return plt_u4(_mm_and_si128(a.v, b.v));
}

static inline uint32_t u4_ones(u4 a) {
    const __m128i twos = _mm_set1_epi8(0x33), fours = _mm_set1_epi8(0x0F);
    __m128i x = a.v;
    x = _mm_sub_epi8(x, _mm_and_si128(_mm_srli_epi32(x, 1), _mm_set1_epi8(0x55)));
    x = _mm_add_epi8(_mm_and_si128(x, twos), _mm_and_si128(_mm_srli_epi32(x, 2), twos));
    x = _mm_and_si128(_mm_add_epi8(x, _mm_srli_epi32(x, 4)), fours);
    x = _mm_sad_epu8(x, _mm_setzero_si128());
    return (uint32_t)_mm_cvtsi128_si32(_mm_add_epi32(x, _mm_unpackhi_epi64(x, x)));
}

static inline u4 u4_andnot(u4 a, u4 b) {
    return plt_u4(_mm_andnot_si128(b.v, a.v));
}

static inline f4 f4_of_u4(u4 a) {
    return _mm_cvtepi32_ps(a.v);
}

static inline u4 u4_of_f4(f4 a) {
    return plt_u4(_mm_cvttps_epi32(a));
}

static inline f4 f4_of_bytes(const unsigned char *from) {
    int four;
    memcpy(&four, from, sizeof four);
    const __m128i zero = _mm_setzero_si128();
    const __m128i words = _mm_unpacklo_epi8(_mm_cvtsi32_si128(four), zero);
    return _mm_cvtepi32_ps(_mm_unpacklo_epi16(words, zero));
}

static inline f4 f4_of_halves(const unsigned char *from) {
    const __m128i words = _mm_loadl_epi64((const __m128i *)(const void *)from);
    return _mm_cvtepi32_ps(_mm_unpacklo_epi16(words, _mm_setzero_si128()));
}

static inline f4 f4_add(f4 a, f4 b) {
    return _mm_add_ps(a, b);
}

static inline f4 f4_sub(f4 a, f4 b) {
    return _mm_sub_ps(a, b);
}

static inline f4 f4_mul(f4 a, f4 b) {
    return _mm_mul_ps(a, b);
}

static inline f4 f4_div(f4 a, f4 b) {
    return _mm_div_ps(a, b);
}

static inline f4 f4_sqrt(f4 a) {
    return _mm_sqrt_ps(a);
}

static inline f4 f4_min(f4 a, f4 b) {
    return _mm_min_ps(a, b);
}

static inline f4 f4_max(f4 a, f4 b) {
    return _mm_max_ps(a, b);
}

static inline f4 f4_abs(f4 a) {
    return _mm_and_ps(a, _mm_castsi128_ps(_mm_set1_epi32(0x7FFFFFFF)));
}

static inline f4 f4_neg(f4 a) {
    return _mm_xor_ps(a, _mm_set1_ps(-0.0f));
}

static inline m4 f4_lt(f4 a, f4 b) {
    return plt_m4(_mm_cmplt_ps(a, b));
}

static inline m4 f4_le(f4 a, f4 b) {
    return plt_m4(_mm_cmple_ps(a, b));
}

static inline m4 f4_eq(f4 a, f4 b) {
    return plt_m4(_mm_cmpeq_ps(a, b));
}

static inline m4 u4_lt(u4 a, u4 b) {
    const __m128i sign = _mm_set1_epi32(-0x7FFFFFFF - 1); /* SSE compares signed only */
    return plt_m4(
        _mm_castsi128_ps(_mm_cmplt_epi32(_mm_xor_si128(a.v, sign), _mm_xor_si128(b.v, sign))));
}

static inline m4 u4_eq(u4 a, u4 b) {
    return plt_m4(_mm_castsi128_ps(_mm_cmpeq_epi32(a.v, b.v)));
}

static inline m4 m4_and(m4 a, m4 b) {
    return plt_m4(_mm_and_ps(a.v, b.v));
}

static inline m4 m4_or(m4 a, m4 b) {
    return plt_m4(_mm_or_ps(a.v, b.v));
}

static inline m4 m4_andnot(m4 a, m4 b) {
    return plt_m4(_mm_andnot_ps(b.v, a.v)); /* ANDNPS complements its first operand */
}

static inline unsigned m4_mask(m4 a) {
    return (unsigned)_mm_movemask_ps(a.v);
}

static inline f4 f4_select(m4 m, f4 a, f4 b) {
#ifdef __SSE4_1__
    return _mm_blendv_ps(b, a, m.v);
#else
    return _mm_or_ps(_mm_and_ps(m.v, a), _mm_andnot_ps(m.v, b));
#endif
}

/* Bits that differ, where set, are turned over in both: four instructions, two selects take six. */
static inline void f4_swap(m4 m, f4 *a, f4 *b) {
    const __m128 differ = _mm_and_ps(_mm_xor_ps(*a, *b), m.v);
    *a = _mm_xor_ps(*a, differ);
    *b = _mm_xor_ps(*b, differ);
}

static inline u4 u4_select(m4 m, u4 a, u4 b) {
    return plt_u4(_mm_castps_si128(f4_select(m, _mm_castsi128_ps(a.v), _mm_castsi128_ps(b.v))));
}

static inline float f4_min_lane(f4 a) {
    const f4 pairs = _mm_min_ps(a, _mm_shuffle_ps(a, a, _MM_SHUFFLE(2, 3, 0, 1)));
    return _mm_cvtss_f32(_mm_min_ps(pairs, _mm_movehl_ps(pairs, pairs)));
}

static inline void f4_transpose(f4 *a, f4 *b, f4 *c, f4 *d) {
    _MM_TRANSPOSE4_PS(*a, *b, *c, *d);
}

/* A macro, as the lane is part of the instruction. */
#define f4_lane(a, lane) _mm_castsi128_ps(_mm_shuffle_epi32(_mm_castps_si128(a), 0x55 * (lane)))

static inline m4 m4_of_u4(u4 a) {
    return plt_m4(_mm_castsi128_ps(a.v));
}

static inline f4 f4_turn(f4 a) {
    return _mm_castsi128_ps(_mm_shuffle_epi32(_mm_castps_si128(a), _MM_SHUFFLE(3, 0, 2, 1)));
}

static inline f4 f4_rotate(f4 a) {
    return _mm_shuffle_ps(a, a, _MM_SHUFFLE(0, 3, 2, 1));
}

static inline void f4_store_pairs(uint32_t (*to)[2], const uint8_t at[4], u4 a, f4 b) {
    const __m128 low = _mm_unpacklo_ps(_mm_castsi128_ps(a.v), b);
    const __m128 high = _mm_unpackhi_ps(_mm_castsi128_ps(a.v), b);
    _mm_storel_pi((__m64 *)(void *)to[at[0]], low);
    _mm_storeh_pi((__m64 *)(void *)to[at[1]], low);
    _mm_storel_pi((__m64 *)(void *)to[at[2]], high);
    _mm_storeh_pi((__m64 *)(void *)to[at[3]], high);
}

/* Always inlined: gcc 12 takes a function of nothing but prefetches for one without effects, and
 * drops the calls to it before it inlines them. */
#ifdef __GNUC__
__attribute__((always_inline))
#endif
static inline void
plt_prefetch(const void *at) {
    _mm_prefetch((const char *)at, _MM_HINT_T0);
}

#endif
