/* sheet - see sheet.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/sheet.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "host_tools/app/json_string.h"
#include "host_tools/base/heap.h"

enum { NOTE_COLUMNS = 98 };

void sheet_free(sheet *s) {
    heap_drop(s->line);
    heap_drop(s->note);
    memset(s, 0, sizeof *s);
}

/* Room for one more; NULL: there is no memory. */
static void *grow(sheet *s, void *block, unsigned count, unsigned *room, size_t bytes) {
    if (s->wrong || count < *room) {
        return s->wrong ? NULL : block;
    }
    void *grown = heap_resize(block, (uint64_t)(2 * *room + 32) * bytes);
    s->wrong = grown == NULL;
    *room = grown != NULL ? 2 * *room + 32 : *room;
    return grown;
}

sheet_line *sheet_add(sheet *s, const char *row, const char *what) {
    static sheet_line lost;
    sheet_line *grown = grow(s, s->line, s->lines, &s->line_room, sizeof *s->line);
    if (grown == NULL) {
        return &lost;
    }
    s->line = grown;
    sheet_line *line = &s->line[s->lines++];
    memset(line, 0, sizeof *line);
    snprintf(line->row, sizeof line->row, "%s", row);
    snprintf(line->what, sizeof line->what, "%s", what);
    for (unsigned i = 0; i < SHEET_COLUMNS; i++) {
        line->cell[i].value = (double)NAN;
    }
    return line;
}

void sheet_note(sheet *s, const char *format, ...) {
    void *grown = grow(s, s->note, s->notes, &s->note_room, sizeof *s->note);
    if (grown == NULL) {
        return;
    }
    va_list list;
    s->note = grown;
    va_start(list, format);
    vsnprintf(s->note[s->notes++], sizeof *s->note, format, list);
    va_end(list);
}

void sheet_put_text(sheet_line *line, unsigned column, double value, const char *text) {
    snprintf(line->cell[column].text, SHEET_TEXT, "%s", text);
    line->cell[column].value = value;
}

void sheet_put(sheet_line *line, unsigned column, double value, unsigned decimals) {
    char text[SHEET_TEXT] = "-";
    if (!isnan(value)) {
        snprintf(text, sizeof text, "%.*f", (int)decimals, value);
    }
    sheet_put_text(line, column, value, text);
}

void sheet_with_commas(char *to, size_t room, double value) {
    char digits[SHEET_TEXT];
    size_t at = 0;
    const int length = snprintf(digits, sizeof digits, "%.0f", value);
    for (int i = 0; i < length && at + 2 < room; i++) {
        if (i > 0 && (length - i) % 3 == 0) {
            to[at++] = ',';
        }
        to[at++] = digits[i];
    }
    to[at] = '\0';
}

void sheet_put_bytes(sheet_line *line, unsigned column, double bytes) {
    char text[SHEET_TEXT] = "-";
    if (bytes < 1000.0) {
        snprintf(text, sizeof text, "%.1fK", bytes / 1000.0);
    } else if (!isnan(bytes)) {
        sheet_with_commas(text, sizeof text - 1, bytes / 1000.0);
        strcat(text, "K");
    }
    sheet_put_text(line, column, bytes, text);
}

/* ---- text -------------------------------------------------------------- */

static int wider(int width, const char *text) {
    const int length = (int)strlen(text);
    return length > width ? length : width;
}

typedef struct widths {
    int row, what, column[SHEET_COLUMNS];
} widths;

static int is_group_start(const sheet *s, unsigned column) {
    return column == 0 || strcmp(s->group[column], s->group[column - 1]) != 0;
}

static unsigned group_end(const sheet *s, unsigned column) {
    do {
        column++;
    } while (column < s->columns && !is_group_start(s, column));
    return column;
}

/* The columns of a group are as wide together as its head. */
static void widen_groups(const sheet *s, widths *w) {
    for (unsigned i = 0, end; i < s->columns; i = end) {
        int all = 0;
        end = group_end(s, i);
        for (unsigned k = i; k < end; k++) {
            all += w->column[k] + 1;
        }
        for (; all < (int)strlen(s->group[i]) + 1; all++) {
            w->column[end - 1]++;
        }
    }
}

static void measure(const sheet *s, widths *w) {
    memset(w, 0, sizeof *w);
    w->row = wider(0, "Scene");
    for (unsigned c = 0; c < s->columns; c++) {
        w->column[c] = wider(0, s->column[c]);
    }
    for (unsigned i = 0; i < s->lines; i++) {
        w->row = wider(w->row, s->line[i].row);
        w->what = wider(w->what, s->line[i].what);
        for (unsigned c = 0; c < s->columns; c++) {
            w->column[c] = wider(w->column[c], s->line[i].cell[c].text);
        }
    }
    widen_groups(s, w);
}

