/* serial - the line of bytes over which a wired board is fed, given by the board
 *
 * What board/wired/firmware.c needs beside board.h, from boards with a free UART.
 * Nothing here waits, and none of it is called from an interrupt.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_SERIAL_H
#define PLT_BOARD_SERIAL_H

#include <stdint.h>

/* Called once, before the others. Returns how many bytes are kept until they are
 * read. The firmware lets the host send only as much data at once as fits beside
 * four control reports, which need no credit (two reports, if fewer than six fit). */
uint32_t board_serial_open(void);

/* The next byte that came, or -1: none yet. Between two calls the firmware may
 * render a step, some milliseconds. */
int board_serial_get(void);

/* 1: the byte goes out; 0: not now, the one before is not out yet. */
int board_serial_put(uint8_t byte);

/* Bytes lost since the start: at least so many, as a UART that was overrun does not
 * say how often. Each costs its report; the wire sends its content again. */
uint32_t board_serial_lost(void);

#endif
