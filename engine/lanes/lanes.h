/* lanes - the closed list of 4-lane operations
 *
 * Everything the engine computes for four rays at once goes through the
 * operations below; a platform gives them by a header of its own, named by
 * -DPLT_LANES='"platform/lanes_NAME.h"'. Without one the scalar reference
 * serves, which is also what every other header is compared with, bit for
 * bit (tests/engine/test_lanes.c).
 *
 * Types   f4  four floats, in memory in the order of lanes, and nothing else: 16 bytes
 *         u4  four uint32       m4  four masks, each lane all ones or zero
 *
 * Rules   Every operation is IEEE single precision, round to nearest even,
 *         subnormals kept (or see PLT_LANES_FLUSH); div and sqrt are exact. No operation is fused.
 *         min(a,b) is a < b ? a : b and max(a,b) is a > b ? a : b in every
 *         lane: of a NaN and anything, or of two zeros, the SECOND operand
 *         comes back. Comparisons with a NaN are false. NaN payloads of
 *         arithmetic results are not specified; bit operations, loads,
 *         stores and select keep every bit. Loads and stores may alias any type.
 *
 * load / store      f4_load(const float[4]) f4_store(float[4], f4)  any
 *                   u4_load u4_store                     4-byte alignment
 *                   f4_load_16(const float[4])           16-byte alignment
 *                   f4_load_pair(const float[2]) both, and both again
 *                   u4_load_bytes(const unsigned char[16]) as they lie; any alignment
 * make              f4_all(float) u4_all(uint32) f4_zero()
 *                   u4_three(uint32_t, uint32_t, uint32_t), the fourth is 0
 *                   m4_bits(unsigned) lane i from bit i
 *                   m4_of_u4(u4) of lanes that are all ones or zero
 *                   f4_of_u4(u4) of numbers below 2^31; exact below 2^24
 *                   u4_of_f4(f4) of 0 and above, below 2^31; cut off
 *                   f4_of_bytes(const unsigned char[4]) of 8 bits each
 *                   f4_of_halves(const unsigned char[8]) of 16 bits each, little-endian
 * arithmetic        f4_add f4_sub f4_mul f4_div f4_sqrt f4_min f4_max
 *                   f4_abs f4_neg (sign bit alone) u4_add u4_and u4_andnot (a and not b)
 *                   u4_ones(u4) -> how many of all 128 bits are ones
 * compare           f4_lt f4_le f4_eq u4_lt u4_eq -> m4
 * masks             m4_and m4_or m4_andnot (a and not b) -> m4
 *                   m4_mask(m4) -> bit i from lane i, 0 .. 15
 * choose            f4_select(m4, a, b) u4_select: a where set, else b
 *                   f4_swap(m4, f4*, f4*): exchanged where set
 * cross lanes       f4_min_lane(f4) least lane, -0 before +0 not promised,
 *                   NaN lanes not allowed
 *                   f4_transpose(f4*, f4*, f4*, f4*): 4 rows to 4 columns
 *                   f4_rotate(f4) lanes 1, 2, 3, 0
 *                   f4_turn(f4) lanes 1, 2, 0, 3: axes, each the one after it
 *                   f4_lane(f4, constant) that lane in all
 *                   f4_store_pairs(uint32_t (*to)[2], const uint8_t at[4], u4, f4)
 *                   the bits of both lanes i to to[at[i]], in the order of lanes
 * memory            plt_prefetch(const void *): a hint, may do nothing
 * properties        PLT_LANES_REGISTERS, a macro: 1 if four lanes are one register, 0 if four
 *                   PLT_LANES_FLUSH, a macro, 0 unless defined: 1 if operations may take
 *                   subnormals for zero. A header that defines it has plt_flushed(results), which
 *                   then is not 0 until plt_flushed_clear(), of all that was computed before
 *                   what lies at `results`. Its line in platform/lanes.txt has the flag
 *                   -DPLT_LANES_FLUSHES=1.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_LANES_LANES_H
#define PLT_LANES_LANES_H

#include <float.h>
#include <stdint.h>

#include "engine/lanes/unroll.h"

#if FLT_EVAL_METHOD != 0
#if defined(__i386__)
#error "floats are evaluated in the x87's wider type: add -msse2 -mfpmath=sse"
#elif FLT_EVAL_METHOD == 1
#error "floats are evaluated as doubles: gcc for s390x wants -fexcess-precision=fast"
#else
#error                                                                                             \
    "floats are evaluated in a wider type, by FLT_EVAL_METHOD: an FPU of single precision, or none"
#endif
#endif

/* Lanes that flush serve files that ask whether they did, and say so before they include
 * anything; everywhere else the scalar ones do (DESIGN.md, section 8.2). */
#ifndef PLT_LANES_FLUSHES
#define PLT_LANES_FLUSHES 0
#endif

#if defined(PLT_LANES) && (!PLT_LANES_FLUSHES || defined(PLT_ASKS_FLUSHED))
#include PLT_LANES
#else
#include "engine/lanes/lanes_scalar.h"
#endif

#ifndef PLT_LANES_FLUSH
#define PLT_LANES_FLUSH 0

static inline unsigned plt_flushed(const void *results) {
    (void)results;
    return 0;
}

static inline void plt_flushed_clear(void) {
}
#elif PLT_LANES_FLUSH && !PLT_LANES_FLUSHES
#error "these lanes flush subnormals: their line in platform/lanes.txt lacks -DPLT_LANES_FLUSHES=1"
#endif

#endif
