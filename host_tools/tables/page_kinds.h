/* page_kinds - a sheet for each of the thesis's tables
 *
 * SPDX-License-Identifier: MIT */
#ifndef PAGE_KINDS_H
#define PAGE_KINDS_H

#include "host_tools/tables/book.h"
#include "host_tools/tables/sheet.h"

/* Rows, and notes of its own; heads are there. */
void page_sizes(sheet *s, const book *b);         /* 5.1 */
void page_intermediates(sheet *s, const book *b); /* 5.2 */
void page_speed(sheet *s, const book *b);         /* 5.3 */
void page_packets(sheet *s, const book *b);       /* 5.4 */
void page_treelets(sheet *s, const book *b);      /* 5.5 */
void page_overhead(sheet *s, const book *b);      /* 5.6 */

#endif
