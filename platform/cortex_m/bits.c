/* bits - what GCC calls for 64-bit bit counting on a 32-bit CPU
 *
 * As with memory.c: no library, so that code and stack are known.
 *
 * SPDX-License-Identifier: MIT */
#include <stdint.h>

int __ctzdi2(uint64_t x);

/* Number of zero bits below the lowest one; x is not 0. */
int __ctzdi2(uint64_t x) {
    const uint32_t low = (uint32_t)x;
    return low ? __builtin_ctz(low) : 32 + __builtin_ctz((uint32_t)(x >> 32));
}
