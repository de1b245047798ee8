/* flushing - scalar lanes that take subnormals for zero, as vectors of MVE do, and remember it
 *
 * For tests of what is left out by such lanes (DESIGN.md, section 8.2). By `flushing` they keep
 * subnormals instead, or flush them and do not say so.
 *
 * SPDX-License-Identifier: MIT */
#ifndef TESTS_LANES_FLUSHING_H
#define TESTS_LANES_FLUSHING_H

#define f4_add kept_add
#define f4_sub kept_sub
#define f4_mul kept_mul
#define f4_lt kept_lt
#define f4_le kept_le
#define f4_eq kept_eq
#define f4_min kept_min
#define f4_max kept_max
#include "engine/lanes/lanes_scalar.h"
#undef f4_add
#undef f4_sub
#undef f4_mul
#undef f4_lt
#undef f4_le
#undef f4_eq
#undef f4_min
#undef f4_max

#define PLT_LANES_FLUSH 1

enum flushing { KEEPS, FLUSHES_SILENTLY, FLUSHES };

static struct {
    enum flushing how;
    unsigned status;
} flushing;

static inline unsigned plt_flushed(const void *results) {
    (void)results;
    return flushing.how == FLUSHES ? flushing.status : 0;
}

static inline void plt_flushed_clear(void) {
    flushing.status = 0;
}

static inline f4 flush(f4 a) {
    for (int i = 0; i < 4 && flushing.how != KEEPS; i++) {
        if (a.lane[i] != 0 && __builtin_fabsf(a.lane[i]) < 1.17549435e-38f) {
            a.lane[i] = 0;
            flushing.status = 1;
        }
    }
    return a;
}

static inline f4 f4_add(f4 a, f4 b) {
    return flush(kept_add(flush(a), flush(b)));
}

static inline f4 f4_sub(f4 a, f4 b) {
    return flush(kept_sub(flush(a), flush(b)));
}

static inline f4 f4_mul(f4 a, f4 b) {
    return flush(kept_mul(flush(a), flush(b)));
}

static inline m4 f4_lt(f4 a, f4 b) {
    return kept_lt(flush(a), flush(b));
}

static inline m4 f4_le(f4 a, f4 b) {
    return kept_le(flush(a), flush(b));
}

static inline m4 f4_eq(f4 a, f4 b) {
    return kept_eq(flush(a), flush(b));
}

static inline f4 f4_min(f4 a, f4 b) {
    return f4_select(f4_lt(a, b), a, b);
}

static inline f4 f4_max(f4 a, f4 b) {
    return f4_select(f4_lt(b, a), a, b);
}

#endif
