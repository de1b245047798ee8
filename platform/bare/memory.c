/* memory - the four functions that a compiler may call on its own
 *
 * The firmware links no C library: its whole code is in the call graph, and
 * so is its whole stack. Words are moved where both addresses allow it.
 * GCC must not see a memcpy in these loops: -fno-tree-loop-distribute-patterns
 * in board/firmware.mk.
 *
 * SPDX-License-Identifier: MIT */
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* Reads and writes any object, whatever its type. */
typedef uint32_t __attribute__((may_alias)) word;

static int both_aligned(const void *a, const void *b) {
    return (((uintptr_t)a | (uintptr_t)b) & 3u) == 0;
}

void *memcpy(void *restrict to, const void *restrict from, size_t count) {
    unsigned char *t = to;
    const unsigned char *f = from;
    if (both_aligned(to, from)) {
        for (; count >= 4; count -= 4, t += 4, f += 4) {
            *(word *)(void *)t = *(const word *)(const void *)f;
        }
    }
    for (; count > 0; count--) {
        *t++ = *f++;
    }
    return to;
}

void *memmove(void *to, const void *from, size_t count) {
    unsigned char *t = to;
    const unsigned char *f = from;
    if ((uintptr_t)t - (uintptr_t)f >= count) { /* t before f, or after its last byte */
        for (size_t i = 0; i < count; i++) {
            t[i] = f[i];
        }
        return to;
    }
    for (; count > 0; count--) {
        t[count - 1] = f[count - 1];
    }
    return to;
}

void *memset(void *to, int value, size_t count) {
    unsigned char *t = to;
    const unsigned char byte = (unsigned char)value;
    if (both_aligned(to, to)) {
        for (; count >= 4; count -= 4, t += 4) {
            *(word *)(void *)t = byte * 0x01010101u;
        }
    }
    for (; count > 0; count--) {
        *t++ = byte;
    }
    return to;
}

int memcmp(const void *a, const void *b, size_t count) {
    const unsigned char *x = a, *y = b;
    for (; count > 0 && *x == *y; count--) {
        x++;
        y++;
    }
    return count > 0 ? *x - *y : 0;
}
