/* faults - what start-up promises, tried out: a program for tests/qemu/test_guards.sh
 *
 * The first letter of the parameters says what to try. PROGRAM=faults builds it for any board,
 * without the engine.
 *
 * SPDX-License-Identifier: MIT */
#include "board/board.h"

enum { GOOD = 42, BAD = 1 };

extern uint32_t plt_stack_bottom[];

static volatile uint32_t copied = 0x12345678u, cleared[3];
static volatile float third = 3.0f, two = 2.0f, least = 0x1p-149f;

static int memory_is_set_up(void) {
    return copied == 0x12345678u && cleared[0] == 0 && cleared[2] == 0;
}

static int paint_is_right(void) {
    uint32_t used, size;
    board_stack(&used, &size);
    return used > 0 && used < size;
}

/* Rounds to nearest, keeps subnormals, and has the whole root. */
static int floats_are_right(void) {
    return 1.0f / third == 0x1.555556p-2f && __builtin_sqrtf(two) == 0x1.6a09e6p+0f &&
           __builtin_sqrtf(least) == 0x1.6a09e6p-75f && least / two == 0.0f &&
           third * least == 0x1.8p-148f;
}

/* Stores downwards from the stack's bottom, as by a pointer that went wrong. */
static void store_below_stack(void) {
    volatile uint32_t *below = plt_stack_bottom;
    __asm__ volatile("" : "+r"(below)); /* no object of C's lies there */
    for (int i = 1; i <= 64; i++) {
        below[-i] = 0;
    }
}

/* What a recursion without end does to the stack, in frames of 16 bytes. */
static void overrun(void) {
#ifdef __riscv
    __asm__ volatile("1: addi sp, sp, -16\n sw ra, 0(sp)\n j 1b");
#else
    __asm__ volatile("1: push {r4, r5, r6, lr}\n b 1b");
#endif
}

static void run_undefined(void) {
#ifdef __riscv
    __asm__ volatile(".word 0");
#else
    __asm__ volatile(".short 0xde00");
#endif
}

static int try_out(char what) {
    switch (what) {
    case 'f':
        return floats_are_right() ? GOOD : BAD;
    case 'm':
        return memory_is_set_up() ? GOOD : BAD;
    case 'p':
        return paint_is_right() ? GOOD : BAD;
    case 's':
        store_below_stack();
        return BAD;
    case 'o':
        overrun();
        return BAD;
    case 'n':
        return *(volatile int *)0x30000000u ? BAD : GOOD;
    case 'u':
        run_undefined();
        return BAD;
    case 'l': /* until the limit */
        for (;;) {
        }
    default:
        return BAD;
    }
}

int firmware(const char *parameters) {
    return try_out(*parameters ? parameters[1] : '?');
}
