/* guard - an entry of the PMP that nothing may access, below the stack of a RISC-V
 *
 * Locked, because machine mode obeys no other. What no entry names stays as it is.
 *
 * Source: The RISC-V Instruction Set Manual, volume II (privileged), 3.7.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/bare/start.h"

extern uint32_t plt_stack_guard[];

enum {
    LOCKED_POWER_OF_TWO = 0x80 | 3 << 3, /* no reading, writing or running */
    HALF_OF_256_BYTES = 256 / 2 - 1      /* ones below the address say how long it is */
};

void guard_stack(void) {
    const uintptr_t address = ((uintptr_t)plt_stack_guard | HALF_OF_256_BYTES) >> 2;
    __asm__ volatile(
        ".option push\n"
        ".option arch, +zicsr\n"
        "csrw pmpaddr0, %0\n"
        "csrw pmpcfg0, %1\n"
        ".option pop\n"
        :
        : "r"(address), "r"((uintptr_t)LOCKED_POWER_OF_TWO)
        : "memory");
}
