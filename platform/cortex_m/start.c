/* start - start-up of a Cortex-M
 *
 * Invariants: an FPU is on before any compiled code runs (at -O3 a compiler
 * copies .data with float registers); no interrupt is enabled here, so that
 * the worst stack is that of the call graph, and below it that of the handler
 * which a board enables. The stack's guard is by architecture: armv6m, armv7m, armv8m.
 *
 * Source: Armv6-M, Armv7-M and Armv8-M Architecture Reference Manuals (exceptions, system
 * control); Armv8.1-M, FPSCR.LTPSIZE.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/bare/start.h"
#include "platform/cortex_m/fault.h"

extern uint32_t plt_stack_top[];

void reset(void);

/* System exceptions 1 .. 15; all but reset are faults here. A board puts the lines
 * that it enables into .vectors.board, which follows. */
__attribute__((section(".vectors"), used)) static void (*const vectors[16])(void) = {
    (void (*)(void))plt_stack_top,
    reset,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry};

/* CPACR bits 20 .. 23: full access to CP10 and CP11, the FPU and vectors. */
#if defined __ARM_FP || defined __ARM_FEATURE_MVE
#define FPU_ON                                                                                     \
    "ldr r0, =0xE000ED88\n"                                                                        \
    "ldr r1, [r0]\n"                                                                               \
    "orr r1, r1, #0x00F00000\n"                                                                    \
    "str r1, [r0]\n"                                                                               \
    "dsb\n"                                                                                        \
    "isb\n"
#else
#define FPU_ON ""
#endif

/* Whole vectors until a loop says otherwise: FPSCR bits 16 .. 18 are 4. */
#ifdef __ARM_FEATURE_MVE
#define VECTORS_WHOLE                                                                              \
    "ldr r1, =0x00040000\n"                                                                        \
    "vmsr fpscr, r1\n"
#else
#define VECTORS_WHOLE ""
#endif

#define TEXT_OF(number) #number
#define HEX(number) TEXT_OF(number)

/* clang-format off */
__attribute__((naked, used)) void reset(void) {
    __asm__ volatile(
        ".syntax unified\n" FPU_ON VECTORS_WHOLE
        "ldr r0, =plt_stack_bottom\n"
        "ldr r1, =plt_stack_top\n"
        "ldr r2, =" HEX(PLT_STACK_PAINT) "\n"
        "1: str r2, [r0]\n"
        "adds r0, #4\n"
        "cmp r0, r1\n"
        "bcc 1b\n"
        "ldr r0, =machine_start\n"
        "bx r0\n"
        ".ltorg\n");
}
/* clang-format on */

_Noreturn void machine_start(void) {
    start_memory();
    guard_stack();
    machine_main();
}
