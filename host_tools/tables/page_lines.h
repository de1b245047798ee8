/* page_lines - the lines that the sheets of tables are made of
 *
 * SPDX-License-Identifier: MIT */
#ifndef PAGE_LINES_H
#define PAGE_LINES_H

#include "host_tools/tables/book.h"
#include "host_tools/tables/sheet.h"

/* A line of what is printed in that row; `row` is its label. */
sheet_line *page_printed(sheet *s, unsigned table, unsigned number, const char *row,
                         const char *what);
/* The name of a scene's row, with a star when another mesh stands in. */
void page_label(char to[SHEET_LABEL], const char *name, const gallery_about *about);
/* Ours over theirs, line by line; "-" where one of them is no number or theirs is 0. */
void page_ratio(sheet *s, const char *what, const double *ours, const double *theirs,
                unsigned columns);
/* A line of numbers. */
void page_line(sheet *s, const char *what, const double *values, unsigned columns,
               unsigned decimals);

/* The mean of those that are numbers; of none NaN. */
typedef struct page_mean {
    double sum;
    unsigned count;
} page_mean;

void page_add(page_mean *m, double value);
double page_mean_of(const page_mean *m);

#endif
