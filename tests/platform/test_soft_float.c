/* test_soft_float - the square root of CPUs without an FPU against that of this one
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>

#define sqrtf soft_sqrtf
#include "platform/soft_float/sqrt.c"
#undef sqrtf

#include "tests/test.h"

static uint32_t bits_of(float x) {
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/* Of a NaN only that it is one. */
static int is_same(uint32_t bits) {
    const float x = of_bits(bits), soft = soft_sqrtf(x), hard = sqrtf(x);
    return bits_of(soft) == bits_of(hard) || (soft != soft && hard != hard);
}

/* Roots repeat with every second exponent: all mantissas of two, of two among the subnormals'. */
static uint32_t wrong_mantissas(uint32_t first) {
    uint32_t wrong = 0;
    for (uint32_t i = 0; i < UINT32_C(1) << 24; i++) {
        wrong += !is_same(first + i);
    }
    return wrong;
}

int main(void) {
    uint32_t wrong = 0;
    for (uint32_t i = 0; i < UINT32_C(1) << 20; i++) {
        wrong += !is_same(i * UINT32_C(4099)); /* a prime: all exponents, both signs */
    }
    test("roots of numbers of every size, and of what is none, are the FPU's");
    CHECK(wrong == 0, "%u are not", (unsigned)wrong);
    test("... of all mantissas");
    wrong = wrong_mantissas(0x3F800000u);
    CHECK(wrong == 0, "%u are not", (unsigned)wrong);
    test("... of all subnormals and the least normals");
    wrong = wrong_mantissas(0);
    CHECK(wrong == 0, "%u are not", (unsigned)wrong);
    test("... up to the greatest number and infinity");
    wrong = wrong_mantissas(0x7F800001u - (1u << 24));
    CHECK(wrong == 0, "%u are not", (unsigned)wrong);
    return test_done();
}
