/* page_lines - see page_lines.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/page_lines.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void page_label(char to[SHEET_LABEL], const char *name, const gallery_about *about) {
    snprintf(to, SHEET_LABEL, "%s%s", name, about->stands_in ? "*" : "");
}

sheet_line *page_printed(sheet *s, unsigned table, unsigned number, const char *row,
                         const char *what) {
    sheet_line *line = sheet_add(s, row, what);
    for (unsigned c = 0; c < printed_of(table)->columns; c++) {
        const char *cell = printed_cell(table, number, c);
        sheet_put_text(line, c, printed_value(cell), cell);
    }
    return line;
}

void page_line(sheet *s, const char *what, const double *values, unsigned columns,
               unsigned decimals) {
    sheet_line *line = sheet_add(s, "", what);
    for (unsigned c = 0; c < columns; c++) {
        sheet_put(line, c, values[c], decimals);
    }
}

void page_ratio(sheet *s, const char *what, const double *ours, const double *theirs,
                unsigned columns) {
    sheet_line *line = sheet_add(s, "", what);
    for (unsigned c = 0; c < columns; c++) {
        const double ratio = theirs[c] > 0.0 ? ours[c] / theirs[c] : (double)NAN;
        sheet_put(line, c, ratio, 2);
    }
}

void page_add(page_mean *m, double value) {
    if (isfinite(value)) {
        m->sum += value;
        m->count++;
    }
}

double page_mean_of(const page_mean *m) {
    return m->count > 0 ? m->sum / m->count : (double)NAN;
}
