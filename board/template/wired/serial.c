/* serial - the functions of board/wired/serial.h, for a board that gets its scenes over a UART
 *
 * Only PROGRAM=wired has them: leave the folder out of a board without. board.mk names the
 * handler that fills the ring (INTERRUPTS_wired := NAME, INTERRUPT_FRAME), and its address stands
 * in the section .vectors.board; board/mps2_an386/wired is such a board, complete.
 *
 * SPDX-License-Identifier: MIT */
#include "board/wired/serial.h"

#include "board/ring.h"

static ring incoming;

void board_serial_handler(void);

/* On the interrupt of a byte that came: clears the interrupt first, then ring_put for every byte
 * that is there, and ring_missed when the UART says that it lost one. */
void board_serial_handler(void) {
}

/* Pins, speed, interrupt. */
uint32_t board_serial_open(void) {
    return sizeof incoming.bytes;
}

int board_serial_get(void) {
    return ring_get(&incoming);
}

uint32_t board_serial_lost(void) {
    return ring_lost(&incoming);
}

/* 0 as long as the UART holds the byte before. */
int board_serial_put(uint8_t byte) {
    (void)byte;
    return 0;
}
