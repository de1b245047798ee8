/* viewer_screen - a picture over a whole terminal but its last line
 *
 * SPDX-License-Identifier: MIT */
#ifndef VIEWER_SCREEN_H
#define VIEWER_SCREEN_H

#include "host_tools/base/fail.h"
#include "host_tools/picture/picture.h"
#include "host_tools/picture/terminal_input.h"

enum viewer_graphics { VIEWER_AUTO, VIEWER_BLOCKS, VIEWER_KITTY, VIEWER_SIXEL };

typedef struct viewer_screen {
    enum viewer_graphics graphics; /* AUTO until viewer_screen_ask */
    unsigned columns, rows;        /* cells, the last line too */
    unsigned cell_width, cell_height;
    unsigned width, height; /* pixels of a picture */
    picture fitted;         /* as it is drawn */
    terminal_input input;
    int is_gone;     /* standard input has ended */
    int is_measured; /* something may have been drawn */
} viewer_screen;

/* Finds out what the terminal can draw, if that is to be found out: it has half a second to
 * answer. The terminal is in terminal_mode. */
void viewer_screen_ask(viewer_screen *s);

/* The terminal may have another size now: sizes are set, and the screen is empty. */
void viewer_screen_measure(viewer_screen *s);

/* Draws a picture of any size, and `text` in the last line. */
int viewer_screen_draw(viewer_screen *s, const picture *p, const char *text, fail *f);

/* Waits for input, at most so long (below 0: without end), or until a signal is caught. */
void viewer_screen_wait(viewer_screen *s, double seconds);

void viewer_screen_close(viewer_screen *s);

#endif
