/* test_lanes - every lanes header against the scalar reference, bit for bit, and the scalar
 * reference against integers and double precision
 *
 * Double is reference enough for + - * / sqrt of floats: when the wide format has at least 2 p
 * + 2 bits (53 for p = 24), rounding its result a second time gives the same as rounding once
 * (S. A. Figueroa, When is double rounding innocuous?, 1995). Subnormal results have a smaller
 * p.
 *
 * SPDX-License-Identifier: MIT */
#include <ctype.h>
#include <math.h>
#include <stdlib.h>

#include "tests/reference/lanes_ops.h"
#include "tests/test.h"

enum { EDGES = 58, VALUES = 192 };

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

static const char *const names[] = {
#define NAME(name, kind, operands) #name,
    LANES_OPS(NAME) "mul then add"};
static const enum lanes_kind kinds[] = {
#define KIND(name, kind, operands) kind,
    LANES_OPS(KIND) ARITHMETIC};
static const int operands[] = {
#define OPERANDS(name, kind, count) count,
    LANES_OPS(OPERANDS) 3};

static uint32_t values[VALUES];
static uint64_t random_state = 88172645463325252u;

static uint32_t random_word(void) {
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return (uint32_t)(random_state >> 24);
}

/* Signalling NaNs become quiet ones: lanes.h guarantees nothing for them. */
static uint32_t quiet(uint32_t bits) {
    return (bits & 0x7FFFFFFFu) > 0x7F800000u ? bits | 0x00400000u : bits;
}

static void make_values(void) {
    for (int i = 0; i < VALUES; i++) {
        values[i] = i < EDGES ? edges[i] : quiet(random_word());
    }
}

static int is_nan(uint32_t bits) {
    return (bits & 0x7FFFFFFFu) > 0x7F800000u;
}

