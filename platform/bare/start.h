/* start - start-up of a machine without an operating system, and its stack
 *
 * A family of CPUs (platform/cortex_m, platform/riscv) starts, guards its stack and
 * reports faults; what is the same on all of them is here. The linker script gives
 * (sections.ld): plt_data_start, plt_data_end, plt_data_image, plt_bss_start,
 * plt_bss_end, plt_text_start, plt_text_end, plt_stack_guard (256 bytes that nothing may
 * touch), plt_stack_bottom, plt_stack_top.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BARE_START_H
#define PLT_BARE_START_H

#include <stdint.h>

/* ---- given by the board --------------------------------------------------- */

/* Called once, on the painted stack, all memory set up. */
_Noreturn void machine_main(void);

/* For faults: prints a line of text; ends the program. */
void machine_print(const char *text);
_Noreturn void machine_exit(int status);

/* ---- given by the family --------------------------------------------------- */

/* Entered from `reset`, which has painted the stack and turned the FPU on. */
_Noreturn void machine_start(void);

/* From here on, what stores below plt_stack_bottom faults, if the CPU can see to that. */
void guard_stack(void);

/* ---- given here ------------------------------------------------------------ */

/* What `reset` fills the stack with before any compiled code runs. */
#define PLT_STACK_PAINT 0xA5C35A3C

/* Copies .data and clears .bss. */
void start_memory(void);

/* Most bytes of the stack that were ever used, and its size. */
void machine_stack(uint32_t *used_bytes, uint32_t *size_bytes);

/* Last words: prints " name=" and the value in hexadecimal, 8 digits or 16 as registers are. */
void fault_item(const char *name, uintptr_t value);

/* Where the stack ran over: the return address nearest to its bottom, or 0. */
uintptr_t fault_near(void);

enum { MACHINE_FAULT_STATUS = 99 };

#endif
