/* semihost_call - a Cortex-M asks the debugger: BKPT 0xAB, operation in r0, arguments in r1
 *
 * SPDX-License-Identifier: MIT */
#include "platform/bare/semihost.h"

intptr_t semihost_call(intptr_t operation, const void *arguments) {
    register intptr_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = arguments;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}
