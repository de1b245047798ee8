/* start - start-up of a Cortex-M with hardware floats, and its stack
 *
 * The linker script gives (sections.ld): plt_data_start, plt_data_end,
 * plt_data_image, plt_bss_start, plt_bss_end, plt_stack_guard (256 bytes that
 * nothing may touch), plt_stack_bottom, plt_stack_top.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_CORTEX_M_START_H
#define PLT_CORTEX_M_START_H

#include <stdint.h>

/* Given by the board: called once, on the painted stack, all memory set up. */
_Noreturn void cortex_m_main(void);

/* Given by the board, for faults: prints a line of text; ends the program. */
void cortex_m_print(const char *text);
_Noreturn void cortex_m_exit(int status);

/* Most bytes of the stack that were ever used, and its size. */
void cortex_m_stack(uint32_t *used_bytes, uint32_t *size_bytes);

enum { CORTEX_M_FAULT_STATUS = 99 };

#endif
