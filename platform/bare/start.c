/* start - see start.h
 *
 * SPDX-License-Identifier: MIT */
#include "platform/bare/start.h"

extern uint32_t plt_data_start[], plt_data_end[], plt_data_image[];
extern uint32_t plt_bss_start[], plt_bss_end[];
extern uint32_t plt_stack_bottom[], plt_stack_top[];
extern unsigned char plt_text_start[], plt_text_end[];

void start_memory(void) {
    const uint32_t *from = plt_data_image;
    for (uint32_t *to = plt_data_start; to < plt_data_end; to++) {
        *to = *from++;
    }
    for (uint32_t *to = plt_bss_start; to < plt_bss_end; to++) {
        *to = 0;
    }
}

void machine_stack(uint32_t *used_bytes, uint32_t *size_bytes) {
    const volatile uint32_t *word = plt_stack_bottom;
    while (word < plt_stack_top && *word == PLT_STACK_PAINT) {
        word++;
    }
    *used_bytes = (uint32_t)((uintptr_t)plt_stack_top - (uintptr_t)word);
    *size_bytes = (uint32_t)((uintptr_t)plt_stack_top - (uintptr_t)plt_stack_bottom);
}

void fault_item(const char *name, uintptr_t value) {
    char text[2 * sizeof value + 1];
    const unsigned digits = sizeof text - 1;
    for (unsigned i = 0; i < digits; i++) {
        text[i] = "0123456789abcdef"[value >> (4 * (digits - 1 - i)) & 15u];
    }
    text[digits] = '\0';
    machine_print(name);
    machine_print(text);
}

/* Return addresses of Thumb are odd, those of other code even. */
uintptr_t fault_near(void) {
#ifdef __thumb__
    enum { LOWEST_BIT = 1 };
#else
    enum { LOWEST_BIT = 0 };
#endif
    const uintptr_t *word = (const uintptr_t *)(const void *)plt_stack_bottom;
    for (; word < (const uintptr_t *)(const void *)plt_stack_top; word++) {
        if ((*word & 1u) == LOWEST_BIT && *word > (uintptr_t)plt_text_start &&
            *word < (uintptr_t)plt_text_end) {
            return *word;
        }
    }
    return 0;
}
