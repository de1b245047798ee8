/* terminal_input - see terminal_input.h
 *
 * Sources: ECMA-48, 1991, section 5.4 (control sequences: CSI, bytes 0x30 to 0x3F, bytes 0x20 to
 * 0x2F, a final byte 0x40 to 0x7E) and 5.6 (strings: APC, DCS, OSC ... up to ST); xterm, "XTerm
 * Control Sequences": cursor keys (CSI or SS3, A to D), mouse tracking in SGR mode (CSI < Cb ; Cx ;
 * Cy M or m; Cb + 32 is a motion, 64 and 65 the wheel, 4, 8 and 16 are modifiers), Send Device
 * Attributes (primary: 4 is sixel graphics), window operation 16 (answer 6 ; height ; width t);
 * K. Goyal, "The terminal graphics protocol" of kitty (answers to a=q).
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/terminal_input.h"

#include <string.h>

enum { ESCAPE = 0x1B, PARAMETERS = 24, VALUE_MOST = 1000000 };

uint8_t *terminal_input_room(terminal_input *in, size_t *bytes) {
    if (in->count == sizeof in->bytes) {
        in->count = 0; /* no sequence is so long */
    }
    *bytes = sizeof in->bytes - in->count;
    return in->bytes + in->count;
}

void terminal_input_add(terminal_input *in, size_t bytes) {
    in->count += bytes;
}

/* Numbers separated by semicolons or colons, what is missing is 0. Returns how many. */
static unsigned read_numbers(const uint8_t *at, const uint8_t *end, int *value) {
    unsigned count = 1;
    value[0] = 0;
    for (; at < end; at++) {
        if (*at >= '0' && *at <= '9') {
            const int more = 10 * value[count - 1] + (*at - '0');
            value[count - 1] = more < VALUE_MOST ? more : VALUE_MOST;
        } else if ((*at == ';' || *at == ':') && count < PARAMETERS) {
            value[count++] = 0;
        }
    }
    return count;
}

static terminal_event mouse(const int *value, unsigned count, uint8_t last) {
    terminal_event e = {TERMINAL_OTHER, 0, 0, 0};
    if (count == 3) {
        e.code = value[0] & ~(4 | 8 | 16 | 32);
        e.x = value[1];
        e.y = value[2];
        e.kind = last == 'm' ? TERMINAL_RELEASE : value[0] & 32 ? TERMINAL_DRAG : TERMINAL_PRESS;
    }
    return e;
}

static terminal_event attributes(const int *value, unsigned count) {
    terminal_event e = {TERMINAL_ATTRIBUTES, 0, 0, 0};
    for (unsigned i = 1; i < count; i++) { /* the first is the terminal's class */
        e.code |= value[i] == 4;
    }
    return e;
}

/* What stands between CSI and its last byte. */
static terminal_event sequence(const uint8_t *at, const uint8_t *end) {
    const uint8_t last = *end;
    const uint8_t first = at < end ? *at : 0;
    int value[PARAMETERS];
    const unsigned count = read_numbers(at, end, value);
    if (first == '<' && (last == 'M' || last == 'm')) {
        return mouse(value, count, last);
    }
    if (first == '?' && last == 'c') {
        return attributes(value, count);
    }
    if (last == 't' && count == 3 && value[0] == 6) {
        return (terminal_event){TERMINAL_CELL, 0, value[2], value[1]};
    }
    if (last >= 'A' && last <= 'D' && first != '?') {
        return (terminal_event){TERMINAL_KEY, TERMINAL_UP + (last - 'A'), 0, 0};
    }
    return (terminal_event){TERMINAL_OTHER, last, 0, 0};
}

static terminal_event take(terminal_input *in, size_t bytes, terminal_event e) {
    in->count -= bytes;
    memmove(in->bytes, in->bytes + bytes, in->count);
    return e;
}

/* What is broken off by a byte that cannot be in it was keys, such as Alt and [. */
static terminal_event take_broken(terminal_input *in, size_t bytes) {
    return take(in, bytes, (terminal_event){TERMINAL_OTHER, 0, 0, 0});
}

static terminal_event take_sequence(terminal_input *in) {
    size_t at = 2;
    while (at < in->count && in->bytes[at] >= 0x20 && in->bytes[at] <= 0x3F) {
        at++;
    }
    if (at == in->count) {
        return (terminal_event){TERMINAL_NOTHING, 0, 0, 0};
    }
    return in->bytes[at] < 0x20 ? take_broken(in, at)
                                : take(in, at + 1, sequence(in->bytes + 2, in->bytes + at));
}

/* Whether a string may hold the byte at `at`: no control character but for layout (8 to 13), nor an
 * Escape that is not that of ST. */
static int is_in_string(const terminal_input *in, size_t at) {
    const uint8_t byte = in->bytes[at];
    return byte == ESCAPE ? at + 1 == in->count || in->bytes[at + 1] == '\\'
                          : byte >= 0x20 || (byte >= 8 && byte <= 13);
}

/* An APC or another string, up to ST; BEL ends an OSC as well. */
static terminal_event take_string(terminal_input *in) {
    for (size_t at = 2; at < in->count; at++) {
        const int is_st = in->bytes[at] == '\\' && in->bytes[at - 1] == ESCAPE && at > 2;
        if (is_st || in->bytes[at] == '\a') {
            terminal_event e = {TERMINAL_OTHER, 0, 0, 0};
            if (in->bytes[1] == '_' && at > 6 && in->bytes[2] == 'G') {
                e.kind = TERMINAL_KITTY;
                e.code = memcmp(in->bytes + at - 4, ";OK", 3) == 0;
            }
            return take(in, at + 1, e);
        }
        if (!is_in_string(in, at)) {
            return take_broken(in, at);
        }
    }
    return (terminal_event){TERMINAL_NOTHING, 0, 0, 0};
}

terminal_event terminal_input_take(terminal_input *in) {
    const uint8_t *b = in->bytes;
    if (in->count == 0 || (b[0] == ESCAPE && in->count == 1)) {
        return (terminal_event){TERMINAL_NOTHING, 0, 0, 0};
    }
    if (b[0] != ESCAPE) {
        return take(in, 1, (terminal_event){TERMINAL_KEY, b[0], 0, 0});
    }
    switch (b[1]) {
    case '[':
        return take_sequence(in);
    case 'O': /* SS3 */
        if (in->count < 3) {
            return (terminal_event){TERMINAL_NOTHING, 0, 0, 0};
        }
        if (b[2] >= 'A' && b[2] <= 'D') {
            const int code = TERMINAL_UP + (b[2] - 'A');
            return take(in, 3, (terminal_event){TERMINAL_KEY, code, 0, 0});
        }
        return take(in, 3, (terminal_event){TERMINAL_OTHER, 0, 0, 0});
    case '_':
    case 'P':
    case ']':
    case '^':
    case 'X':
        return take_string(in);
    default: /* a key with Alt, or Escape before another key */
        return take(in, 1, (terminal_event){TERMINAL_OTHER, 0, 0, 0});
    }
}

/* Not of SS3 and CSI: people hold keys that send those, and their parts may come apart. */
void terminal_input_pause(terminal_input *in) {
    const uint8_t second = in->count > 1 && in->bytes[0] == ESCAPE ? in->bytes[1] : 0;
    if (second != 0 && strchr("P]_^X", second) != NULL) {
        take_broken(in, 2);
    }
}
