/* test_trace_exact - the side of an edge on which a ray passes, against other integers
 *
 * Coordinates are integers of at most 21 bits times a power of two, so that two 64-bit integers
 * give dir . ((p - org) x (q - org)), of less than 70 bits, exactly.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "engine/trace/exact.h"
#include "tests/reference/random.h"
#include "tests/test.h"

/* high 2^24 + low; low is from 0 to 2^24 - 1. */
typedef struct wide {
    int64_t high, low;
} wide;

enum { LOW = 1 << 24 };

static int64_t low_of(int64_t x) {
    return (x % LOW + LOW) % LOW;
}

/* += a b, where a b / 2^24 and 2^24 b fit into 64 bits with room for a sum. */
static void add_product(wide *sum, int64_t a, int64_t b) {
    const int64_t low = sum->low + low_of(a) * b;
    sum->high += (a - low_of(a)) / LOW * b + (low - low_of(low)) / LOW;
    sum->low = low_of(low);
}

static int sign_of(wide x) {
    return x.high < 0 ? -1 : x.high > 0 || x.low > 0;
}

/* Rounded once, as both parts are doubles. */
static double double_of(wide x) {
    return (double)x.high * LOW + (double)x.low;
}

typedef struct question {
    int32_t p[3], q[3], org[3], dir[3];
} question;

static void to_floats(const int32_t from[3], int power, float to[3]) {
    for (int a = 0; a < 3; a++) {
        to[a] = ldexpf((float)from[a], power);
    }
}

static plt_scaled value_of(const question *x, int power, int dir_power) {
    float p[3], q[3], org[3], dir[3];
    to_floats(x->p, power, p);
    to_floats(x->q, power, q);
    to_floats(x->org, power, org);
    to_floats(x->dir, dir_power, dir);
    const plt_scaled v = plt_edge_value(p, q, org, dir), back = plt_edge_value(q, p, org, dir);
    CHECK(back.mantissa == -v.mantissa && back.exponent == v.exponent,
          "the reversed edge does not have the opposite value");
    return v;
}

static int side_of(plt_scaled v) {
    return (v.mantissa > 0.0f) - (v.mantissa < 0.0f);
}

static wide exactly(const question *x) {
    wide value = {0, 0};
    for (int a = 0; a < 3; a++) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        const int64_t pb = x->p[b] - x->org[b], pc = x->p[c] - x->org[c];
        const int64_t eb = x->q[b] - x->p[b], ec = x->q[c] - x->p[c];
        add_product(&value, pb * ec - pc * eb, x->dir[a]);
    }
    return value;
}

static int32_t integer(random_state *r, unsigned bits) {
    return (int32_t)random_below(r, 2u << bits) - (int32_t)(1u << bits);
}

static question random_question(random_state *r) {
    question x;
    const unsigned bits = 2 + random_below(r, 19);
    for (int a = 0; a < 3; a++) {
        x.p[a] = integer(r, bits);
        x.q[a] = integer(r, bits);
        x.org[a] = integer(r, bits);
        x.dir[a] = integer(r, 2 + random_below(r, 19));
    }
    return x;
}

/* The ray through a point of the line p q, or with one coordinate off by one. */
static question close_question(random_state *r) {
    question x = random_question(r);
    const int32_t steps = 1 + (int32_t)random_below(r, 6), at = (int32_t)random_below(r, 7);
    for (int a = 0; a < 3; a++) {
        x.org[a] = integer(r, 15);
        x.dir[a] = integer(r, 15);
        const int32_t target = x.org[a] + x.dir[a], edge = integer(r, 12);
        x.p[a] = target - at * edge;
        x.q[a] = x.p[a] + steps * edge;
    }
    if (random_below(r, 3)) {
        x.q[random_below(r, 3)] += random_below(r, 2) ? 1 : -1;
    }
    return x;
}

static uint32_t on, off;

/* The side is right, and the value to a few roundings. */
static void ask(const question *x, int power, int dir_power) {
    const wide exact = exactly(x);
    const double due = double_of(exact);
    const plt_scaled v = value_of(x, power, dir_power);
    const double value = ldexp((double)v.mantissa, v.exponent - 2 * power - dir_power);
    CHECK(side_of(v) == sign_of(exact), "side %d", side_of(v));
    CHECK(fabs(value - due) <= 0x1p-23 * fabs(due), "%a, not %a", value, due);
    CHECK(v.mantissa == 0.0f || (fabsf(v.mantissa) >= 1.0f && fabsf(v.mantissa) <= 2.0f),
          "mantissa %a", (double)v.mantissa);
    CHECK(plt_scaled_float(v, -2 * power - dir_power) == (float)value, "another float");
    on += sign_of(exact) == 0;
    off += sign_of(exact) != 0;
}

int main(void) {
    random_state r = {3};
    test("a side is never wrong, and the value to 2^-23");
    for (int i = 0; i < 400000; i++) {
        const question x = i % 2 ? random_question(&r) : close_question(&r);
        ask(&x, 0, 0);
    }
    CHECK(on > 20000 && off > 20000, "%u on the line, %u off it", on, off);
    test("scaling by powers of two within the limits changes nothing else");
    for (int i = 0; i < 200000; i++) {
        const question x = i % 2 ? random_question(&r) : close_question(&r);
        const int power = (int)random_below(&r, 120) - 100,
                  dir_power = (int)random_below(&r, 80) - 40;
        ask(&x, power, dir_power);
        CHECK(value_of(&x, power, dir_power).mantissa == value_of(&x, 0, 0).mantissa, "2^%d, 2^%d",
              power, dir_power);
    }
    return test_done();
}
