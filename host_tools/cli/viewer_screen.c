/* viewer_screen - see viewer_screen.h
 *
 * Sources: as of terminal_input.c; the reports of TIOCGWINSZ, ioctl_tty(2).
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/viewer_screen.h"

#include <errno.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "host_tools/base/clock.h"
#include "host_tools/picture/fit.h"
#include "host_tools/picture/terminal.h"
#include "host_tools/picture/terminal_graphics.h"

/* What is not known of a cell, and the most pixels that are worth their bytes. */
enum { CELL_WIDTH = 8, CELL_HEIGHT = 16, CELL_MOST = 100, SIDE_MOST = 1600 };

static const double PATIENCE = 0.5;

/* Below 0: without end. */
static void wait_for_bytes(viewer_screen *s, double seconds) {
    struct pollfd in = {.fd = STDIN_FILENO, .events = POLLIN};
    const int ms = seconds < 0.0 ? -1 : (int)(1000.0 * seconds + 0.999);
    size_t room;
    const int ready = poll(&in, 1, ms);
    if (ready < 0 && errno != EINTR) {
        s->is_gone = 1;
    }
    if (ready == 0 && seconds > 0.0) {
        terminal_input_pause(&s->input);
    }
    if (ready <= 0) {
        return;
    }
    uint8_t *to = terminal_input_room(&s->input, &room);
    const ssize_t got = read(STDIN_FILENO, to, room);
    if (got > 0) {
        terminal_input_add(&s->input, (size_t)got);
    } else if (got == 0 || errno != EINTR) {
        s->is_gone = 1;
    }
}

void viewer_screen_wait(viewer_screen *s, double seconds) {
    wait_for_bytes(s, seconds);
}

static int may_be_asked(void) {
    const char *term = getenv("TERM");
    return term != NULL && strcmp(term, "dumb") != 0 && strcmp(term, "linux") != 0 &&
           strncmp(term, "vt", 2) != 0;
}

static void set_cell(viewer_screen *s, int width, int height) {
    if (width > 0 && height > 0 && width <= CELL_MOST && height <= CELL_MOST) {
        s->cell_width = (unsigned)width;
        s->cell_height = (unsigned)height;
    }
}

/* Every terminal answers the last question, and those before it, if at all, before it. */
static void hear(viewer_screen *s, enum viewer_graphics *best) {
    const double end = clock_seconds() + PATIENCE;
    for (double left; !s->is_gone && (left = end - clock_seconds()) > 0.0;) {
        wait_for_bytes(s, left);
        for (terminal_event e; (e = terminal_input_take(&s->input)).kind != TERMINAL_NOTHING;) {
            if (e.kind == TERMINAL_KITTY && e.code) {
                *best = VIEWER_KITTY;
            } else if (e.kind == TERMINAL_CELL) {
                set_cell(s, e.x, e.y);
            } else if (e.kind == TERMINAL_ATTRIBUTES) {
                *best = *best == VIEWER_BLOCKS && e.code ? VIEWER_SIXEL : *best;
                return;
            }
        }
    }
}

void viewer_screen_ask(viewer_screen *s) {
    enum viewer_graphics best = VIEWER_BLOCKS;
    set_cell(s, CELL_WIDTH, CELL_HEIGHT);
    if (s->graphics != VIEWER_BLOCKS && may_be_asked()) {
        fputs(TERMINAL_QUERY, stdout);
        fflush(stdout);
        hear(s, &best);
    }
    s->graphics = s->graphics == VIEWER_AUTO ? best : s->graphics;
    viewer_screen_measure(s);
}

void viewer_screen_measure(viewer_screen *s) {
    picture_terminal_size(stdout, &s->columns, &s->rows);
    const unsigned lines = s->rows > 1 ? s->rows - 1 : 1;
#ifdef TIOCGWINSZ
    struct winsize size;
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0) {
        set_cell(s, size.ws_xpixel / size.ws_col, size.ws_ypixel / size.ws_row);
    }
#endif
    const int is_blocks = s->graphics == VIEWER_BLOCKS;
    s->width = s->columns * (is_blocks ? 1 : s->cell_width);
    s->height = lines * (is_blocks ? 2 : s->cell_height);
    const unsigned most = s->width > s->height ? s->width : s->height;
    if (!is_blocks && most > SIDE_MOST) {
        s->width = s->width * SIDE_MOST / most;
        s->height = s->height * SIDE_MOST / most;
    }
    s->width = s->width > 0 ? s->width : 1;
    s->height = s->height > 0 ? s->height : 1;
    s->is_measured = 1;
    fputs("\x1b[0m\x1b[2J", stdout);
}

static int draw_picture(const viewer_screen *s) {
    const unsigned lines = s->rows > 1 ? s->rows - 1 : 1;
    return s->graphics == VIEWER_KITTY ? terminal_kitty(stdout, &s->fitted, s->columns, lines)
           : s->graphics == VIEWER_SIXEL
               ? terminal_sixel(stdout, &s->fitted)
               : picture_show(stdout, &s->fitted, PICTURE_AUTO, s->columns, lines);
}

/* Mode 2026: a terminal that knows it shows all of a picture at once, others ignore it. */
int viewer_screen_draw(viewer_screen *s, const picture *p, const char *text, fail *f) {
    if (picture_resize(&s->fitted, s->width, s->height, f) != 0) {
        return -1;
    }
    fit_picture(p, &s->fitted, FIT_STRETCH);
    fputs("\x1b[?2026h\x1b[H", stdout);
    if (draw_picture(s) != 0 && !ferror(stdout)) {
        return fail_set(f, "terminal", "out of memory; close other programs");
    }
    fprintf(stdout, "\x1b[%u;1H\x1b[0m\x1b[K%.*s\x1b[?2026l", s->rows, (int)s->columns - 1, text);
    if (fflush(stdout) != 0 || ferror(stdout)) {
        return fail_set(f, "terminal", "the picture cannot be drawn; is the terminal still there?");
    }
    return 0;
}

void viewer_screen_close(viewer_screen *s) {
    if (s->graphics == VIEWER_KITTY && s->is_measured) {
        terminal_kitty_end(stdout);
    }
    if (s->is_measured) {
        fflush(stdout); /* not at the end of the program, on a screen that is put back */
    }
    picture_free(&s->fitted);
}
