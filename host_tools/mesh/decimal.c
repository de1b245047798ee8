/* decimal - numbers in text, the same in every locale
 *
 * Keeps: every float and every double is correctly rounded. The first 15 digits m
 * and the power e give m * 10^e with one rounding in double (m < 2^53, |e| <= 22).
 * When digits were left out, strtod rounds the whole number; it gets digits and an
 * exponent without a decimal point, which no locale can change. The nearest double,
 * rounded again, is the nearest float unless it fell on the middle between two, or where
 * floats are subnormal: then strtof rounds the whole number.
 *
 * Source: W. D. Clinger, How to Read Floating Point Numbers Accurately,
 * PLDI 1990.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/decimal.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    QUICK_DIGITS = 15,
    QUICK_POWER = 22,
    /* No middle between two doubles has more digits; what follows these
     * only matters as being zero or not. */
    SLOW_DIGITS = 770,
};

static const int64_t EXPONENT_MAX = 1000000000000000; /* clamps the sum below int64_t */

typedef struct number {
    const unsigned char *digits; /* the first that is not 0, else `end` */
    const unsigned char *end;    /* after the last digit or point */
    uint64_t leading;            /* the first QUICK_DIGITS of them */
    int64_t power;               /* of ten, for `leading` as an integer */
    int dropped;                 /* digits that are not in `leading` exist */
} number;

static int is_digit(unsigned char c) {
    return c >= '0' && c <= '9';
}

/* Digits with at most one point; NULL without a digit. */
static const unsigned char *read_digits(const unsigned char *at, const unsigned char *end,
                                        number *n) {
    int any = 0, point = 0, count = 0;
    *n = (number){0};
    for (; at < end; at++) {
        if (*at == '.' && !point) {
            point = 1;
            continue;
        }
        if (!is_digit(*at)) {
            break;
        }
        any = 1;
        n->power -= point;
        if (count == 0 && *at == '0') {
            continue;
        }
        if (count == 0) {
            n->digits = at;
        }
        if (count < QUICK_DIGITS) {
            n->leading = n->leading * 10 + (uint64_t)(*at - '0');
            count++;
        } else {
            n->power++;
            n->dropped = 1;
        }
    }
    n->end = at;
    if (!n->digits) {
        n->digits = at;
    }
    return any ? at : NULL;
}

static const unsigned char *read_exponent(const unsigned char *at, const unsigned char *end,
                                          number *n) {
    const unsigned char *c = at;
    if (c == end || (*c != 'e' && *c != 'E')) {
        return at;
    }
    c++;
    const int negative = c < end && *c == '-';
    c += c < end && (*c == '-' || *c == '+');
    if (c == end || !is_digit(*c)) {
        return at;
    }
    int64_t exponent = 0;
    for (; c < end && is_digit(*c); c++) {
        if (exponent < EXPONENT_MAX) {
            exponent = exponent * 10 + (*c - '0');
        }
    }
    n->power += negative ? -exponent : exponent;
    return c;
}

/* 0 when digits were left out, or the power has no exact double. */
static int quick_double(const number *n, double *value) {
    static const double TEN[QUICK_POWER + 1] = {
        1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
        1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
    };
    if (n->dropped || n->power < -QUICK_POWER || n->power > QUICK_POWER) {
        return 0;
    }
    const double whole = (double)n->leading;
    *value = n->power < 0 ? whole / TEN[-n->power] : whole * TEN[n->power];
    return 1;
}

/* All digits as one integer, and the power of ten: what strtod reads in any locale. */
typedef char slow_text[SLOW_DIGITS + 32];

