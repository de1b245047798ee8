/* semihost_call - a RISC-V asks the debugger: EBREAK between two shifts that do nothing
 *
 * The three are told apart from a breakpoint by their neighbours, uncompressed and in one page.
 *
 * Source: RISC-V Semihosting, version 0.4.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/bare/semihost.h"

/* a0 and a1 are where arguments come and answers go. */
__attribute__((naked, noinline, aligned(16))) intptr_t semihost_call(intptr_t operation,
                                                                     const void *arguments) {
    (void)operation;
    (void)arguments;
    __asm__ volatile(
        ".option push\n"
        ".option norvc\n"
        ".option norelax\n"
        "slli x0, x0, 0x1f\n"
        "ebreak\n"
        "srai x0, x0, 7\n"
        "ret\n"
        ".option pop\n");
}
