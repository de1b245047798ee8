/* serial - the second UART of Arm's MPS2, as board/wired/serial.h asks for
 *
 * The first UART is for a log. The device holds one byte. A byte comes every 160
 * cycles at this speed, and a step of rendering is longer; so an interrupt puts
 * each byte into a ring. It is the only interrupt, so its stack frame counts once
 * in the stack bound (INTERRUPTS_wired in board.mk). Sending is polled: nothing is
 * lost by being late.
 *
 * Source: Arm DDI 0479, Cortex-M System Design Kit, section 4.3 (APB UART);
 * Arm DAI 0386, memory map and interrupts; Armv7-M Architecture Reference
 * Manual, B3.4 (NVIC).
 *
 * SPDX-License-Identifier: MIT */
#include "board/wired/serial.h"

#include "board/ring.h"
#include "platform/cortex_m/fault.h"

typedef struct apb_uart {
    volatile uint32_t data, state, control, interrupts, baud_divider;
} apb_uart;

#define UART1 ((apb_uart *)0x40005000u)
#define NVIC_ENABLE_0 (*(volatile uint32_t *)0xE000E100u)

enum {
    SENDER_FULL = 1, /* of state */
    RECEIVER_FULL = 2,
    RECEIVER_OVERRUN = 8,
    SENDS = 1, /* of control */
    RECEIVES = 2,
    RECEIVER_INTERRUPTS = 8,
    RECEIVED = 2,       /* of interrupts */
    UART1_RECEIVER = 2, /* of the NVIC's lines */
    DIVIDER_LEAST = 16  /* 1.5625 Mbaud of the 25 MHz clock */
};

static ring received;

/* What came before `interrupts` is cleared is read here; what comes after calls
 * again. */
void serial_interrupt(void);
void serial_interrupt(void) {
    UART1->interrupts = RECEIVED;
    while (UART1->state & RECEIVER_FULL) {
        ring_put(&received, (uint8_t)UART1->data);
    }
    if (UART1->state & RECEIVER_OVERRUN) {
        UART1->state = RECEIVER_OVERRUN;
        ring_missed(&received);
    }
}

/* Behind the sixteen of platform/cortex_m/start.c: lines 0, 1 and 2. */
__attribute__((section(".vectors.board"), used)) static void (*const interrupts[])(void) = {
    fault_entry, fault_entry, serial_interrupt};

uint32_t board_serial_open(void) {
    UART1->baud_divider = DIVIDER_LEAST;
    UART1->control = SENDS | RECEIVES | RECEIVER_INTERRUPTS;
    NVIC_ENABLE_0 = 1u << UART1_RECEIVER;
    return sizeof received.bytes;
}

int board_serial_get(void) {
    return ring_get(&received);
}

int board_serial_put(uint8_t byte) {
    if (UART1->state & SENDER_FULL) {
        return 0;
    }
    UART1->data = byte;
    return 1;
}

uint32_t board_serial_lost(void) {
    return ring_lost(&received);
}