/* A bar stands before each group but the first. */
static const char *before(const sheet *s, unsigned column) {
    return column > 0 && s->group[column][0] != '\0' && is_group_start(s, column) ? " |" : "";
}

static int has_groups(const sheet *s) {
    return s->columns > 0 && s->group[0][0] != '\0';
}

static int print_groups(const sheet *s, const widths *w, output *o, fail *f) {
    output_print(o, f, "%-*s  %-*s", w->row, "", w->what, "");
    for (unsigned i = 0, end; i < s->columns; i = end) {
        int all = 0;
        end = group_end(s, i);
        for (unsigned k = i; k < end; k++) {
            all += w->column[k] + 1;
        }
        output_print(o, f, "%s%*s", before(s, i), all, s->group[i]);
    }
    return output_print(o, f, "\n");
}

/* Fills lines of NOTE_COLUMNS with its words. */
static int print_wrapped(const char *text, output *o, fail *f) {
    const char *indent = "* ";
    while (*text != '\0') {
        size_t length = strlen(text);
        if (length > NOTE_COLUMNS) {
            for (length = NOTE_COLUMNS; length > 1 && text[length] != ' '; length--) {
            }
        }
        output_print(o, f, "%s%.*s\n", indent, (int)length, text);
        text += length;
        text += strspn(text, " ");
        indent = "  ";
    }
    return 0;
}

int sheet_print(const sheet *s, output *o, fail *f) {
    widths w;
    measure(s, &w);
    output_print(o, f, "%s: %s\n\n", s->name, s->title);
    if (has_groups(s)) {
        print_groups(s, &w, o, f);
    }
    output_print(o, f, "%-*s  %-*s", w.row, "Scene", w.what, "");
    for (unsigned c = 0; c < s->columns; c++) {
        output_print(o, f, "%s %*s", before(s, c), w.column[c], s->column[c]);
    }
    for (unsigned i = 0; i < s->lines; i++) {
        const sheet_line *line = &s->line[i];
        output_print(o, f, "\n%-*s  %-*s", w.row, line->row, w.what, line->what);
        for (unsigned c = 0; c < s->columns; c++) {
            output_print(o, f, "%s %*s", before(s, c), w.column[c], line->cell[c].text);
        }
    }
    output_print(o, f, "\n\n");
    for (unsigned i = 0; i < s->notes; i++) {
        print_wrapped(s->note[i], o, f);
    }
    return output_print(o, f, "\n");
}

/* ---- JSON -------------------------------------------------------------- */

static void json_head(const sheet *s, output *o, fail *f) {
    output_print(o, f, "{\"name\": ");
    json_write_string(o, s->name, f);
    output_print(o, f, ", \"title\": ");
    json_write_string(o, s->title, f);
    output_print(o, f, ", \"columns\": [");
    for (unsigned c = 0; c < s->columns; c++) {
        char name[2 * SHEET_LABEL];
        snprintf(name, sizeof name, "%s%s%s", s->group[c], s->group[c][0] != '\0' ? " " : "",
                 s->column[c]);
        output_print(o, f, "%s", c > 0 ? ", " : "");
        json_write_string(o, name, f);
    }
}

static void json_line(const sheet *s, const char *row, const sheet_line *line, output *o, fail *f) {
    output_print(o, f, "    {\"scene\": ");
    json_write_string(o, row, f);
    output_print(o, f, ", \"line\": ");
    json_write_string(o, line->what, f);
    output_print(o, f, ", \"values\": [");
    for (unsigned c = 0; c < s->columns; c++) {
        const double value = line->cell[c].value;
        output_print(o, f, "%s", c > 0 ? ", " : "");
        if (isfinite(value)) {
            output_print(o, f, "%.10g", value);
        } else {
            output_print(o, f, "null");
        }
    }
    output_print(o, f, "], \"texts\": [");
    for (unsigned c = 0; c < s->columns; c++) {
        output_print(o, f, "%s", c > 0 ? ", " : "");
        json_write_string(o, line->cell[c].text, f);
    }
    output_print(o, f, "]}");
}

int sheet_print_json(const sheet *s, output *o, fail *f) {
    const char *row = "";
    json_head(s, o, f);
    output_print(o, f, "], \"rows\": [\n");
    for (unsigned i = 0; i < s->lines; i++) {
        row = s->line[i].row[0] != '\0' ? s->line[i].row : row;
        json_line(s, row, &s->line[i], o, f);
        output_print(o, f, "%s\n", i + 1 < s->lines ? "," : "");
    }
    output_print(o, f, "  ], \"notes\": [");
    for (unsigned i = 0; i < s->notes; i++) {
        output_print(o, f, "%s", i > 0 ? ", " : "");
        json_write_string(o, s->note[i], f);
    }
    return output_print(o, f, "]}");
}
