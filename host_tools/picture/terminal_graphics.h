/* terminal_graphics - pictures pixel by pixel, in terminals that draw them
 *
 * SPDX-License-Identifier: MIT */
#ifndef TERMINAL_GRAPHICS_H
#define TERMINAL_GRAPHICS_H

#include <stdio.h>

#include "host_tools/picture/picture.h"

/* Each writes `p` with its upper left corner where the cursor is. -1: out of memory; errors of `to`
 * stay in it. */

/* By kitty's protocol, as image 1, in place of the last, scaled to so many cells. */
int terminal_kitty(FILE *to, const picture *p, unsigned columns, unsigned rows);
/* Takes it away again. */
void terminal_kitty_end(FILE *to);

/* In sixels: 6 x 7 x 6 colours, dithered by an ordered pattern. */
int terminal_sixel(FILE *to, const picture *p);

/* What a terminal is asked: whether it knows kitty's protocol, how large a cell is, and what it can
 * do; every terminal answers the last. */
#define TERMINAL_QUERY "\x1b_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\x1b\\\x1b[16t\x1b[c"

#endif
