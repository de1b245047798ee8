/* semihost - a Cortex-M talks to the debugger or emulator that runs it
 *
 * Invariant: every call is one BKPT 0xAB with the operation in r0 and the
 * address of its arguments in r1; the answer comes in r0.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/cortex_m/semihost.h"

enum {
    SYS_OPEN = 0x01,
    SYS_CLOSE = 0x02,
    SYS_WRITE0 = 0x04,
    SYS_WRITE = 0x05,
    SYS_READ = 0x06,
    SYS_SEEK = 0x0A,
    SYS_FLEN = 0x0C,
    SYS_GET_CMDLINE = 0x15,
    SYS_EXIT_EXTENDED = 0x20,
    MODE_READ_BINARY = 1,
    MODE_WRITE_BINARY = 5,
    STOPPED_APPLICATION_EXIT = 0x20026
};

static int32_t call(int32_t operation, const void *arguments) {
    register int32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = arguments;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

static uint32_t address(const void *p) {
    return (uint32_t)(uintptr_t)p;
}

void semihost_print(const char *text) {
    call(SYS_WRITE0, text);
}

int semihost_open(const char *path, int write) {
    uint32_t length = 0;
    while (path[length]) {
        length++;
    }
    const uint32_t a[3] = {address(path), write ? MODE_WRITE_BINARY : MODE_READ_BINARY, length};
    return call(SYS_OPEN, a);
}

void semihost_close(int file) {
    const int32_t a[1] = {file};
    call(SYS_CLOSE, a);
}

int32_t semihost_size(int file) {
    const int32_t a[1] = {file};
    return call(SYS_FLEN, a);
}

int semihost_read_at(int file, uint32_t offset, void *to, uint32_t count) {
    const uint32_t seek[2] = {(uint32_t)file, offset};
    const uint32_t read[3] = {(uint32_t)file, address(to), count};
    if (call(SYS_SEEK, seek) != 0) {
        return -1;
    }
    return call(SYS_READ, read) == 0 ? 0 : -1; /* the answer: bytes not moved */
}

int semihost_write(int file, const void *from, uint32_t count) {
    const uint32_t a[3] = {(uint32_t)file, address(from), count};
    return call(SYS_WRITE, a) == 0 ? 0 : -1;
}

int semihost_command_line(char *to, uint32_t bytes) {
    uint32_t a[2] = {address(to), bytes};
    return call(SYS_GET_CMDLINE, a) == 0 ? 0 : -1;
}

_Noreturn void semihost_exit(int status) {
    const int32_t a[2] = {STOPPED_APPLICATION_EXIT, status};
    for (;;) {
        call(SYS_EXIT_EXTENDED, a);
    }
}
