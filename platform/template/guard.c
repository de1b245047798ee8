/* guard - of a port: what stores below the stack becomes a fault
 *
 * SPDX-License-Identifier: MIT */
#include "platform/bare/start.h"

/* From here on no store may reach the 256 bytes from plt_stack_guard to plt_stack_bottom, by an MPU
 * (platform/cortex_m/armv7m), by a limit of the stack pointer (armv8m) or a PMP (platform/riscv).
 * A CPU without any of them leaves this empty (armv6m), and its boards say GUARD := none.
 * test_guards.sh of tests/qemu stores there on every board. */
void guard_stack(void) {
}
