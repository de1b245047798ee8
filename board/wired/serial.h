/* serial - the line of bytes over which a wired board is fed, given by the board
 *
 * What board/wired/firmware.c asks beside board.h, of boards that have a UART
 * to spare. Nothing here waits, and nothing is called from an interrupt.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_SERIAL_H
#define PLT_BOARD_SERIAL_H

#include <stdint.h>

/* Called once, before the other two. */
void board_serial_open(void);

/* The next byte that came, or -1: none yet. A line without flow control must
 * keep what comes while the firmware renders a step, some milliseconds; a byte
 * that is lost costs its report, which the wire has sent again. */
int board_serial_get(void);

/* 1: the byte goes out; 0: not now, the one before is not out yet. */
int board_serial_put(uint8_t byte);

#endif
