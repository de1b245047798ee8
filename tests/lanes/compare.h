/* compare - a lanes header beside the scalar reference, operation by operation, bit for bit
 *
 * SPDX-License-Identifier: MIT */
#ifndef TESTS_LANES_COMPARE_H
#define TESTS_LANES_COMPARE_H

#include "tests/lanes/ops.h"

enum { LANES_VALUES = 192 };

/* Edge patterns, then random ones; 0 before lanes_make_values(). */
extern uint32_t lanes_values[LANES_VALUES];
extern const char *const lanes_names[]; /* of every operation, and of OP_mul_add */
extern const int lanes_operands[];

typedef struct lanes_comparison {
    const lanes_probe *probe, *scalar;
    int step;                                /* every so manieth value: 1 compares all pairs */
    unsigned long compared, differ, flushed; /* cases; which the probe said that it flushed in */
    lanes_in in;                             /* of the first that differs, its word ... */
    int word;
    uint32_t got, want;
} lanes_comparison;

void lanes_make_values(void);

/* Runs `op` on pairs of values, and on masks, and counts; `probe`, `scalar` and `step` are given.
 */
void lanes_compare(lanes_comparison *c, enum lanes_op op);

uint32_t lanes_random(void);

/* Signalling NaNs become quiet ones: lanes.h guarantees nothing for them. */
uint32_t lanes_quiet(uint32_t bits);

/* -1, 0, 1 if a is below, equal to, above b; 2 if one is a NaN. Uses the bits alone. */
int lanes_order(uint32_t a, uint32_t b);

/* Whether two results of an operation of this kind are the same. */
int lanes_same(enum lanes_kind kind, uint32_t a, uint32_t b);

#endif
