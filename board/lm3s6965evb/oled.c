/* oled - the display of TI's LM3S6965 board: an SSD0323 on the first SSI, 128x64 in 16 greys
 *
 * A frame that is smaller lies in the middle, in columns of two pixels.
 * Lines: PA2 clock, PA3 select, PA5 data, PC6 the glass's 15 V, PC7 pixels or commands; PD0 selects
 * a memory card on the same clock, which is left alone.
 *
 * Source: Luminary Micro, LM3S6965 data sheet (system control, GPIO, SSI); Stellaris LM3S6965
 * Evaluation Board User's Manual (OLED display).
 *
 * SPDX-License-Identifier: MIT */
#include "board/panel.h"
#include "platform/ssd0323/ssd0323.h"

#define REGISTER(address) (*(volatile uint32_t *)(address))
#define CLOCKS_OF_SSI REGISTER(0x400FE104u)
#define CLOCKS_OF_GPIO REGISTER(0x400FE108u)
#define SSI_CONTROL_0 REGISTER(0x40008000u)
#define SSI_CONTROL_1 REGISTER(0x40008004u)
#define SSI_DATA REGISTER(0x40008008u)
#define SSI_STATUS REGISTER(0x4000800Cu)
#define SSI_PRESCALE REGISTER(0x40008010u)

/* A port of the GPIO. A store to its data register changes the lines that its address names. */
enum { PORT_A = 0x40004000, PORT_C = 0x40006000, PORT_D = 0x40007000 };
enum { DIRECTION = 0x400, ALTERNATE = 0x420, DIGITAL = 0x51C };
enum { SSI_CLOCK = 1 << 2, SSI_SELECT = 1 << 3, SSI_OUT = 1 << 5 };
enum { GLASS_POWER = 1 << 6, IS_PIXELS = 1 << 7, CARD_SELECT = 1 << 0 };

enum {
    SSI_0 = 1 << 4,
    GPIO_A_C_D = 1 << 0 | 1 << 2 | 1 << 3,
    EIGHT_BITS_ON_RISING_EDGES = 1 << 7 | 1 << 6 | 7, /* SPH, SPO; the clock rests high */
    SSI_ON = 1 << 1,
    SSI_DIVISOR = 14, /* of 12.5 MHz */
    HAS_ROOM = 1 << 1,
    IS_BUSY = 1 << 4
};

static uint16_t frame_left, frame_top;
static uint8_t is_open;

static void set_lines(uint32_t port, uint32_t lines, uint32_t level) {
    REGISTER(port + (lines << 2)) = level ? lines : 0;
}

static void make_outputs(uint32_t port, uint32_t lines) {
    REGISTER(port + DIRECTION) |= lines;
    REGISTER(port + DIGITAL) |= lines;
}

void board_panel_put(int is_pixels, uint8_t byte) {
    set_lines(PORT_C, IS_PIXELS, (uint32_t)is_pixels);
    while (!(SSI_STATUS & HAS_ROOM)) {
    }
    SSI_DATA = byte;
    while (SSI_STATUS & IS_BUSY) {
    }
    (void)SSI_DATA; /* what came in meanwhile */
}

static void open_lines(void) {
    CLOCKS_OF_SSI |= SSI_0;
    CLOCKS_OF_GPIO |= GPIO_A_C_D;
    make_outputs(PORT_A, SSI_CLOCK | SSI_SELECT | SSI_OUT);
    REGISTER(PORT_A + ALTERNATE) |= SSI_CLOCK | SSI_OUT;
    make_outputs(PORT_C, GLASS_POWER | IS_PIXELS);
    make_outputs(PORT_D, CARD_SELECT);
    set_lines(PORT_D, CARD_SELECT, 1);
    set_lines(PORT_C, GLASS_POWER, 1);
    set_lines(PORT_A, SSI_SELECT, 0);
    SSI_CONTROL_1 = 0;
    SSI_CONTROL_0 = EIGHT_BITS_ON_RISING_EDGES;
    SSI_PRESCALE = SSI_DIVISOR;
    SSI_CONTROL_1 = SSI_ON;
}

void board_panel_size(uint16_t *width, uint16_t *height) {
    *width = SSD0323_WIDTH;
    *height = SSD0323_HEIGHT;
}

void board_panel_begin(uint16_t width, uint16_t height) {
    const uint16_t left = (uint16_t)((SSD0323_WIDTH - width) / 2 & ~1);
    const uint16_t top = (uint16_t)((SSD0323_HEIGHT - height) / 2);
    if (!is_open) {
        open_lines();
        ssd0323_open();
        is_open = 1;
    } else if (left != frame_left || top != frame_top) {
        ssd0323_clear(); /* else the frame before is written over */
    }
    frame_left = left;
    frame_top = top;
}

void board_panel_tile(const plt_tile *tile) {
    ssd0323_tile(tile, frame_left, frame_top);
}
