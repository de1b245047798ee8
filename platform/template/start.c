/* start - the beginning of a port to a family of CPUs: copy this folder, then write what it says
 *
 * As it is, it compiles for any CPU and starts none. In the order in which a port meets them: reset
 * and machine_start here, guard.c, fault.c, semihost_call.c. What the board and platform/bare give
 * is in platform/bare/start.h; platform/cortex_m and platform/riscv are such folders, complete.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/bare/start.h"

void reset(void);

/* Where the CPU begins, at the beginning of FLASH (platform/bare/sections.ld); on one that has a
 * table of addresses there (Cortex-M), the table is in this section, and reset is in it.
 *
 * Write it in assembly, as a naked function, because no compiled code may run before it is done:
 *   1. the stack pointer is plt_stack_top, unless the CPU has set it;
 *   2. exceptions lead to fault_entry;
 *   3. an FPU is on, rounds to nearest and keeps subnormals, if the compiler has been told of one
 *      (__ARM_FP, __riscv_flen): it uses float registers to copy memory, too;
 *   4. vector registers are whole, where code can make them shorter (LTPSIZE of Armv8.1-M is 4);
 *   5. the words from plt_stack_bottom to plt_stack_top are PLT_STACK_PAINT;
 *   6. machine_start. It does not come back.
 * No interrupt is enabled. */
__attribute__((used, section(".vectors"))) void reset(void) {
    machine_start();
}

/* Memory, then the guard, then the board: the same in every family. */
_Noreturn void machine_start(void) {
    start_memory();
    guard_stack();
    machine_main();
}
