/* test_board_number - numbers of the firmware's command line against libc's
 *
 * strtof rounds correctly in glibc; every decimal that number_float takes must
 * give the same bits.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "board/number.h"
#include "tests/test.h"

static uint64_t random_state = 2463534242u;

static uint32_t random_word(void) {
    random_state = random_state * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(random_state >> 33);
}

static uint32_t bits_of(float x) {
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static void check_same(const char *text) {
    float got = 0;
    const float want = strtof(text, NULL);
    const int status = number_float(text, (unsigned)strlen(text), &got);
    CHECK(status == 0 && bits_of(got) == bits_of(want), "'%s': status %d, %08x, strtof %08x", text,
          status, bits_of(got), bits_of(want));
}

static void check_refused(const char *text) {
    float got;
    CHECK(number_float(text, (unsigned)strlen(text), &got) < 0, "'%s' was taken for %g", text,
          (double)got);
}

static void test_floats_come_back(void) {
    test("a float printed with nine digits comes back bit for bit");
    char text[40];
    for (int i = 0; i < 300000; i++) {
        const uint32_t exponent = 127 - 55 + random_word() % 110; /* 2^-55 .. 2^54 */
        const uint32_t bits =
            (random_word() & 0x807FFFFFu) | exponent << 23 | (random_word() & 1u) << 31;
        float x;
        memcpy(&x, &bits, sizeof x);
        snprintf(text, sizeof text, "%.9g", (double)x);
        check_same(text);
    }
}

static void test_any_digits(void) {
    test("up to 18 digits with a point and an exponent round as strtof rounds");
    char text[60], digits[20];
    for (int i = 0; i < 300000; i++) {
        const unsigned before = random_word() % 10, after = random_word() % 9;
        for (unsigned k = 0; k < before + after; k++) {
            digits[k] = (char)('0' + random_word() % 10);
        }
        digits[before + after] = '\0';
        snprintf(text, sizeof text, "%s%.*s0.%s0e%d", random_word() & 1 ? "-" : "", (int)before,
                 digits, digits + before, (int)(random_word() % 13) - 6);
        if (before + after <= 16) {
            check_same(text);
        }
    }
}

static void test_ties(void) {
    test("a number half way between two floats goes to the even one");
    check_same("16777217");
    check_same("16777219");
    check_same("8388608.5");
    check_same("8388609.5");
    check_same("4194304.25");
    check_same("4194304.75");
    check_same("33554431");
    check_same("4294967295");
    check_same("999999999999999999");
}

static void test_plain(void) {
    test("the numbers people write");
    static const char *const texts[] = {
        "0",   "-0",   "0.0",    "1",   "-1",   "+0",  "00012",      ".5",         "5.",   "-12.5",
        "1e3", "1E-3", "2.5e+2", "0e0", "1e17", "0.1", "3.14159274", "-0.0168404", "1e-18"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        if (texts[i][0] != '+') {
            check_same(texts[i]);
        }
    }
    test("the bits of a float, NaN and infinity among them, are taken as they are");
    static const char *const bits[] = {"0x0", "0x3f800000", "0XFF800000", "0x7fc00001",
                                       "0x80000000"};
    for (size_t i = 0; i < sizeof bits / sizeof *bits; i++) {
        float x = 1;
        CHECK(number_float(bits[i], (unsigned)strlen(bits[i]), &x) == 0, "%s", bits[i]);
        CHECK(bits_of(x) == (uint32_t)strtoul(bits[i], NULL, 16), "%s", bits[i]);
    }
}

static void test_refusals(void) {
    test("what is no number, or out of range, is refused");
    static const char *const texts[] = {"",
                                        "-",
                                        ".",
                                        "e5",
                                        "1e",
                                        "1e+",
                                        "1..2",
                                        "1,5",
                                        "0x",
                                        "0xg",
                                        "0x123456789",
                                        "nan",
                                        "inf",
                                        "--1",
                                        "1 ",
                                        " 1",
                                        "1e19",
                                        "1e-27",
                                        "1234567890123456789",
                                        "+1",
                                        "1e999",
                                        "-.e1",
                                        "1x",
                                        "1e-9999999999"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        check_refused(texts[i]);
    }
}

static void test_integers(void) {
    test("integers from 0 to 2^32 - 1 and nothing else");
    uint32_t value;
    CHECK(number_u32("0", 1, &value) == 0 && value == 0, "0");
    CHECK(number_u32("4294967295", 10, &value) == 0 && value == UINT32_MAX, "2^32 - 1");
    CHECK(number_u32("123xyz", 3, &value) == 0 && value == 123, "length ends the number");
    CHECK(number_u32("4294967296", 10, &value) < 0, "2^32");
    CHECK(number_u32("99999999999999999999", 20, &value) < 0, "many digits");
    CHECK(number_u32("", 0, &value) < 0, "empty");
    CHECK(number_u32("-1", 2, &value) < 0, "negative");
    CHECK(number_u32("12a", 3, &value) < 0, "letters");
}

int main(void) {
    test_floats_come_back();
    test_any_digits();
    test_ties();
    test_plain();
    test_refusals();
    test_integers();
    return test_done();
}
