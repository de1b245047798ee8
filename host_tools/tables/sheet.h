/* sheet - a table as it is shown: heads, rows, and in each row a few lines under one another
 *
 * The thesis's columns stay as they are; each row has a line of what is printed, one of what is
 * measured, and their ratio below. So a sheet fits beside the page it is compared with, and in 100
 * columns of a terminal.
 *
 * Invariant: every line has a text and a number for each column.
 *
 * SPDX-License-Identifier: MIT */
#ifndef SHEET_H
#define SHEET_H

#include "host_tools/base/fail.h"
#include "host_tools/base/output.h"

enum { SHEET_COLUMNS = 12, SHEET_TEXT = 24, SHEET_LABEL = 40, SHEET_NOTE = 480 };

typedef struct sheet_cell {
    char text[SHEET_TEXT]; /* "": nothing to say */
    double value;          /* NaN: no number */
} sheet_cell;

typedef struct sheet_line {
    char row[SHEET_LABEL];  /* of the first line of a row; "": the row goes on */
    char what[SHEET_LABEL]; /* "printed", "ours", "ratio" ... */
    sheet_cell cell[SHEET_COLUMNS];
} sheet_line;

typedef struct sheet {
    char name[SHEET_LABEL]; /* "Table 5.1" */
    const char *title;
    unsigned columns;
    const char *group[SHEET_COLUMNS]; /* above neighbours of one group; "": none */
    const char *column[SHEET_COLUMNS];
    sheet_line *line; /* owned */
    unsigned lines, line_room;
    char (*note)[SHEET_NOTE]; /* owned */
    unsigned notes, note_room;
    int wrong; /* memory is out: all that follows does nothing */
} sheet;

void sheet_free(sheet *s);

/* The line, or one that is not kept when memory is out. Cells are empty. */
sheet_line *sheet_add(sheet *s, const char *row, const char *what);
void sheet_note(sheet *s, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* NaN: "-". */
void sheet_put(sheet_line *line, unsigned column, double value, unsigned decimals);
void sheet_put_text(sheet_line *line, unsigned column, double value, const char *text);
/* Bytes as the thesis has them: thousands as K, with a decimal below 1000, commas. */
void sheet_put_bytes(sheet_line *line, unsigned column, double bytes);

/* "1,234,567" of 1234567.0; room for SHEET_TEXT. */
void sheet_with_commas(char *to, size_t room, double value);

/* In columns of blanks; JSON: an object with title, columns, rows, notes, without an end of line
 * behind it. */
int sheet_print(const sheet *s, output *o, fail *f);
int sheet_print_json(const sheet *s, output *o, fail *f);

#endif
