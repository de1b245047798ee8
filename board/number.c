/* number - numbers of a command line, without libc and without rounding twice
 *
 * A decimal number is digits * 5^e * 2^e, a fraction of two integers below 2^62
 * and a power of two; a long division gives its first 25 bits and whether
 * a remainder is left; rounding to nearest even needs no more.
 *
 * SPDX-License-Identifier: MIT */
#include "board/number.h"

#include <string.h>

typedef struct decimal {
    uint64_t digits; /* below 10^18 */
    int count;       /* of digits, leading zeros not counted */
    int exponent;    /* value = digits * 10^exponent */
} decimal;

typedef struct cursor {
    const char *at, *end;
} cursor;

static int is_digit(const cursor *c) {
    return c->at < c->end && *c->at >= '0' && *c->at <= '9';
}

static int accept(cursor *c, char wanted) {
    if (c->at < c->end && *c->at == wanted) {
        c->at++;
        return 1;
    }
    return 0;
}

int number_u32(const char *text, unsigned length, uint32_t *value) {
    cursor c = {text, text + length};
    uint64_t sum = 0;
    for (; is_digit(&c) && sum <= UINT32_MAX; c.at++) {
        sum = sum * 10 + (uint64_t)(*c.at - '0');
    }
    if (length == 0 || c.at != c.end || sum > UINT32_MAX) {
        return -1;
    }
    *value = (uint32_t)sum;
    return 0;
}

static int hex_digit(char c) {
    if (c >= '0' && c <= '9') {
        return c - '0';
    }
    if (c >= 'a' && c <= 'f') {
        return c - 'a' + 10;
    }
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

static int parse_bits(cursor c, uint32_t *bits) {
    uint32_t sum = 0;
    if (c.at == c.end || c.end - c.at > 8) {
        return -1;
    }
    for (; c.at < c.end; c.at++) {
        const int digit = hex_digit(*c.at);
        if (digit < 0) {
            return -1;
        }
        sum = sum << 4 | (uint32_t)digit;
    }
    *bits = sum;
    return 0;
}

/* Digits up to the first other character; -1 when there are too many. */
static int parse_digits(cursor *c, decimal *d, int exponent_step) {
    for (; is_digit(c); c->at++) {
        d->count += d->count > 0 || *c->at != '0';
        d->exponent += exponent_step;
        if (d->count > 18 || d->exponent < -99) {
            return -1;
        }
        d->digits = d->digits * 10 + (uint64_t)(*c->at - '0');
    }
    return 0;
}

static int parse_exponent(cursor *c, decimal *d) {
    const int negative = accept(c, '-');
    int sum = 0;
    if (!negative) {
        accept(c, '+');
    }
    if (!is_digit(c)) {
        return -1;
    }
    for (; is_digit(c) && sum < 1000; c->at++) {
        sum = sum * 10 + (*c->at - '0');
    }
    d->exponent += negative ? -sum : sum;
    return 0;
}

/* "12.5e-3" without its sign, to the end of the text. */
static int parse_decimal(cursor *c, decimal *d) {
    const char *const first = c->at;
    if (parse_digits(c, d, 0) < 0) {
        return -1;
    }
    const int point = accept(c, '.');
    if (point && parse_digits(c, d, -1) < 0) {
        return -1;
    }
    if (c->at - first <= point) { /* no digit at all */
        return -1;
    }
    if ((accept(c, 'e') || accept(c, 'E')) && parse_exponent(c, d) < 0) {
        return -1;
    }
    return c->at == c->end ? 0 : -1;
}

/* Rounds a/b * 2^two to a float; a and b in 1 .. 2^61, the result in
 * 2^-100 .. 2^100. */
static uint32_t round_quotient(uint64_t a, uint64_t b, int two) {
    int exponent = 127 + two;
    for (; a < b; a <<= 1) {
        exponent--;
    }
    for (; a - b >= b; b <<= 1) {
        exponent++;
    }
    uint32_t bits = 0; /* 1 <= a/b < 2: 24 bits, the first of them 1, and one more */
    for (int i = 0; i < 25; i++) {
        const int one = a >= b;
        bits = bits << 1 | (uint32_t)one;
        a = (one ? a - b : a) << 1;
    }
    const int half = bits & 1, odd = bits >> 1 & 1;
    const uint32_t up = half && (a != 0 || odd);
    return ((uint32_t)exponent << 23) + (bits >> 1) - 0x800000u +
           up; /* a carry into the exponent is correct */
}

static int decimal_bits(decimal d, uint32_t *bits) {
    uint64_t above = d.digits, below = 1;
    if (d.digits == 0) {
        *bits = 0;
        return 0;
    }
    if (d.exponent < -26 || d.count + d.exponent > 18) { /* 5^26 < 2^61, 10^18 < 2^60 */
        return -1;
    }
    for (int i = 0; i < d.exponent; i++) {
        above *= 5;
    }
    for (int i = 0; i > d.exponent; i--) {
        below *= 5;
    }
    *bits = round_quotient(above, below, d.exponent);
    return 0;
}

int number_float(const char *text, unsigned length, float *value) {
    cursor c = {text, text + length};
    uint32_t bits, sign = 0;
    if (length > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X')) {
        c.at += 2;
        if (parse_bits(c, &bits) < 0) {
            return -1;
        }
    } else {
        decimal d = {0, 0, 0};
        sign = accept(&c, '-') ? 0x80000000u : 0;
        if (parse_decimal(&c, &d) < 0 || decimal_bits(d, &bits) < 0) {
            return -1;
        }
    }
    bits |= sign;
    memcpy(value, &bits, sizeof bits);
    return 0;
}
