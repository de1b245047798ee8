/* fault - the last words of a Cortex-M
 *
 * Invariant: works with a stack that has run out: the handler uses the whole
 * stack anew, with the guard switched off (guard_off, by architecture, changes no
 * register but r1 to r3, and uses no stack).
 *
 * Source: Armv7-M Architecture Reference Manual, B3.2.15 to B3.2.18.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/cortex_m/fault.h"

#include <stdint.h>

#include "platform/bare/start.h"

extern uint32_t plt_stack_bottom[], plt_stack_top[];

#define REGISTER(address) (*(volatile uint32_t *)(address))

__attribute__((used)) _Noreturn void fault_report(const uint32_t *stacked);

/* Guard off, r0 = where the CPU left the registers, stack from its top. */
__attribute__((naked)) void fault_entry(void) {
    __asm__ volatile(
        "mov r0, sp\n"
        "bl guard_off\n"
        "ldr r1, =plt_stack_top\n"
        "mov sp, r1\n"
        "ldr r1, =fault_report\n"
        "bx r1\n"
        ".ltorg\n");
}

/* CFSR: what the CPU could not stack, because the MPU, the bus or the limit forbade it. */
enum { MSTKERR = 1 << 4, STKERR = 1 << 12, STKOF = 1 << 20 };

/* Armv6-M has no registers that say why. */
#if __ARM_ARCH_ISA_THUMB > 1
static uint32_t fault_status(void) {
    return REGISTER(0xE000ED28u);
}

static void print_reasons(void) {
    fault_item(" cfsr=", fault_status());
    fault_item(" hfsr=", REGISTER(0xE000ED2Cu));
    fault_item(" mmfar=", REGISTER(0xE000ED34u));
    fault_item(" bfar=", REGISTER(0xE000ED38u));
}
#else
static uint32_t fault_status(void) {
    return 0;
}

static void print_reasons(void) {
}
#endif

/* The registers are eight words, r0 r1 r2 r3 r12 lr pc xpsr, read before this frame grows over
 * them; where the stack has run out they are not there. */
static int is_readable(const uint32_t *stacked) {
    return !(fault_status() & (MSTKERR | STKERR | STKOF)) && stacked >= plt_stack_bottom &&
           stacked + 8 <= plt_stack_top;
}

_Noreturn void fault_report(const uint32_t *stacked) {
    const int readable = is_readable(stacked);
    const uint32_t lr = readable ? stacked[5] : 0, pc = readable ? stacked[6] : 0;
    const uintptr_t near = readable ? 0 : fault_near();
    fault_item("FAULT exception=", REGISTER(0xE000ED04u) & 0x1FFu);
    print_reasons();
    fault_item(" pc=", pc);
    fault_item(" lr=", lr);
    fault_item(" near=", near);
    machine_print("\n");
    machine_exit(MACHINE_FAULT_STATUS);
}
