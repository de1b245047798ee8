/* guard - none: Armv6-M has no register for a stack's limit, and these boards no MPU
 *
 * Where the stack lies at the very beginning of RAM (sections.ld puts it there), most devices fault
 * just below it, and the paint shows how far it went.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/bare/start.h"

void guard_off(void);

void guard_stack(void) {
}

__attribute__((naked)) void guard_off(void) {
    __asm__ volatile("bx lr");
}
