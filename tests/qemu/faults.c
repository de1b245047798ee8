/* faults - what start-up promises, tried out: a program for test_start.sh
 *
 * The first word of the command line says what to try.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/cortex_m/semihost.h"
#include "platform/cortex_m/start.h"

enum { GOOD = 42, BAD = 1 };

extern uint32_t plt_stack_bottom[];

__attribute__((section(".arena"), used)) static unsigned char arena[16];
static volatile uint32_t copied = 0x12345678u, cleared[3];
static volatile float third = 3.0f;

void cortex_m_print(const char *text) {
    semihost_print(text);
}

_Noreturn void cortex_m_exit(int status) {
    semihost_exit(status);
}

static int memory_is_set_up(void) {
    return copied == 0x12345678u && cleared[0] == 0 && cleared[2] == 0;
}

static int paint_is_right(void) {
    uint32_t used, size;
    cortex_m_stack(&used, &size);
    return used > 0 && used < size;
}

/* Stores downwards from the stack's bottom, as a frame too deep would. */
static void store_below_stack(void) {
    volatile uint32_t *below = plt_stack_bottom;
    __asm__ volatile("" : "+r"(below)); /* no object of C's lies there */
    for (int i = 1; i <= 64; i++) {
        below[-i] = 0;
    }
}

static int try_out(char what) {
    switch (what) {
    case 'f': /* float: the FPU is on and rounds */
        return 1.0f / third == 0x1.555556p-2f ? GOOD : BAD;
    case 'm':
        return memory_is_set_up() ? GOOD : BAD;
    case 'p':
        return paint_is_right() ? GOOD : BAD;
    case 'g':
        store_below_stack();
        return BAD;
    case 'n': /* nowhere: no memory lies at 0x30000000 */
        return *(volatile int *)0x30000000u ? BAD : BAD;
    case 'u':
        __asm__ volatile("udf #0");
        return BAD;
    default:
        return BAD;
    }
}

_Noreturn void cortex_m_main(void) {
    static char line[64];
    if (semihost_command_line(line, sizeof line) < 0) {
        semihost_exit(BAD);
    }
    const char *at = line;
    while (*at && *at != ' ') {
        at++;
    }
    semihost_exit(try_out(*at ? at[1] : '?'));
}
