/* semihost_call - of a port: stops the CPU for its debugger or emulator, and returns the answer
 *
 * Only boards that take board/semihosted call it. The instruction is the family's: BKPT 0xAB of a
 * Cortex-M, EBREAK between two shifts of a RISC-V. Without it board/template/board.c is the
 * beginning, which needs no debugger.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/bare/semihost.h"

intptr_t semihost_call(intptr_t operation, const void *arguments) {
    (void)operation;
    (void)arguments;
    return -1;
}