static void write_slow(const number *n, slow_text text) {
    int count = 0, rest = 0;
    int64_t power = n->power;
    /* `power` belongs to `leading`: each digit past it that is written
     * here takes one away. */
    for (const unsigned char *c = n->digits; c < n->end; c++) {
        if (*c == '.') {
            continue;
        }
        if (count < SLOW_DIGITS) {
            power -= count >= QUICK_DIGITS;
            text[count++] = (char)*c;
        } else {
            rest |= *c != '0';
        }
    }
    if (rest) {
        text[count++] = '1';
        power--;
    }
    if (count == 0) {
        text[count++] = '0';
    }
    power = power > 100000 ? 100000 : power < -100000 ? -100000 : power;
    snprintf(text + count, sizeof(slow_text) - (size_t)count, "e%d", (int)power);
}

static double double_of(const number *n) {
    double value;
    if (!quick_double(n, &value)) {
        slow_text text;
        write_slow(n, text);
        value = strtod(text, NULL);
    }
    return value;
}

/* `nearest` is the double nearest to the number. */
static float float_of(const number *n, double nearest) {
    uint64_t bits;
    memcpy(&bits, &nearest, sizeof bits);
    const int is_middle = (bits & 0x1fffffff) == 0x10000000;
    if (!is_middle && (nearest == 0 ? n->leading == 0 : nearest >= 1e-37 && nearest <= 1e38)) {
        return (float)nearest;
    }
    slow_text text;
    write_slow(n, text);
    return strtof(text, NULL);
}

static int same_letters(const unsigned char *at, const unsigned char *end, const char *lower) {
    for (; *lower; at++, lower++) {
        if (at == end || (*at | 0x20) != (unsigned char)*lower) {
            return 0;
        }
    }
    return 1;
}

static int is_name(unsigned char c) {
    return is_digit(c) || ((c | 0x20) >= 'a' && (c | 0x20) <= 'z');
}

/* "nan", "nan(...)", "inf", "infinity" */
static const unsigned char *read_named(const unsigned char *at, const unsigned char *end,
                                       real *value) {
    const int is_nan = same_letters(at, end, "nan");
    if (!is_nan && !same_letters(at, end, "inf")) {
        return NULL;
    }
    *value = real_of_float(is_nan ? NAN : INFINITY);
    while (at < end && (is_name(*at) || *at == '(' || *at == ')')) {
        at++;
    }
    return at;
}

/* Without the sign. */
static const unsigned char *read_magnitude(const unsigned char *at, const unsigned char *end,
                                           real *value) {
    number n;
    const unsigned char *after = read_digits(at, end, &n);
    if (!after) {
        return read_named(at, end, value);
    }
    if (after < end && *after == '#') { /* 1.#QNAN, 1.#INF */
        for (after++; after < end && is_name(*after); after++) {
        }
        *value = real_of_float(NAN);
        return after;
    }
    after = read_exponent(after, end, &n);
    value->wide = double_of(&n);
    value->single = float_of(&n, value->wide);
    return after;
}

const unsigned char *decimal_real(const unsigned char *at, const unsigned char *end, real *value) {
    const int negative = at < end && *at == '-';
    at += at < end && (*at == '-' || *at == '+');
    const unsigned char *after = read_magnitude(at, end, value);
    if (after && negative) {
        *value = (real){-value->single, -value->wide};
    }
    return after;
}

const unsigned char *decimal_float(const unsigned char *at, const unsigned char *end,
                                   float *value) {
    real both;
    const unsigned char *after = decimal_real(at, end, &both);
    if (after) {
        *value = both.single;
    }
    return after;
}

const unsigned char *decimal_integer(const unsigned char *at, const unsigned char *end,
                                     int64_t *value) {
    const int negative = at < end && *at == '-';
    at += at < end && (*at == '-' || *at == '+');
    if (at == end || !is_digit(*at)) {
        return NULL;
    }
    int64_t magnitude = 0;
    for (; at < end && is_digit(*at); at++) {
        const int digit = *at - '0';
        magnitude = magnitude > (INT64_MAX - digit) / 10 ? INT64_MAX : magnitude * 10 + digit;
    }
    *value = negative ? -magnitude : magnitude;
    return at;
}
