/* unroll - short loops laid out flat
 *
 * Before a loop of 3 or 4 rounds over axes or lanes: unrolled, its arrays live
 * in registers. As loops, at -O2, they go through memory.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_LANES_UNROLL_H
#define PLT_LANES_UNROLL_H

/* Before a function that is compiled anew for the constants of every call. */
#ifdef __GNUC__
#define PLT_INLINED static inline __attribute__((always_inline))
#else
#define PLT_INLINED static inline
#endif

#if defined(__clang__)
#define PLT_UNROLLED _Pragma("clang loop unroll(full)")
#elif defined(__GNUC__)
#define PLT_UNROLLED _Pragma("GCC unroll 4")
#else
#define PLT_UNROLLED
#endif

#endif
