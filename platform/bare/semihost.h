/* semihost - a machine talks to the debugger or emulator that runs it
 *
 * Source: Arm, Semihosting for AArch32 and AArch64, release 2.0; RISC-V Semihosting 0.4 has the
 * same operations.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SEMIHOST_H
#define PLT_SEMIHOST_H

#include <stddef.h>
#include <stdint.h>

/* Given by the family of CPUs: stops for the debugger, and returns what it answers. */
intptr_t semihost_call(intptr_t operation, const void *arguments);

void semihost_print(const char *text);

/* Files of the host. Handles are not negative; sizes in bytes. */
int semihost_open(const char *path, int write); /* binary; -1: cannot */
void semihost_close(int file);
int32_t semihost_size(int file); /* -1: not known */
/* Moves all `count` bytes and returns 0, or -1. */
int semihost_read_at(int file, uint32_t offset, void *to, uint32_t count);
int semihost_write(int file, const void *from, uint32_t count);
int semihost_write_at(int file, uint32_t offset, const void *from, uint32_t count);

/* The command line as the host put it, program name first; -1: does not fit. */
int semihost_command_line(char *to, uint32_t bytes);

/* The debugger's clock: it counts up and wraps. */
uint32_t semihost_centiseconds(void);

_Noreturn void semihost_exit(int status);

#endif
