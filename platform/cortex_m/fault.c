/* fault - the last words of a Cortex-M
 *
 * Invariant: works with a stack that has run out: the handler uses the whole
 * stack anew, with the guard switched off.
 *
 * Source: Armv7-M Architecture Reference Manual, B3.2.15 to B3.2.18.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/cortex_m/fault.h"

#include <stdint.h>

#include "platform/cortex_m/start.h"

extern uint32_t plt_stack_guard[], plt_stack_top[];

#define REGISTER(address) (*(volatile uint32_t *)(address))

__attribute__((used)) _Noreturn void fault_report(const uint32_t *stacked);

/* MPU off, r0 = where the CPU left the registers, stack from its top. */
__attribute__((naked)) void fault_entry(void) {
    __asm__ volatile(
        "mov r0, sp\n"
        "ldr r1, =0xE000ED94\n"
        "movs r2, #0\n"
        "str r2, [r1]\n"
        "dsb\n"
        "isb\n"
        "ldr r1, =plt_stack_top\n"
        "mov sp, r1\n"
        "b fault_report\n"
        ".ltorg\n");
}

static void print_hex(const char *name, uint32_t value) {
    char text[10];
    for (unsigned i = 0; i < 8; i++) {
        text[i] = "0123456789abcdef"[value >> (28 - 4 * i) & 15u];
    }
    text[8] = '\0';
    cortex_m_print(name);
    cortex_m_print(text);
}

_Noreturn void fault_report(const uint32_t *stacked) {
    /* Eight words: r0 r1 r2 r3 r12 lr pc xpsr; read before this frame grows over them. */
    const int readable = stacked >= plt_stack_guard && stacked + 8 <= plt_stack_top;
    const uint32_t lr = readable ? stacked[5] : 0, pc = readable ? stacked[6] : 0;
    print_hex("FAULT exception=", REGISTER(0xE000ED04u) & 0x1FFu);
    print_hex(" cfsr=", REGISTER(0xE000ED28u));
    print_hex(" hfsr=", REGISTER(0xE000ED2Cu));
    print_hex(" mmfar=", REGISTER(0xE000ED34u));
    print_hex(" bfar=", REGISTER(0xE000ED38u));
    print_hex(" pc=", pc);
    print_hex(" lr=", lr);
    cortex_m_print("\n");
    cortex_m_exit(CORTEX_M_FAULT_STATUS);
}
