/* spare - see spare.h
 *
 * SPDX-License-Identifier: MIT */
#include "board/played/spare.h"

/* Not a byte that fills memory of other programs. */
enum { PATTERN = 0xA7 };

void spare_fill(const spare *s) {
    for (size_t i = s->used; i < s->bytes; i++) {
        s->arena[i] = PATTERN;
    }
}

size_t spare_touched(const spare *s) {
    size_t end = s->bytes;
    while (end > s->used && s->arena[end - 1] == PATTERN) {
        end--;
    }
    return end;
}
