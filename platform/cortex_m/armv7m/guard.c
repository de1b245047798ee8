/* guard - a region of the MPU that nothing may access, below the stack of an Armv7-M
 *
 * Source: Armv7-M Architecture Reference Manual, B3.5.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/bare/start.h"

extern uint32_t plt_stack_guard[];

#define REGISTER(address) (*(volatile uint32_t *)(address))
#define MPU_TYPE REGISTER(0xE000ED90u)
#define MPU_CTRL REGISTER(0xE000ED94u)
#define MPU_RNR REGISTER(0xE000ED98u)
#define MPU_RBAR REGISTER(0xE000ED9Cu)
#define MPU_RASR REGISTER(0xE000EDA0u)

enum {
    RASR_NO_ACCESS_256_BYTES = 7 << 1 | 1, /* AP = 0, size = 2^(7+1), enable */
    MPU_ON_FOR_ALL_BUT_HARD_FAULT = 5      /* default map elsewhere, ENABLE */
};

void guard_off(void);

void guard_stack(void) {
    if (MPU_TYPE == 0) {
        return; /* a core without MPU: the paint still shows it */
    }
    MPU_RNR = 0;
    MPU_RBAR = (uint32_t)(uintptr_t)plt_stack_guard;
    MPU_RASR = RASR_NO_ACCESS_256_BYTES;
    MPU_CTRL = MPU_ON_FOR_ALL_BUT_HARD_FAULT;
    __asm__ volatile("dsb\n isb" : : : "memory");
}

/* MPU_CTRL = 0. */
__attribute__((naked)) void guard_off(void) {
    __asm__ volatile(
        "ldr r1, =0xE000ED94\n"
        "movs r2, #0\n"
        "str r2, [r1]\n"
        "dsb\n"
        "isb\n"
        "bx lr\n"
        ".ltorg\n");
}
