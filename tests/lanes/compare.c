/* compare - a lanes header beside the scalar reference, operation by operation, bit for bit
 *
 * Freestanding: the same comparison runs on the host and, as firmware, on boards.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/lanes/compare.h"

#include <string.h>

enum { EDGES = 58 };

/* Signs, zeros, subnormals, the ends of the normal range, ties of the last
 * place, integers, infinities, and quiet NaNs with payloads. */
static const uint32_t edges[EDGES] = {
    0x00000000, 0x80000000, 0x00000001, 0x80000001, 0x00000002, 0x00400000, 0x007FFFFE, 0x007FFFFF,
    0x807FFFFF, 0x00800000, 0x80800000, 0x00800001, 0x00FFFFFF, 0x01000000, 0x0C800000, 0x1F800000,
    0x20000000, 0x33800000, 0x33800001, 0x34000000, 0xB3800000, 0x3EAAAAAB, 0x3F000000, 0x3F7FFFFF,
    0x3F800000, 0xBF800000, 0x3F800001, 0x3F800002, 0x3F800003, 0x3FFFFFFF, 0x40000000, 0xC0000000,
    0x40400000, 0x40490FDB, 0x41200000, 0x4B7FFFFF, 0x4B800000, 0x4B800001, 0xCB800000, 0x4F000000,
    0x5F000000, 0x5F7FFFFF, 0x60000000, 0x7E800000, 0x7F000000, 0x7F7FFFFE, 0x7F7FFFFF, 0xFF7FFFFF,
    0x7F800000, 0xFF800000, 0x7FC00000, 0xFFC00000, 0x7FC00001, 0x7FD55555, 0xFFEAAAAA, 0x7FFFFFFF,
    0xFFFFFFFF, 0x42C80000};

const char *const lanes_names[] = {
#define NAME(name, kind, operands) #name,
    LANES_OPS(NAME) "mul then add"};
static const enum lanes_kind kinds[] = {
#define KIND(name, kind, operands) kind,
    LANES_OPS(KIND) ARITHMETIC};
const int lanes_operands[] = {
#define OPERANDS(name, kind, count) count,
    LANES_OPS(OPERANDS) 3};

uint32_t lanes_values[LANES_VALUES];

/* Marsaglia's xorshift. */
uint32_t lanes_random(void) {
    static uint64_t state = 88172645463325252u;
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (uint32_t)(state >> 24);
}

uint32_t lanes_quiet(uint32_t bits) {
    return (bits & 0x7FFFFFFFu) > 0x7F800000u ? bits | 0x00400000u : bits;
}

void lanes_make_values(void) {
    for (int i = 0; i < LANES_VALUES; i++) {
        lanes_values[i] = i < EDGES ? edges[i] : lanes_quiet(lanes_random());
    }
}

static int is_nan(uint32_t bits) {
    return (bits & 0x7FFFFFFFu) > 0x7F800000u;
}

int lanes_order(uint32_t a, uint32_t b) {
    if (is_nan(a) || is_nan(b)) {
        return 2;
    }
    const int64_t x = a >> 31 ? -(int64_t)(a & 0x7FFFFFFFu) : (int64_t)a;
    const int64_t y = b >> 31 ? -(int64_t)(b & 0x7FFFFFFFu) : (int64_t)b;
    return (x > y) - (x < y);
}

int lanes_same(enum lanes_kind kind, uint32_t a, uint32_t b) {
    return a == b || (kind == ARITHMETIC && is_nan(a) && is_nan(b)) ||
           (kind == VALUE && lanes_order(a, b) == 0);
}

/* A header that flushes may have any result where it says that it did, if there was something to
 * flush: an operand or a result below the least normal number, before it was rounded. */
static int is_subnormal(uint32_t bits) {
    return (bits & 0x7FFFFFFFu) != 0 && (bits & 0x7FFFFFFFu) <= 0x00800000u;
}

