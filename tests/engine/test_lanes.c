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
#include <setjmp.h>
#include <signal.h>
#include <stdlib.h>

#include "tests/lanes/compare.h"
#include "tests/test.h"

/* LANES_PROBES: X(name) for each line of platform/lanes.txt (board/host/board.mk). */
#define X(name) extern const lanes_probe lanes_probe_##name;
LANES_PROBES
#undef X

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
    CHECK(lanes_same(ARITHMETIC, got, want), "%08x %08x: %08x, rounded %08x", a, b, got, want);
}

static void test_rounding(enum lanes_op op) {
    char sentence[160];
    snprintf(sentence, sizeof sentence, "scalar: %s is correctly rounded, subnormals kept",
             lanes_names[op]);
    test(sentence);
    for (int i = 0; i < LANES_VALUES; i++) {
        for (int j = 0; j < LANES_VALUES; j++) {
            check_rounded(op, lanes_values[i], lanes_values[j]);
        }
    }
    for (int i = 0; i < 200000; i++) {
        check_rounded(op, lanes_quiet(lanes_random()), lanes_quiet(lanes_random()));
    }
}

static void test_nan_rule(enum lanes_op op, int keep_first) {
    char sentence[160];
    snprintf(sentence, sizeof sentence,
             "scalar: %s gives its second operand for NaN and for two zeros", lanes_names[op]);
    test(sentence);
    for (int i = 0; i < LANES_VALUES; i++) {
        for (int j = 0; j < LANES_VALUES; j++) {
            const uint32_t a = lanes_values[i], b = lanes_values[j];
            const uint32_t want = lanes_order(a, b) == keep_first ? a : b;
            CHECK(scalar(op, a, b, 0) == want, "%08x %08x: %08x", a, b, scalar(op, a, b, 0));
        }
    }
}

static void test_compares(void) {
    test("scalar: compares follow the order of the numbers; with a NaN they are false");
    for (int i = 0; i < LANES_VALUES; i++) {
        for (int j = 0; j < LANES_VALUES; j++) {
            const uint32_t a = lanes_values[i], b = lanes_values[j];
            const int o = lanes_order(a, b);
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
    for (int i = 0; i < LANES_VALUES; i++) {
        CHECK(scalar(OP_f4_abs, lanes_values[i], 0, 0) == (lanes_values[i] & 0x7FFFFFFFu), "%08x",
              lanes_values[i]);
        CHECK(scalar(OP_f4_neg, lanes_values[i], 0, 0) == (lanes_values[i] ^ 0x80000000u), "%08x",
              lanes_values[i]);
    }
}

static void test_whole_numbers(void) {
    test("scalar: integers become floats, rounded to nearest; integer add and mask act on words");
    for (uint32_t i = 0; i < 100000; i++) {
        const uint32_t a = lanes_random(), b = lanes_random(), below = a & 0x7FFFFFFFu;
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
        if (strlen(lanes_names[op]) == length && strncmp(lanes_names[op], name, length) == 0) {
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
            seen[op] |= strlen(lanes_names[op]) == n && strncmp(lanes_names[op], at, n) == 0;
        }
    }
    for (int op = 0; op < LANES_OP_COUNT; op++) {
        CHECK(seen[op], "%s does not name %s", path, lanes_names[op]);
    }
    free(text);
}

static void test_complete(const lanes_probe *p) {
    char sentence[160];
    snprintf(sentence, sizeof sentence, "%s has exactly the closed list of operations", p->header);
    test(sentence);
    check_names(p->header);
}

/* ---- the probes of platform/lanes.txt ---------------------------------- */

#define X(name) &lanes_probe_##name,
static const lanes_probe *const probes[] = {LANES_PROBES};
#undef X

static sigjmp_buf lacking;

static void on_lacking(int number) {
    (void)number;
    siglongjmp(lacking, 1);
}

/* What a compiler can compile the CPU may not have: each operation is tried once. */
static int cpu_has(const lanes_probe *p) {
    const lanes_in in = {.mask = {5, 3}};
    uint32_t out[16];
    void (*before)(int) = signal(SIGILL, on_lacking);
    volatile int has = sigsetjmp(lacking, 1) == 0;
    for (int op = 0; has && op <= LANES_OP_COUNT; op++) {
        p->run((enum lanes_op)op, &in, out);
    }
    signal(SIGILL, before);
    return has;
}

static void test_against_scalar(const lanes_probe *p) {
    static lanes_comparison c;
    c = (lanes_comparison){.probe = p, .scalar = &lanes_probe_scalar, .step = 1};
    for (int op = 0; op <= LANES_OP_COUNT; op++) {
        char sentence[160];
        snprintf(sentence, sizeof sentence, "%s: %s is the scalar reference, bit for bit%s",
                 p->name, lanes_names[op], p->flush ? ", or says that it flushed" : "");
        test(sentence);
        lanes_compare(&c, (enum lanes_op)op);
        const lanes_in *in = &c.in;
        const int lane = c.word & 3;
        CHECK(c.compared > 0 && c.differ == 0,
              "%lu of %lu differ; word %d of %08x %08x %08x mask %x %x: %08x, scalar %08x",
              c.differ, c.compared, c.word, in->row[0][lane], in->row[1][lane], in->row[2][lane],
              in->mask[0], in->mask[1], c.got, c.want);
    }
}

static void test_probe(const lanes_probe *p) {
    if (!p->run) {
        printf("    %s: not tested, as the compiler lacks %s\n", p->name, p->macro);
    } else if (!cpu_has(p)) {
        printf("    %s: not tested, as this CPU lacks instructions of it\n", p->name);
    } else {
        test_not_fused(p);
        if (p != &lanes_probe_scalar) {
            test_complete(p);
            test_against_scalar(p);
        }
    }
}

int main(void) {
    lanes_make_values();
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
    for (size_t i = 0; i < sizeof probes / sizeof *probes; i++) {
        test_probe(probes[i]);
    }
    return test_done();
}
