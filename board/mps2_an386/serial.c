/* serial - the second UART of Arm's MPS2, as board/wired/serial.h asks for
 *
 * The first is left to a log. Polled, without an interrupt: QEMU hands over the
 * next byte when the last one was read, so none is lost. The device itself
 * keeps one byte; a host that does not wait needs a ring filled by UARTRX1.
 *
 * Source: Arm DDI 0479, Cortex-M System Design Kit, section 4.3 (APB UART);
 * Arm DAI 0386, memory map.
 *
 * SPDX-License-Identifier: MIT */
#include "board/wired/serial.h"

typedef struct apb_uart {
    volatile uint32_t data, state, control, interrupts, baud_divider;
} apb_uart;

#define UART1 ((apb_uart *)0x40005000u)

enum {
    SENDER_FULL = 1, /* of state */
    RECEIVER_FULL = 2,
    SENDS = 1, /* of control */
    RECEIVES = 2,
    DIVIDER_LEAST = 16 /* 1.5625 Mbaud of the 25 MHz clock */
};

void board_serial_open(void) {
    UART1->baud_divider = DIVIDER_LEAST;
    UART1->control = SENDS | RECEIVES;
}

int board_serial_get(void) {
    return UART1->state & RECEIVER_FULL ? (int)(UART1->data & 0xFFu) : -1;
}

int board_serial_put(uint8_t byte) {
    if (UART1->state & SENDER_FULL) {
        return 0;
    }
    UART1->data = byte;
    return 1;
}
