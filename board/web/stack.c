/* stack - how much of the C stack was used, found by painting
 *
 * The linker puts the stack first (--stack-first), from address 0 up to WEB_STACK_BYTES, and it is
 * used from its end down.
 *
 * SPDX-License-Identifier: MIT */
#include "board/web/web.h"

enum { PAINT = 0xA5, MARGIN = 64, LEAST = 16 }; /* no pointer is to be NULL */

static volatile unsigned char *at(uint32_t address) {
    return (volatile unsigned char *)(uintptr_t)address;
}

void web_stack_paint(void) {
    const uint32_t now = (uint32_t)(uintptr_t)__builtin_frame_address(0);
    for (uint32_t address = LEAST; address + MARGIN < now; address++) {
        *at(address) = PAINT;
    }
}

uint32_t web_stack_used(void) {
    uint32_t address = LEAST;
    while (address < WEB_STACK_BYTES && *at(address) == PAINT) {
        address++;
    }
    return WEB_STACK_BYTES - address;
}

uint32_t web_stack_bytes(void) {
    return WEB_STACK_BYTES;
}
