/* guard - the limit of the stack pointer of an Armv8-M, and a region of its MPU below
 *
 * The limit (MSPLIM) faults before a frame is stored that reaches below the stack. Stores by
 * other pointers meet the region: read-only, as regions of Armv8-M cannot forbid privileged code
 * to read. Its registers are not those of Armv7-M, although they lie at the same addresses.
 *
 * Source: Armv8-M Architecture Reference Manual, B3.23 (stack limit), B11 and D1.2 (PMSAv8).
 *
 * SPDX-License-Identifier: MIT */
#include "platform/bare/start.h"

extern uint32_t plt_stack_guard[], plt_stack_bottom[];

#define REGISTER(address) (*(volatile uint32_t *)(address))
#define MPU_TYPE REGISTER(0xE000ED90u)
#define MPU_CTRL REGISTER(0xE000ED94u)
#define MPU_RNR REGISTER(0xE000ED98u)
#define MPU_RBAR REGISTER(0xE000ED9Cu)
#define MPU_RLAR REGISTER(0xE000EDA0u)

enum {
    READ_ONLY_PRIVILEGED_NEVER_RUN = 2 << 1 | 1, /* AP[2:1], XN */
    REGION_ON = 1,                               /* attributes 0: device memory */
    GRANULE = 32,                                /* limits are the last granule's address */
    MPU_ON_FOR_ALL_BUT_HARD_FAULT = 5            /* default map elsewhere, ENABLE */
};

void guard_off(void);

void guard_stack(void) {
    __asm__ volatile("msr msplim, %0" : : "r"(plt_stack_bottom));
    if (MPU_TYPE == 0) {
        return; /* a core without MPU: the limit still holds */
    }
    MPU_RNR = 0;
    MPU_RBAR = (uint32_t)(uintptr_t)plt_stack_guard | READ_ONLY_PRIVILEGED_NEVER_RUN;
    MPU_RLAR = ((uint32_t)(uintptr_t)plt_stack_bottom - GRANULE) | REGION_ON;
    MPU_CTRL = MPU_ON_FOR_ALL_BUT_HARD_FAULT;
    __asm__ volatile("dsb\n isb" : : : "memory");
}

/* MPU_CTRL = 0, no limit. */
__attribute__((naked)) void guard_off(void) {
    __asm__ volatile(
        "ldr r1, =0xE000ED94\n"
        "movs r2, #0\n"
        "str r2, [r1]\n"
        "msr msplim, r2\n"
        "dsb\n"
        "isb\n"
        "bx lr\n"
        ".ltorg\n");
}
