/* ops - every 4-lane operation by number and name, and what a probe is
 *
 * A probe is one lanes header compiled into one object: `run` does operation `op` on the bits
 * in `in` and leaves the bits of the result in `out`. Floats, integers and masks are all passed
 * as 32-bit words, so no NaN is changed.
 *
 * SPDX-License-Identifier: MIT */
#ifndef TESTS_LANES_OPS_H
#define TESTS_LANES_OPS_H

#include <stdint.h>

/* X(name, kind, operands). Kind: how results compare with the reference.
 *   EXACT       every bit
 *   ARITHMETIC  every bit, but any NaN equals any other
 *   VALUE       as numbers: +0 is -0 */
#define LANES_OPS(X)                                                                               \
    X(f4_load, EXACT, 1)                                                                           \
    X(f4_store, EXACT, 1)                                                                          \
    X(u4_load, EXACT, 1)                                                                           \
    X(u4_store, EXACT, 1)                                                                          \
    X(f4_all, EXACT, 1)                                                                            \
    X(u4_all, EXACT, 1)                                                                            \
    X(u4_three, EXACT, 1)                                                                          \
    X(f4_of_u4, EXACT, 1)                                                                          \
    X(u4_of_f4, EXACT, 1)                                                                          \
    X(f4_of_bytes, EXACT, 1)                                                                       \
    X(f4_of_halves, EXACT, 1)                                                                      \
    X(f4_zero, EXACT, 0)                                                                           \
    X(m4_bits, EXACT, 0)                                                                           \
    X(f4_add, ARITHMETIC, 2)                                                                       \
    X(f4_sub, ARITHMETIC, 2)                                                                       \
    X(f4_mul, ARITHMETIC, 2)                                                                       \
    X(f4_div, ARITHMETIC, 2)                                                                       \
    X(f4_sqrt, ARITHMETIC, 1)                                                                      \
    X(f4_min, EXACT, 2)                                                                            \
    X(f4_max, EXACT, 2)                                                                            \
    X(f4_abs, EXACT, 1)                                                                            \
    X(f4_neg, EXACT, 1)                                                                            \
    X(u4_add, EXACT, 2)                                                                            \
    X(u4_and, EXACT, 2)                                                                            \
    X(u4_andnot, EXACT, 2)                                                                         \
    X(u4_ones, EXACT, 1)                                                                           \
    X(f4_load_pair, EXACT, 1)                                                                      \
    X(u4_load_bytes, EXACT, 1)                                                                     \
    X(f4_lt, EXACT, 2)                                                                             \
    X(f4_le, EXACT, 2)                                                                             \
    X(f4_eq, EXACT, 2)                                                                             \
    X(u4_lt, EXACT, 2)                                                                             \
    X(u4_eq, EXACT, 2)                                                                             \
    X(m4_and, EXACT, 0)                                                                            \
    X(m4_or, EXACT, 0)                                                                             \
    X(m4_andnot, EXACT, 0)                                                                         \
    X(m4_mask, EXACT, 0)                                                                           \
    X(f4_select, EXACT, 2)                                                                         \
    X(u4_select, EXACT, 2)                                                                         \
    X(f4_swap, EXACT, 2)                                                                           \
    X(f4_min_lane, VALUE, 1)                                                                       \
    X(f4_transpose, EXACT, 4)                                                                      \
    X(f4_load_16, EXACT, 1)                                                                        \
    X(f4_rotate, EXACT, 1)                                                                         \
    X(f4_turn, EXACT, 1)                                                                           \
    X(f4_lane, EXACT, 1)                                                                           \
    X(m4_of_u4, EXACT, 0)                                                                          \
    X(f4_store_pairs, EXACT, 3)                                                                    \
    X(plt_prefetch, EXACT, 0)

enum lanes_kind { EXACT, ARITHMETIC, VALUE };

#define LANES_NUMBER(name, kind, operands) OP_##name,
enum lanes_op { LANES_OPS(LANES_NUMBER) LANES_OP_COUNT, OP_mul_add = LANES_OP_COUNT };
#undef LANES_NUMBER

/* Four rows of four words; masks come as bits 0 .. 3 of `mask`. */
typedef struct lanes_in {
    uint32_t row[4][4];
    unsigned mask[2];
} lanes_in;

/* `run` is 0 where the compiler cannot compile the header: it lacks `macro`. */
typedef struct lanes_probe {
    const char *name, *header, *macro;
    int flush; /* PLT_LANES_FLUSH: `run` says whether an operation flushed a subnormal */
    int (*run)(enum lanes_op op, const lanes_in *in, uint32_t out[16]);
} lanes_probe;

#endif
