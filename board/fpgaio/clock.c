/* clock - the counter in the FPGAIO block of Arm's MPS2 and MPS3 boards
 *
 * 32 bits; counts the board's clock when its prescaler is 0, as after reset. PLT_FPGAIO is its
 * address and PLT_CLOCK_HERTZ the clock, both of board.mk.
 *
 * Source: Arm DAI 0386, Arm DAI 0547, "FPGA system control and I/O".
 *
 * SPDX-License-Identifier: MIT */
#include "board/board.h"

#ifndef PLT_FPGAIO
#error "board.mk lacks -DPLT_FPGAIO=ADDRESS in BOARD_FLAGS: where the block is"
#endif
#ifndef PLT_CLOCK_HERTZ
#error "board.mk lacks -DPLT_CLOCK_HERTZ=25000000u in BOARD_FLAGS, or what the board's clock has"
#endif

#define COUNTER (*(volatile uint32_t *)(PLT_FPGAIO + 0x18u))

uint32_t board_ticks(void) {
    return COUNTER;
}

uint32_t board_ticks_per_second(void) {
    return PLT_CLOCK_HERTZ;
}
