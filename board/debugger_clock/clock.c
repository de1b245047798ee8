/* clock - a board without a free counter of 32 bits asks its debugger for the time
 *
 * SPDX-License-Identifier: MIT */
#include "board/board.h"
#include "platform/bare/semihost.h"

enum { CENTISECONDS = 100 };

uint32_t board_ticks(void) {
    return semihost_centiseconds();
}

uint32_t board_ticks_per_second(void) {
    return CENTISECONDS;
}
