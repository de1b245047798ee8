/* test_mesh_decimal - decimal text to float and double, compared with strtof and strtod
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "host_tools/mesh/decimal.h"
#include "tests/test.h"

static uint64_t state = 88172645463325252u;

static uint64_t random64(void) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
}

static uint32_t bits_of(float x) {
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static float float_of(uint32_t bits) {
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static float parse(const char *text) {
    const unsigned char *at = (const unsigned char *)text, *end = at + strlen(text);
    float value = NAN;
    CHECK(decimal_float(at, end, &value) == end, "'%s' is not read to its end", text);
    return value;
}

static void same_as_strtof(const char *text) {
    const float value = parse(text), expected = strtof(text, NULL);
    CHECK(bits_of(value) == bits_of(expected), "'%s' is %.9g, not %.9g", text, (double)value,
          (double)expected);
    real both;
    const unsigned char *at = (const unsigned char *)text, *end = at + strlen(text);
    CHECK(decimal_real(at, end, &both) == end, "'%s' is not read to its end", text);
    const double wide = strtod(text, NULL);
    CHECK(memcmp(&both.wide, &wide, sizeof wide) == 0, "'%s' is %.17g, not %.17g", text, both.wide,
          wide);
    CHECK(bits_of(both.single) == bits_of(expected), "'%s' is %.9g as one of two", text,
          (double)both.single);
}

static void any_float(void) {
    test("Any float printed with 6 to 20 digits reads as the nearest float and double");
    int finite = 0;
    for (int i = 0; i < 200000; i++) {
        const float x = float_of((uint32_t)random64());
        if (isfinite(x)) {
            finite++;
            char text[64];
            snprintf(text, sizeof text, i % 2 ? "%.*e" : "%.*g", 6 + i % 15, (double)x);
            same_as_strtof(text);
        }
    }
    CHECK(finite > 190000, "only %d are finite", finite);
}

static void usual_floats(void) {
    test("Coordinates with 1 to 25 decimals read as the nearest float and double");
    for (int i = 0; i < 200000; i++) {
        char text[64];
        const double x = (double)(int64_t)random64() * 1.0842021724855044e-16;
        snprintf(text, sizeof text, "%.*f", 1 + i % 25, x);
        same_as_strtof(text);
    }
}

static void middles(void) {
    test("The middle between two floats goes to the even one, its neighbours to theirs");
    int tried = 0;
    for (int i = 0; i < 20000; i++) {
        const uint32_t bits = (uint32_t)random64() & 0x7fffffff;
        const float low = float_of(bits), high = float_of(bits + 1);
        if (!isfinite(high)) {
            continue;
        }
        tried++;
        char text[400];
        const double middle = ((double)low + (double)high) / 2;
        const int length = snprintf(text, sizeof text, "%.160f", middle);
        CHECK(length < 300, "%d", length);
        CHECK(bits_of(parse(text)) == bits + (bits & 1), "middle %s", text);
        strcpy(text + length, "000000000000000000000000000000000000001");
        CHECK(bits_of(parse(text)) == bits + 1, "above %s", text);
        snprintf(text, sizeof text, "%.17g", nextafter(middle, 0));
        CHECK(bits_of(parse(text)) == bits, "below %s", text);
    }
    CHECK(tried > 19000, "only %d were tried", tried);
}

static void ends(void) {
    test("Zeros, limits, subnormals and absurd exponents read as strtof reads them");
    static const char *const TEXTS[] = {
        "0",
        "-0",
        "0.0",
        "-.0",
        "00012",
        "1.",
        ".5",
        "+7",
        "3.4028234663852886e38",
        "3.4028235677973366e38",
        "3.40282356e38",
        "1e39",
        "-1e39",
        "1e-45",
        "7e-46",
        "7.1e-46",
        "1.17549435e-38",
        "1.4e-45",
        "1e999999999999999999999",
        "-1e-999999999999999999999",
        "0e999999999999999999999",
        "16777217",
        "16777219",
        "16777216.99999999999999999999999999",
        "9007199791611905",
        "123456789012345678901234567890",
        "0.000000000000000000000000000000000000000000000000000000001e57",
        "1000000000000000000000000000000000000000000000000000000000e-57",
    };
    for (size_t i = 0; i < sizeof TEXTS / sizeof TEXTS[0]; i++) {
        same_as_strtof(TEXTS[i]);
    }
}

static void long_numbers(void) {
    test("A million digits are read, before or after the point");
    enum { DIGITS = 1000000 };
    char *text = malloc(DIGITS + 40);
    memset(text, '0', DIGITS);
    strcpy(text + DIGITS, "25");
    CHECK(parse(text) == 25, "leading zeros");
    text[1] = '.';
    strcpy(text + DIGITS, "25e1000000");
    CHECK(parse(text) == 25, "small with a large exponent");
    memset(text, '9', DIGITS);
    strcpy(text + DIGITS, "e-1000000");
    CHECK(parse(text) == 1, "large with a small exponent");
    free(text);
}

static void names(void) {
    test("The names of NaN and infinity are numbers");
    static const char *const NANS[] = {"nan", "-nan", "NaN", "nan(ind)", "1.#QNAN", "-1.#IND00"};
    for (size_t i = 0; i < sizeof NANS / sizeof NANS[0]; i++) {
        CHECK(isnan(parse(NANS[i])), "%s", NANS[i]);
    }
    CHECK(parse("inf") == INFINITY && parse("-Infinity") == -INFINITY, "infinity");
}

static void no_numbers(void) {
    test("What is no number is refused, what follows one is left");
    static const char *const NONE[] = {"", "-", "+", ".", "-.", "e5", "x", "--1", "na", "\xff"};
    float value;
    int64_t whole;
    for (size_t i = 0; i < sizeof NONE / sizeof NONE[0]; i++) {
        const unsigned char *at = (const unsigned char *)NONE[i];
        CHECK(!decimal_float(at, at + strlen(NONE[i]), &value), "'%s'", NONE[i]);
        CHECK(!decimal_integer(at, at + strlen(NONE[i]), &whole), "'%s'", NONE[i]);
    }
    static const char *const LEFT[] = {"1e", "1e+", "1x", "1,5", "1-", "1 "};
    for (size_t i = 0; i < sizeof LEFT / sizeof LEFT[0]; i++) {
        const unsigned char *at = (const unsigned char *)LEFT[i];
        CHECK(decimal_float(at, at + strlen(LEFT[i]), &value) == at + 1, "'%s'", LEFT[i]);
        CHECK(value == 1, "'%s' is %g", LEFT[i], (double)value);
    }
    const unsigned char *cut = (const unsigned char *)"12345";
    CHECK(decimal_float(cut, cut + 2, &value) == cut + 2 && value == 12, "read past the end");
    CHECK(decimal_integer(cut, cut + 2, &whole) == cut + 2 && whole == 12, "read past the end");
}

static void integers(void) {
    test("Whole numbers are exact and stop at the ends of int64_t");
    static const struct {
        const char *text;
        int64_t value;
    } NUMBERS[] = {
        {"0", 0},
        {"-1", -1},
        {"+4294967296", 4294967296},
        {"9223372036854775807", INT64_MAX},
        {"9223372036854775808", INT64_MAX},
        {"99999999999999999999999", INT64_MAX},
        {"-99999999999999999999999", -INT64_MAX},
    };
    for (size_t i = 0; i < sizeof NUMBERS / sizeof NUMBERS[0]; i++) {
        const unsigned char *at = (const unsigned char *)NUMBERS[i].text;
        int64_t value = 0;
        CHECK(decimal_integer(at, at + strlen(NUMBERS[i].text), &value) != NULL, "none");
        CHECK(value == NUMBERS[i].value, "%s is %lld", NUMBERS[i].text, (long long)value);
    }
}

int main(void) {
    any_float();
    usual_floats();
    middles();
    ends();
    long_numbers();
    names();
    no_numbers();
    integers();
    return test_done();
}