static int may_flush(const lanes_comparison *c, enum lanes_op op, const lanes_in *in,
                     const uint32_t want[16]) {
    uint32_t product[16] = {0};
    int found = 0;
    if (op == OP_f4_mul || op == OP_mul_add) {
        c->scalar->run(OP_f4_mul, in, product);
    }
    for (int lane = 0; lane < 4; lane++) {
        for (int row = 0; row < lanes_operands[op]; row++) {
            found |= is_subnormal(in->row[row][lane]);
        }
        found |= is_subnormal(want[lane]) || is_subnormal(product[lane]);
        found |= kinds[op] == ARITHMETIC && (op == OP_mul_add ? product : want)[lane] << 1 == 0;
    }
    return found;
}

static void compare(lanes_comparison *c, enum lanes_op op, const lanes_in *in) {
    uint32_t got[16] = {0}, want[16] = {0};
    const int flushed = c->probe->run(op, in, got);
    c->scalar->run(op, in, want);
    c->compared++;
    if (c->probe->flush && flushed && may_flush(c, op, in, want)) {
        c->flushed++;
        return;
    }
    for (int i = 0; i < 16; i++) {
        if (flushed || !lanes_same(kinds[op], got[i], want[i])) {
            if (c->differ++ == 0) {
                c->in = *in;
                c->word = i;
                c->got = got[i];
                c->want = want[i];
            }
            return;
        }
    }
}

/* Four different pairs at a time, each pair once in each lane. */
static void compare_pairs(lanes_comparison *c, enum lanes_op op) {
    for (int i = 0; i < LANES_VALUES; i += c->step) {
        for (int j = 0; j < LANES_VALUES; j += c->step) {
            lanes_in in;
            for (int lane = 0; lane < 4; lane++) {
                in.row[0][lane] = lanes_values[(i + 5 * lane) % LANES_VALUES];
                in.row[1][lane] = lanes_values[(j + 11 * lane) % LANES_VALUES];
                in.row[2][lane] = lanes_values[(i + j + 3 * lane) % LANES_VALUES];
                in.row[3][lane] = lanes_values[(i + 2 * j + lane) % LANES_VALUES];
            }
            in.mask[0] = (unsigned)(i + j) & 15u;
            in.mask[1] = (unsigned)i & 15u;
            compare(c, op, &in);
        }
    }
}

/* All masks, and bits beyond the fourth, which must not matter. */
static void compare_masks(lanes_comparison *c, enum lanes_op op) {
    static const unsigned high[3] = {0, 0xFFFFFFF0u, 0x50u};
    for (unsigned a = 0; a < 16; a++) {
        for (unsigned b = 0; b < 16; b++) {
            lanes_in in = {.mask = {a | high[a % 3], b | high[b % 3]}};
            for (unsigned lane = 0; lane < 4; lane++) {
                in.row[0][lane] = lanes_values[(a * 16 + lane) % LANES_VALUES];
                in.row[1][lane] = lanes_values[(b * 16 + 4 + lane) % LANES_VALUES];
            }
            compare(c, op, &in);
        }
    }
}

/* The least lane of every four values without a NaN. */
static void compare_min_lane(lanes_comparison *c) {
    for (int i = 0; i < LANES_VALUES * 64; i += c->step) {
        lanes_in in = {.mask = {0, 0}};
        for (int lane = 0; lane < 4; lane++) {
            const uint32_t v = lanes_values[lanes_random() % LANES_VALUES];
            in.row[0][lane] = is_nan(v) ? 0x3F800000u + (uint32_t)i : v;
        }
        compare(c, OP_f4_min_lane, &in);
    }
}

void lanes_compare(lanes_comparison *c, enum lanes_op op) {
    c->compared = c->differ = c->flushed = 0;
    if (op == OP_f4_min_lane) {
        compare_min_lane(c);
    } else if (lanes_operands[op] > 0) {
        compare_pairs(c, op);
    }
    if (lanes_operands[op] == 0 || op == OP_f4_select || op == OP_u4_select || op == OP_f4_swap) {
        compare_masks(c, op);
    }
}
