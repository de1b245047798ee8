/* terminal_input - keys, the mouse and answers of a terminal, from its bytes
 *
 * SPDX-License-Identifier: MIT */
#ifndef TERMINAL_INPUT_H
#define TERMINAL_INPUT_H

#include <stddef.h>
#include <stdint.h>

enum terminal_event_kind {
    TERMINAL_NOTHING, /* the bytes so far are no whole event */
    TERMINAL_KEY,     /* `code` is a byte, or one of terminal_key */
    TERMINAL_PRESS,   /* a mouse button, `code`, at x, y */
    TERMINAL_DRAG,    /* it has moved there */
    TERMINAL_RELEASE,
    TERMINAL_ATTRIBUTES, /* an answer to CSI c: `code` is 1 if it can draw sixels */
    TERMINAL_CELL,       /* an answer to CSI 16 t: a cell is x by y pixels */
    TERMINAL_KITTY,      /* an answer to a query of kitty's graphics: `code` is 1 for OK */
    TERMINAL_OTHER       /* that nobody here waits for */
};

enum terminal_key { TERMINAL_UP = 256, TERMINAL_DOWN, TERMINAL_RIGHT, TERMINAL_LEFT };
enum terminal_button { TERMINAL_WHEEL_UP = 64, TERMINAL_WHEEL_DOWN = 65 };

typedef struct terminal_event {
    enum terminal_event_kind kind;
    int code, x, y; /* cells from 1 */
} terminal_event;

enum { TERMINAL_INPUT_BYTES = 256 };

/* All zero: nothing has come. */
typedef struct terminal_input {
    uint8_t bytes[TERMINAL_INPUT_BYTES];
    size_t count;
} terminal_input;

/* Where the next bytes are to be read to, and how many fit: at least 1 once all events are taken.
 */
uint8_t *terminal_input_room(terminal_input *in, size_t *bytes);
void terminal_input_add(terminal_input *in, size_t bytes);

/* The next event. What is longer than any sequence that is known is dropped. */
terminal_event terminal_input_take(terminal_input *in);

/* Nothing has come for a while: what looked like the beginning of a string (Escape and one of
 * P ] _ ^ X) was Alt and a key. */
void terminal_input_pause(terminal_input *in);

#endif
