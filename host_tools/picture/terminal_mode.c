/* terminal_mode - see terminal_mode.h
 *
 * Line feeds still return the carriage: pictures are drawn in lines that end in one.
 *
 * Sources: xterm, "XTerm Control Sequences" (ctlseqs), DECSET: 1049 the alternate screen, cursor
 * saved, 25 the cursor, 1002 the mouse with its button down, 1006 its reports in decimals; SGR 0.
 * POSIX.1-2017, chapter 11 (the general terminal interface).
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/terminal_mode.h"

#include <string.h>
#include <termios.h>
#include <unistd.h>

#include "host_tools/base/temporary.h"

static const char entering[] = "\x1b[?1049h\x1b[?25l\x1b[?1002h\x1b[?1006h\x1b[2J";
/* First ST and 2026: a picture that was being drawn is at its end. */
static const char leaving[] = "\x1b\\\x1b[?2026l\x1b[0m\x1b[?1006l\x1b[?1002l\x1b[?25h\x1b[?1049l";

static struct termios before, within;
static int files[2]; /* in, out */

int terminal_mode_again(void) {
    const ssize_t bytes = sizeof entering - 1;
    return tcsetattr(files[0], TCSAFLUSH, &within) != 0 ||
                   write(files[1], entering, (size_t)bytes) != bytes
               ? -1
               : 0;
}

int terminal_mode_enter(int in, int out) {
    if (!isatty(in) || !isatty(out) || tcgetattr(in, &before) != 0) {
        return -1;
    }
    within = before;
    files[0] = in;
    files[1] = out;
    within.c_iflag &= ~(tcflag_t)(BRKINT | ICRNL | INLCR | IGNCR | ISTRIP | IXON);
    within.c_lflag &= ~(tcflag_t)(ECHO | ECHONL | ICANON | IEXTEN | ISIG);
    within.c_cc[VMIN] = 1;
    within.c_cc[VTIME] = 0;
    temporary_terminal(in, out, &before, leaving);
    if (terminal_mode_again() != 0) {
        terminal_mode_leave();
        return -1;
    }
    return 0;
}

void terminal_mode_leave(void) {
    temporary_terminal_restore();
}
