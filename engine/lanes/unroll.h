/* unroll - short loops laid out flat, and functions kept apart
 *
 * Before a loop of 3 or 4 rounds over axes or lanes: unrolled, its arrays live
 * in registers. As loops, at -O2, they go through memory.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_LANES_UNROLL_H
#define PLT_LANES_UNROLL_H

#if defined(__clang__)
#define PLT_UNROLLED _Pragma("clang loop unroll(full)")
#elif defined(__GNUC__)
#define PLT_UNROLLED _Pragma("GCC unroll 4")
#else
#define PLT_UNROLLED
#endif

/* Before a function whose locals must not lie on the stack below what its caller calls
 * next: it is not inlined. */
#if defined(__GNUC__)
#define PLT_OUTLINED __attribute__((noinline))
#else
#define PLT_OUTLINED
#endif

#endif
