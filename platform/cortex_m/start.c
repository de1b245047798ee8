/* start - start-up of a Cortex-M with hardware floats, and its stack
 *
 * Invariants: the FPU is on before any compiled code runs (at -O3 a compiler
 * copies .data with float registers); no interrupt is enabled here, so that
 * the worst stack is that of the call graph, and below it that of the handler
 * which a board enables; a stack that grows beyond its bottom meets a region
 * without access, and faults.
 *
 * Source: Armv7-M Architecture Reference Manual, B1.5 (exceptions), B3.2
 * (system control), B3.5 (MPU).
 *
 * SPDX-License-Identifier: MIT */
#include "platform/cortex_m/start.h"

#include "platform/cortex_m/fault.h"

extern uint32_t plt_data_start[], plt_data_end[], plt_data_image[];
extern uint32_t plt_bss_start[], plt_bss_end[];
extern uint32_t plt_stack_guard[], plt_stack_bottom[], plt_stack_top[];

#define PAINT 0xA5C35A3Cu
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

void reset(void);
_Noreturn void cortex_m_start(void);

/* System exceptions 1 .. 15; all but reset are faults here. A board puts the lines
 * that it enables into .vectors.board, which follows. */
__attribute__((section(".vectors"), used)) static void (*const vectors[16])(void) = {
    (void (*)(void))plt_stack_top,
    reset,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry,
    fault_entry};

/* CPACR bits 20 .. 23: full access to CP10 and CP11, the FPU. */
__attribute__((naked, used)) void reset(void) {
    __asm__ volatile(
        "ldr r0, =0xE000ED88\n"
        "ldr r1, [r0]\n"
        "orr r1, r1, #0x00F00000\n"
        "str r1, [r0]\n"
        "dsb\n"
        "isb\n"
        "b cortex_m_start\n"
        ".ltorg\n");
}

static void set_up_memory(void) {
    const uint32_t *from = plt_data_image;
    for (uint32_t *to = plt_data_start; to < plt_data_end; to++) {
        *to = *from++;
    }
    for (uint32_t *to = plt_bss_start; to < plt_bss_end; to++) {
        *to = 0;
    }
}

/* Paints the free stack: all below the frame this function runs in. */
static void paint_stack(void) {
    uint32_t *here;
    __asm__ volatile("mov %0, sp" : "=r"(here));
    for (volatile uint32_t *word = plt_stack_bottom; word < here; word++) {
        *word = PAINT;
    }
}

static void guard_stack(void) {
    if (MPU_TYPE == 0) {
        return; /* a core without MPU: the paint still shows it */
    }
    MPU_RNR = 0;
    MPU_RBAR = (uint32_t)(uintptr_t)plt_stack_guard;
    MPU_RASR = RASR_NO_ACCESS_256_BYTES;
    MPU_CTRL = MPU_ON_FOR_ALL_BUT_HARD_FAULT;
    __asm__ volatile("dsb\n isb" : : : "memory");
}

_Noreturn void cortex_m_start(void) {
    set_up_memory();
    paint_stack();
    guard_stack();
    cortex_m_main();
}

void cortex_m_stack(uint32_t *used_bytes, uint32_t *size_bytes) {
    const volatile uint32_t *word = plt_stack_bottom;
    while (word < plt_stack_top && *word == PAINT) {
        word++;
    }
    *used_bytes = (uint32_t)((uintptr_t)plt_stack_top - (uintptr_t)word);
    *size_bytes = (uint32_t)((uintptr_t)plt_stack_top - (uintptr_t)plt_stack_bottom);
}
