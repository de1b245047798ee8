/* semihost - a machine talks to the debugger or emulator that runs it
 *
 * Invariant: every call is an operation and the address of its arguments, which are words
 * as wide as a register; how the CPU stops for it is the family's (semihost_call).
 *
 * SPDX-License-Identifier: MIT */
#include "platform/bare/semihost.h"

enum {
    SYS_OPEN = 0x01,
    SYS_CLOSE = 0x02,
    SYS_WRITE0 = 0x04,
    SYS_WRITE = 0x05,
    SYS_READ = 0x06,
    SYS_SEEK = 0x0A,
    SYS_FLEN = 0x0C,
    SYS_CLOCK = 0x10,
    SYS_GET_CMDLINE = 0x15,
    SYS_EXIT_EXTENDED = 0x20,
    MODE_READ_BINARY = 1,
    MODE_WRITE_BINARY = 5,
    STOPPED_APPLICATION_EXIT = 0x20026
};

static intptr_t address(const void *p) {
    return (intptr_t)p;
}

void semihost_print(const char *text) {
    semihost_call(SYS_WRITE0, text);
}

int semihost_open(const char *path, int write) {
    intptr_t length = 0;
    while (path[length]) {
        length++;
    }
    const intptr_t a[3] = {address(path), write ? MODE_WRITE_BINARY : MODE_READ_BINARY, length};
    return (int)semihost_call(SYS_OPEN, a);
}

void semihost_close(int file) {
    const intptr_t a[1] = {file};
    semihost_call(SYS_CLOSE, a);
}

int32_t semihost_size(int file) {
    const intptr_t a[1] = {file};
    return (int32_t)semihost_call(SYS_FLEN, a);
}

int semihost_read_at(int file, uint32_t offset, void *to, uint32_t count) {
    const intptr_t seek[2] = {file, (intptr_t)offset};
    const intptr_t read[3] = {file, address(to), (intptr_t)count};
    if (semihost_call(SYS_SEEK, seek) != 0) {
        return -1;
    }
    return semihost_call(SYS_READ, read) == 0 ? 0 : -1; /* the answer: bytes not moved */
}

int semihost_write_at(int file, uint32_t offset, const void *from, uint32_t count) {
    const intptr_t seek[2] = {file, (intptr_t)offset};
    return semihost_call(SYS_SEEK, seek) == 0 ? semihost_write(file, from, count) : -1;
}

uint32_t semihost_centiseconds(void) {
    return (uint32_t)semihost_call(SYS_CLOCK, (void *)0);
}

int semihost_write(int file, const void *from, uint32_t count) {
    const intptr_t a[3] = {file, address(from), (intptr_t)count};
    return semihost_call(SYS_WRITE, a) == 0 ? 0 : -1;
}

int semihost_command_line(char *to, uint32_t bytes) {
    intptr_t a[2] = {address(to), (intptr_t)bytes};
    return semihost_call(SYS_GET_CMDLINE, a) == 0 ? 0 : -1;
}

_Noreturn void semihost_exit(int status) {
    const intptr_t a[2] = {STOPPED_APPLICATION_EXIT, status};
    for (;;) {
        semihost_call(SYS_EXIT_EXTENDED, a);
    }
}
