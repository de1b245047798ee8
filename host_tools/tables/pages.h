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

#endif
