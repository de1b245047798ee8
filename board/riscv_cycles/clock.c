/* clock - a board's clock is the cycle counter of its RISC-V
 *
 * PLT_CLOCK_HERTZ, of board.mk, is how often it counts per second.
 *
 * SPDX-License-Identifier: MIT */
#include "board/board.h"

#ifndef PLT_CLOCK_HERTZ
#error "board.mk lacks -DPLT_CLOCK_HERTZ=1000000000u in BOARD_FLAGS, or what the CPU's clock has"
#endif

uint32_t board_ticks(void) {
    uintptr_t cycles;
    __asm__ volatile(
        ".option push\n"
        ".option arch, +zicsr\n"
        "csrr %0, mcycle\n"
        ".option pop\n"
        : "=r"(cycles));
    return (uint32_t)cycles;
}

uint32_t board_ticks_per_second(void) {
    return PLT_CLOCK_HERTZ;
}
