/* terminal - a picture in character cells
 *
 * SPDX-License-Identifier: MIT */
#ifndef TERMINAL_H
#define TERMINAL_H
#include <stdio.h>

#include "host_tools/picture/picture.h"
#include "host_tools/picture/terminal_ink.h"

/* Draws `p` into at most `columns` x `rows` character cells, keeping its
 * aspect (a cell is twice as tall as wide), made smaller by area averaging,
 * never larger. Every line ends in a line
 * feed with all attributes reset; SIGINT waits for the last. 0 columns or rows:
 * picture_terminal_size. Returns 0, or -1 when writing failed (errno says why) or memory is out. */
int picture_show(FILE *to, const picture *p, picture_ink ink, unsigned columns, unsigned rows);

/* From the terminal, else COLUMNS and LINES, else 80 x 24; 1 .. 10000 each. */
void picture_terminal_size(FILE *to, unsigned *columns, unsigned *rows);

#endif
