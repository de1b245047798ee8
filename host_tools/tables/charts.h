/* charts - Figures 5.3 to 5.5 of the thesis, from the figures of a book
 *
 * Bars are ours; a line across a bar is what the thesis prints.
 *
 * SPDX-License-Identifier: MIT */
#ifndef CHARTS_H
#define CHARTS_H

#include "host_tools/tables/book.h"
#include "host_tools/tables/drawing.h"

enum { CHARTS_FIRST = 3, CHARTS_LAST = 5, CHARTS = CHARTS_LAST - CHARTS_FIRST + 1 };

extern const char *const charts_titles[CHARTS];

/* Figure 5.`number`; `d` is all zero, and freed by drawing_free also on failure. -1: no memory. */
int charts_make(drawing *d, const book *b, unsigned number, fail *f);

/* The tables, as in book_options, that it is drawn from. */
unsigned charts_need(unsigned number);

#endif
