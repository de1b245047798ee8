/* start - start-up of a RISC-V in machine mode
 *
 * Invariants: traps have a handler and the FPU is on before any compiled code runs; no interrupt
 * is enabled here, so that the worst stack is that of the call graph; of several harts that start
 * together the first goes on, or that of PLT_HART, and the others sleep.
 *
 * Source: The RISC-V Instruction Set Manual, volume II (privileged), 3.1.5 to 3.1.7.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/bare/start.h"

void reset(void);

/* mstatus bits 13 and 14: the state of the FPU, "initial". */
#ifdef __riscv_flen
#define FPU_ON                                                                                     \
    "li t0, 0x2000\n"                                                                              \
    "csrs mstatus, t0\n"                                                                           \
    "csrw fcsr, zero\n"
#else
#define FPU_ON ""
#endif
#define TEXT_OF(number) #number
#define HEX(number) TEXT_OF(number)

/* Of a chip whose first hart has no FPU (SiFive's FU540, an E51 before four U54):
 * BOARD_FLAGS := -DPLT_HART=1. */
#ifdef PLT_HART
#define COUNT_FROM_HART "addi t0, t0, -" HEX(PLT_HART) "\n"
#else
#define COUNT_FROM_HART ""
#endif

/* clang-format off */
/* The first instruction of the image. */
__attribute__((naked, used, section(".vectors"))) void reset(void) {
    __asm__ volatile(
        ".option push\n"
        ".option arch, +zicsr\n"
        "csrr t0, mhartid\n" COUNT_FROM_HART
        "2: beqz t0, 3f\n"
        "wfi\n"
        "j 2b\n"
        "3: la t0, trap_entry\n"
        "csrw mtvec, t0\n" FPU_ON
        ".option pop\n"
        "la sp, plt_stack_top\n"
        "la t0, plt_stack_bottom\n"
        "li t1, " HEX(PLT_STACK_PAINT) "\n"
        "1: sw t1, 0(t0)\n"
        "addi t0, t0, 4\n"
        "bltu t0, sp, 1b\n"
        "tail machine_start\n");
}
/* clang-format on */

_Noreturn void machine_start(void) {
    start_memory();
    guard_stack();
    machine_main();
}