static float as_float(uint32_t bits) {
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static uint32_t as_bits(float x) {
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/* -1, 0, 1 if a is below, equal to, above b; 2 if one is a NaN. Uses the bits alone, no float
 * compare. */
static int order(uint32_t a, uint32_t b) {
    if (is_nan(a) || is_nan(b)) {
        return 2;
    }
    const int64_t x = a >> 31 ? -(int64_t)(a & 0x7FFFFFFFu) : (int64_t)a;
    const int64_t y = b >> 31 ? -(int64_t)(b & 0x7FFFFFFFu) : (int64_t)b;
    return (x > y) - (x < y);
}

static int same(enum lanes_kind kind, uint32_t a, uint32_t b) {
    return a == b || (kind == ARITHMETIC && is_nan(a) && is_nan(b)) ||
           (kind == VALUE && order(a, b) == 0);
}

static int compare(const lanes_probe *p, enum lanes_op op, const lanes_in *in) {
    uint32_t got[16] = {0}, want[16] = {0};
    p->run(op, in, got);
    lanes_probe_scalar.run(op, in, want);
    for (int i = 0; i < 16; i++) {
        if (!same(kinds[op], got[i], want[i])) {
            printf("    %s lane %d of %08x %08x %08x mask %x %x: %08x, scalar %08x\n", names[op], i,
                   in->row[0][i & 3], in->row[1][i & 3], in->row[2][i & 3], in->mask[0],
                   in->mask[1], got[i], want[i]);
            return 0;
        }
    }
    return 1;
}

/* Four different pairs at a time, each pair once in each lane. */
static void compare_pairs(const lanes_probe *p, enum lanes_op op) {
    for (int i = 0; i < VALUES; i++) {
        for (int j = 0; j < VALUES; j++) {
            lanes_in in;
            for (int lane = 0; lane < 4; lane++) {
                in.row[0][lane] = values[(i + 5 * lane) % VALUES];
                in.row[1][lane] = values[(j + 11 * lane) % VALUES];
                in.row[2][lane] = values[(i + j + 3 * lane) % VALUES];
                in.row[3][lane] = values[(i + 2 * j + lane) % VALUES];
            }
            in.mask[0] = (unsigned)(i + j) & 15u;
            in.mask[1] = (unsigned)i & 15u;
            CHECK(compare(p, op, &in), "%s differs", p->name);
        }
    }
}

/* All masks, and bits beyond the fourth, which must not matter. */
static void compare_masks(const lanes_probe *p, enum lanes_op op) {
    static const unsigned high[3] = {0, 0xFFFFFFF0u, 0x50u};
    for (unsigned a = 0; a < 16; a++) {
        for (unsigned b = 0; b < 16; b++) {
            lanes_in in = {.mask = {a | high[a % 3], b | high[b % 3]}};
            for (unsigned lane = 0; lane < 4; lane++) {
                in.row[0][lane] = values[(a * 16 + lane) % VALUES];
                in.row[1][lane] = values[(b * 16 + 4 + lane) % VALUES];
            }
            CHECK(compare(p, op, &in), "%s differs", p->name);
        }
    }
}

/* The least lane of every four values without a NaN. */
static void compare_min_lane(const lanes_probe *p) {
    for (int i = 0; i < VALUES * 64; i++) {
        lanes_in in = {.mask = {0, 0}};
        for (int lane = 0; lane < 4; lane++) {
            const uint32_t v = values[random_word() % VALUES];
            in.row[0][lane] = is_nan(v) ? 0x3F800000u + (uint32_t)i : v;
        }
        CHECK(compare(p, OP_f4_min_lane, &in), "%s differs", p->name);
    }
}

static void test_against_scalar(const lanes_probe *p) {
    char sentence[160];
    for (int op = 0; op <= LANES_OP_COUNT; op++) {
        snprintf(sentence, sizeof sentence, "%s: %s is the scalar reference, bit for bit", p->name,
                 names[op]);
        test(sentence);
        if (op == OP_f4_min_lane) {
            compare_min_lane(p);
        } else if (operands[op] > 0) {
            compare_pairs(p, (enum lanes_op)op);
        }
        if (operands[op] == 0 || op == OP_f4_select || op == OP_u4_select || op == OP_f4_swap) {
            compare_masks(p, (enum lanes_op)op);
        }
    }
}

/* ---- the scalar reference itself ------------------------------------- */

static uint32_t scalar(enum lanes_op op, uint32_t a, uint32_t b, uint32_t c) {
    const lanes_in in = {.row = {{a, a, a, a}, {b, b, b, b}, {c, c, c, c}}, .mask = {15, 15}};
    uint32_t out[16] = {0};
    lanes_probe_scalar.run(op, &in, out);
    return out[0];
}

static uint32_t by_double(enum lanes_op op, double a, double b) {
    switch ((int)op) {
    case OP_f4_add:
        return as_bits((float)(a + b));
    case OP_f4_sub:
        return as_bits((float)(a - b));
    case OP_f4_mul:
        return as_bits((float)(a * b));
    case OP_f4_sqrt:
        return as_bits((float)sqrt(a));
    default:
        return as_bits((float)(a / b));
    }
}

static void check_rounded(enum lanes_op op, uint32_t a, uint32_t b) {
    const uint32_t got = scalar(op, a, b, 0);
    const uint32_t want = by_double(op, (double)as_float(a), (double)as_float(b));
    CHECK(same(ARITHMETIC, got, want), "%08x %08x: %08x, rounded %08x", a, b, got, want);
}

static void test_rounding(enum lanes_op op) {
    char sentence[160];
    snprintf(sentence, sizeof sentence, "scalar: %s is correctly rounded, subnormals kept",
             names[op]);
    test(sentence);
    for (int i = 0; i < VALUES; i++) {
        for (int j = 0; j < VALUES; j++) {
            check_rounded(op, values[i], values[j]);
        }
    }
    for (int i = 0; i < 200000; i++) {
        check_rounded(op, quiet(random_word()), quiet(random_word()));
    }
}

static void test_nan_rule(enum lanes_op op, int keep_first) {
    char sentence[160];
    snprintf(sentence, sizeof sentence,
             "scalar: %s gives its second operand for NaN and for two zeros", names[op]);
    test(sentence);
    for (int i = 0; i < VALUES; i++) {
        for (int j = 0; j < VALUES; j++) {
            const uint32_t a = values[i], b = values[j];
            const uint32_t want = order(a, b) == keep_first ? a : b;
            CHECK(scalar(op, a, b, 0) == want, "%08x %08x: %08x", a, b, scalar(op, a, b, 0));
        }
    }
}

static void test_compares(void) {
    test("scalar: compares follow the order of the numbers; with a NaN they are false");
    for (int i = 0; i < VALUES; i++) {
        for (int j = 0; j < VALUES; j++) {
            const uint32_t a = values[i], b = values[j];
            const int o = order(a, b);
            CHECK(scalar(OP_f4_lt, a, b, 0) == 0u - (uint32_t)(o == -1), "%08x < %08x", a, b);
            CHECK(scalar(OP_f4_le, a, b, 0) == 0u - (uint32_t)(o == -1 || o == 0), "%08x <= %08x",
                  a, b);
            CHECK(scalar(OP_f4_eq, a, b, 0) == 0u - (uint32_t)(o == 0), "%08x == %08x", a, b);
            CHECK(scalar(OP_u4_lt, a, b, 0) == 0u - (uint32_t)(a < b), "u %08x < %08x", a, b);
        }
    }
}

static void test_sign_bits(void) {
    test("scalar: abs clears and neg flips only the sign bit, also of NaNs");
    for (int i = 0; i < VALUES; i++) {
        CHECK(scalar(OP_f4_abs, values[i], 0, 0) == (values[i] & 0x7FFFFFFFu), "%08x", values[i]);
        CHECK(scalar(OP_f4_neg, values[i], 0, 0) == (values[i] ^ 0x80000000u), "%08x", values[i]);
    }
}

static void test_whole_numbers(void) {
    test("scalar: integers become floats, rounded to nearest; integer add and mask act on words");
    for (uint32_t i = 0; i < 100000; i++) {
        const uint32_t a = random_word(), b = random_word(), below = a & 0x7FFFFFFFu;
        CHECK(scalar(OP_f4_of_u4, below, 0, 0) == as_bits((float)(double)below), "%08x", below);
        const float share = (float)below / 64.0f;
        CHECK(scalar(OP_u4_of_f4, as_bits(share), 0, 0) == (uint32_t)floor((double)share),
              "%08x / 64", below);
        CHECK(scalar(OP_f4_of_bytes, a, 0, 0) == as_bits((float)(a & 0xFFu)), "%08x", a);
        CHECK(scalar(OP_f4_of_halves, a, 0, 0) == as_bits((float)(a & 0xFFFFu)), "%08x", a);
        CHECK(scalar(OP_u4_add, a, b, 0) == (uint32_t)((uint64_t)a + b), "%08x %08x", a, b);
        CHECK(scalar(OP_u4_and, a, b, 0) == ~(~a | ~b), "%08x %08x", a, b);
        CHECK(scalar(OP_u4_andnot, a, b, 0) == ~(~a | b), "%08x %08x", a, b);
    }
    const lanes_in in = {.row = {{1, 2, 3, 4}}};
    uint32_t out[16] = {0};
    lanes_probe_scalar.run(OP_u4_ones, &in, out);
    CHECK(out[0] == 5, "ones of 1, 2, 3 and 4");
    lanes_probe_scalar.run(OP_f4_load_pair, &in, out);
    CHECK(out[0] == 1 && out[1] == 2 && out[2] == 1 && out[3] == 2, "a pair twice");
    lanes_probe_scalar.run(OP_u4_three, &in, out);
    CHECK(out[0] == 1 && out[1] == 2 && out[2] == 3 && out[3] == 0, "three words and 0");
}

/* Every pair of lanes where it belongs, the later of two on top. */
static void test_crossing(void) {
    test("scalar: lanes rotate by one; pairs go where they are told, in the order of lanes");
    const lanes_in in = {.row = {{1, 2, 3, 4}, {5, 6, 7, 8}, {6, 0, 6, 3}}};
    const lanes_in halves = {.row = {{1, 2, 3, 4}, {5, 6, 7, 8}}, .mask = {5, 0}};
    uint32_t out[16] = {0};
    lanes_probe_scalar.run(OP_f4_rotate, &in, out);
    CHECK(out[0] == 2 && out[1] == 3 && out[2] == 4 && out[3] == 1, "rotated");
    lanes_probe_scalar.run(OP_f4_turn, &in, out);
    CHECK(out[0] == 2 && out[1] == 3 && out[2] == 1 && out[3] == 4, "turned");
    lanes_probe_scalar.run(OP_f4_swap, &halves, out);
    CHECK(out[0] == 5 && out[1] == 2 && out[2] == 7 && out[3] == 4 && out[4] == 1 && out[5] == 6 &&
              out[6] == 3 && out[7] == 8,
          "swapped");
    lanes_probe_scalar.run(OP_f4_lane, &in, out);
    for (uint32_t i = 0; i < 16; i++) {
        CHECK(out[i] == 1 + i / 4, "lane %u in all", i / 4);
    }
    memset(out, 0x77, sizeof out);
    lanes_probe_scalar.run(OP_f4_store_pairs, &in, out);
    CHECK(out[12] == 3 && out[13] == 7 && out[0] == 2 && out[1] == 6 && out[6] == 4 && out[7] == 8,
          "pairs");
    CHECK(out[2] == 0x77777777u && out[15] == 0x77777777u, "nothing else is written");
}

/* (1 + 2^-12)^2 - (1 + 2^-11) is 2^-24 when fused and 0 when rounded twice. */
static void test_not_fused(const lanes_probe *p) {
    char sentence[160];
    snprintf(sentence, sizeof sentence, "%s: a product and a sum round twice, never fused",
             p->name);
    test(sentence);
    const uint32_t a = as_bits(1.000244140625f), c = as_bits(-1.00048828125f);
    const lanes_in in = {.row = {{a, a, a, a}, {a, a, a, a}, {c, c, c, c}}};
    uint32_t out[16] = {0};
    p->run(OP_mul_add, &in, out);
    for (int lane = 0; lane < 4; lane++) {
        CHECK(out[lane] == 0, "lane %d is %08x", lane, out[lane]);
    }
}

/* ---- the list is complete ---------------------------------------------- */

static char *read_text(const char *path) {
    FILE *f = fopen(path, "rb");
    char *text = calloc(1, 65536);
    if (f && text) {
        text[fread(text, 1, 65535, f)] = '\0';
    }
    if (f) {
        fclose(f);
    }
    return text;
}

static int is_listed(const char *name, size_t length) {
    for (int op = 0; op < LANES_OP_COUNT; op++) {
        if (strlen(names[op]) == length && strncmp(names[op], name, length) == 0) {
            return 1;
        }
    }
    return 0;
}

static int starts_name(const char *text, const char *at) {
    return (at == text || !(isalnum((unsigned char)at[-1]) || at[-1] == '_')) &&
           (strncmp(at, "f4_", 3) == 0 || strncmp(at, "u4_", 3) == 0 ||
            strncmp(at, "m4_", 3) == 0 || strncmp(at, "plt_prefetch", 12) == 0);
}

/* Every operation the file names is in the list, and vice versa. Only whole words count as
 * names; in lanes.h the list is prose. */
static void check_names(const char *path) {
    char *text = read_text(path);
    int seen[LANES_OP_COUNT] = {0};
    CHECK(text && *text, "cannot read %s (run from the top folder)", path);
    for (const char *at = text; at && *at; at++) {
        size_t n = 0;
        if (!starts_name(text, at)) {
            continue;
        }
        while (isalnum((unsigned char)at[n]) || at[n] == '_') {
            n++;
        }
        CHECK(is_listed(at, n), "%s names %.*s, which no probe runs", path, (int)n, at);
        for (int op = 0; op < LANES_OP_COUNT; op++) {
            seen[op] |= strlen(names[op]) == n && strncmp(names[op], at, n) == 0;
        }
    }
    for (int op = 0; op < LANES_OP_COUNT; op++) {
        CHECK(seen[op], "%s does not name %s", path, names[op]);
    }
    free(text);
}

static void test_complete(const lanes_probe *p) {
    char sentence[160];
    snprintf(sentence, sizeof sentence, "%s has exactly the closed list of operations", p->header);
    test(sentence);
    check_names(p->header);
}

static void test_probe(const lanes_probe *p) {
    test_against_scalar(p);
    test_not_fused(p);
}

int main(void) {
    make_values();
    test("lanes.h lists exactly the operations that the probes run");
    check_names("engine/lanes/lanes.h");
    test_complete(&lanes_probe_scalar);
    for (int op = OP_f4_add; op <= OP_f4_sqrt; op++) {
        test_rounding((enum lanes_op)op);
    }
    test_nan_rule(OP_f4_min, -1);
    test_nan_rule(OP_f4_max, 1);
    test_compares();
    test_sign_bits();
    test_whole_numbers();
    test_crossing();
    test_not_fused(&lanes_probe_scalar);
#ifdef LANES_X86
    test_complete(&lanes_probe_sse2);
    test_probe(&lanes_probe_sse2);
    if (__builtin_cpu_supports("sse4.1")) {
        test_probe(&lanes_probe_sse41);
    }
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
        test_probe(&lanes_probe_sse_fma);
        test_probe(&lanes_probe_scalar_fma);
    } else {
        printf("    this CPU has no FMA: two probes not run\n");
    }
#endif
    return test_done();
}
