/* test_trace_exact - the side of an edge on which a ray passes, against integers
 *
 * Coordinates are integers of at most 20 bits times a power of two, so that 128-bit integers
 * give dir . ((p - org) x (q - org)) exactly.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "engine/trace/exact.h"
#include "tests/reference/random.h"
#include "tests/test.h"

__extension__ typedef __int128 wide;

typedef struct question {
    int32_t p[3], q[3], org[3], dir[3];
} question;

static void to_floats(const int32_t from[3], int power, float to[3]) {
    for (int a = 0; a < 3; a++) {
        to[a] = ldexpf((float)from[a], power);
    }
}

static int side_of(const question *x, int power, int dir_power) {
    float p[3], q[3], org[3], dir[3];
    to_floats(x->p, power, p);
    to_floats(x->q, power, q);
    to_floats(x->org, power, org);
    to_floats(x->dir, dir_power, dir);
    const int side = plt_edge_side(p, q, org, dir);
    CHECK(plt_edge_side(q, p, org, dir) == -side,
          "the reversed edge does not have the opposite side");
    return side;
}

/* The integers know the side always, and the value to a few roundings. */
static void ask_integers(const question *x, int power, int dir_power, wide due) {
    float p[3], q[3], org[3], dir[3];
    to_floats(x->p, power, p);
    to_floats(x->q, power, q);
    to_floats(x->org, power, org);
    to_floats(x->dir, dir_power, dir);
    const plt_scaled v = plt_edge_value(p, q, org, dir);
    const double value = ldexp((double)v.mantissa, v.exponent - 2 * power - dir_power);
    CHECK(fabs(value - (double)due) <= 0x1p-23 * fabs((double)due) &&
              (v.mantissa > 0.0f) == (due > 0) && (v.mantissa < 0.0f) == (due < 0),
          "%a, not %a", value, (double)due);
    CHECK(v.mantissa == 0.0f || (fabsf(v.mantissa) >= 1.0f && fabsf(v.mantissa) <= 2.0f),
          "mantissa %a", (double)v.mantissa);
    CHECK(plt_scaled_float(v, -2 * power - dir_power) == (float)value, "another float");
}

static wide size(wide x) {
    return x < 0 ? -x : x;
}

/* The value, and the sum of the magnitudes of its terms. */
static wide exactly(const question *x, wide *magnitude) {
    wide value = 0;
    *magnitude = 0;
    for (int a = 0; a < 3; a++) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        const wide pb = x->p[b] - x->org[b], pc = x->p[c] - x->org[c];
        const wide eb = x->q[b] - x->p[b], ec = x->q[c] - x->p[c];
        value += x->dir[a] * (pb * ec - pc * eb);
        *magnitude += size(x->dir[a]) * (size(pb * ec) + size(pc * eb));
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

static void ask(const question *x, int power, int dir_power) {
    wide magnitude;
    const wide value = exactly(x, &magnitude);
    const int side = side_of(x, power, dir_power), due = value > 0 ? 1 : (value < 0 ? -1 : 0);
    if (size(value) > magnitude >> 41) {
        CHECK(side == due, "side %d, not %d", side, due);
    } else {
        CHECK(side == 0 || side == due, "side %d, not %d or 0", side, due);
    }
    ask_integers(x, power, dir_power, value);
    on += side == 0;
    off += side != 0;
}

int main(void) {
    random_state r = {3};
    test("a side is never wrong, pairs decide it when farther than 2^-41, and integers always");
    for (int i = 0; i < 400000; i++) {
        const question x = i % 2 ? random_question(&r) : close_question(&r);
        ask(&x, 0, 0);
    }
    CHECK(on > 20000 && off > 20000, "%u on the line, %u off it", on, off);
    test("scaling by powers of two within the limits changes no side");
    for (int i = 0; i < 200000; i++) {
        const question x = i % 2 ? random_question(&r) : close_question(&r);
        const int power = (int)random_below(&r, 120) - 100,
                  dir_power = (int)random_below(&r, 80) - 40;
        ask(&x, power, dir_power);
        CHECK(side_of(&x, power, dir_power) == side_of(&x, 0, 0), "2^%d, 2^%d", power, dir_power);
    }
    return test_done();
}
