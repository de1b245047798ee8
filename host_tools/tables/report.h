/* report - all sheets, charts and pictures as one page of HTML that needs nothing else
 *
 * SPDX-License-Identifier: MIT */
#ifndef REPORT_H
#define REPORT_H

#include "host_tools/tables/book.h"
#include "host_tools/tables/drawing.h"
#include "host_tools/tables/sheet.h"

typedef struct report_chart {
    const char *title;
    const drawing *drawing;
} report_chart;

typedef struct report {
    const book *book;
    const char *where; /* the folder of meshes; NULL: all are made */
    const sheet *sheet;
    unsigned sheets;
    const report_chart *chart;
    unsigned charts;
} report;

/* `o` stays the caller's. */
int report_write(const report *r, output *o, fail *f);

#endif
