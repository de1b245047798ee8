/* pages - the figures of a book as sheets, in the layout of the thesis's tables
 *
 * SPDX-License-Identifier: MIT */
#ifndef PAGES_H
#define PAGES_H

#include "host_tools/tables/book.h"
#include "host_tools/tables/sheet.h"

/* Table `table`, 1 to 6, of those rows that are in the book. `s` is all zero, and freed by
 * sheet_free also on failure. -1: no memory. */
int pages_make(sheet *s, const book *b, unsigned table, fail *f);

/* One for each table. */
void page_sizes(sheet *s, const book *b);         /* 5.1 */
void page_intermediates(sheet *s, const book *b); /* 5.2 */
void page_speed(sheet *s, const book *b);         /* 5.3 */
void page_packets(sheet *s, const book *b);       /* 5.4 */
void page_treelets(sheet *s, const book *b);      /* 5.5 */
void page_overhead(sheet *s, const book *b);      /* 5.6 */

/* A line of what is printed in that row; `row` is its label. */
sheet_line *pages_printed(sheet *s, unsigned table, unsigned number, const char *row,
                          const char *what);
/* The name of a scene's row, with a star when another mesh stands in. */
void pages_label(char to[SHEET_LABEL], const char *name, const gallery_about *about);
/* Ours over theirs, line by line; "-" where one of them is no number or theirs is 0. */
void pages_ratio(sheet *s, const char *what, const double *ours, const double *theirs,
                 unsigned columns);
/* A line of numbers. */
void pages_line(sheet *s, const char *what, const double *values, unsigned columns,
                unsigned decimals);

/* The mean of those that are numbers; of none NaN. */
typedef struct pages_mean {
    double sum;
    unsigned count;
} pages_mean;

void pages_add(pages_mean *m, double value);
double pages_mean_of(const pages_mean *m);

#endif
