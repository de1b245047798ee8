/* fault - the last words of a RISC-V in machine mode
 *
 * Invariant: works with a stack that has run out: the handler uses the whole stack anew, and stores
 * nothing below it. mepc says where it was, whatever became of the stack.
 *
 * Source: The RISC-V Instruction Set Manual, volume II (privileged), 3.1.14 to 3.1.16.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/bare/start.h"

void trap_entry(void);
__attribute__((used)) _Noreturn void fault_report(uintptr_t cause, uintptr_t pc, uintptr_t value);

/* The low two bits of mtvec are its mode: the address is a multiple of 4. */
__attribute__((naked, used, aligned(4))) void trap_entry(void) {
    __asm__ volatile(
        ".option push\n"
        ".option arch, +zicsr\n"
        "csrr a0, mcause\n"
        "csrr a1, mepc\n"
        "csrr a2, mtval\n"
        ".option pop\n"
        "la sp, plt_stack_top\n"
        "tail fault_report\n");
}

_Noreturn void fault_report(uintptr_t cause, uintptr_t pc, uintptr_t value) {
    fault_item("FAULT cause=", cause);
    fault_item(" pc=", pc);
    fault_item(" value=", value);
    machine_print("\n");
    machine_exit(MACHINE_FAULT_STATUS);
}
