/* line - one line of text, built piece by piece and printed whole
 *
 * Decimal digits come from subtraction: a 64-bit division would be a library call
 * on small CPUs, with a stack that is not in the call graph.
 *
 * SPDX-License-Identifier: MIT */
#include "board/line.h"

#include "board/board.h"

void line_start(line *l) {
    l->used = 0;
    l->text[0] = '\0';
}

static void add(line *l, char c) {
    if (l->used + 2 < sizeof l->text) { /* '\n' and the zero always fit */
        l->text[l->used++] = c;
        l->text[l->used] = '\0';
    }
}

void line_text(line *l, const char *text) {
    for (; *text; text++) {
        add(l, *text);
    }
}

void line_some(line *l, const char *text, unsigned length) {
    for (unsigned i = 0; i < length; i++) {
        add(l, text[i]);
    }
}

static uint64_t power_of_ten(unsigned n) {
    uint64_t power = 1;
    for (; n > 0; n--) {
        power *= 10;
    }
    return power;
}

void line_u64(line *l, uint64_t value) {
    int begun = 0;
    for (unsigned position = 20; position-- > 0;) { /* 10^19 is the last below 2^64 */
        const uint64_t power = power_of_ten(position);
        char digit = '0';
        for (; value >= power; value -= power) {
            digit++;
        }
        begun |= digit != '0' || position == 0;
        if (begun) {
            add(l, digit);
        }
    }
}

void line_hex(line *l, uint64_t value, unsigned digits) {
    while (digits-- > 0) {
        add(l, "0123456789abcdef"[value >> (4 * digits) & 15u]);
    }
}

void line_item(line *l, const char *name, uint64_t value) {
    add(l, ' ');
    line_text(l, name);
    add(l, '=');
    line_u64(l, value);
}

void line_print(line *l) {
    l->text[l->used++] = '\n';
    l->text[l->used] = '\0';
    board_print(l->text);
    line_start(l);
}
