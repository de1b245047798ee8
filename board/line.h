/* line - one line of text, built piece by piece and printed whole
 *
 * Invariant: `text` ends in a zero; what does not fit is left out.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_LINE_H
#define PLT_BOARD_LINE_H

#include <stdint.h>

typedef struct line {
    char text[240];
    unsigned used;
} line;

void line_start(line *l);
void line_text(line *l, const char *text);
void line_some(line *l, const char *text, unsigned length);
void line_u64(line *l, uint64_t value);
void line_hex(line *l, uint64_t value, unsigned digits);
void line_item(line *l, const char *name, uint64_t value); /* " name=value" */
void line_print(line *l); /* adds '\n', prints by board_print, starts anew */

#endif
