/* page_intermediates - Table 5.2: what intermediate nodes save
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "host_tools/tables/page_kinds.h"
#include "host_tools/tables/page_lines.h"

enum { COLUMNS = 3, AVERAGE = PRINTED_SCENES };

/* As the thesis counts: of all that a node leads to beside nodes, 28 bytes each, and of the size
 * without intermediate nodes. */
static void count(const figures *bph, double *to) {
    const double pairs = bph->of[FIGURE_INTERMEDIATES];
    to[0] = 100.0 * pairs / (pairs + bph->of[FIGURE_LEAVES]);
    to[1] = PRINTED_INTERMEDIATE_BYTES * pairs;
    to[2] = 100.0 * to[1] / (to[1] + bph->of[FIGURE_BYTES]);
}

static void put_scene(sheet *s, const book_scene *scene, unsigned number, page_mean *mean) {
    double ours[COLUMNS], theirs[COLUMNS];
    char label[SHEET_LABEL], text[SHEET_TEXT];
    page_label(label, printed_scenes[number].name, &scene->about);
    page_printed(s, 2, number, label, "printed");
    count(&scene->size[BOOK_BPH], ours);
    sheet_line *line = sheet_add(s, "", "ours");
    sheet_put(line, 0, ours[0], 1);
    sheet_with_commas(text, sizeof text, ours[1]);
    sheet_put_text(line, 1, ours[1], text);
    sheet_put(line, 2, ours[2], 1);
    for (unsigned c = 0; c < COLUMNS; c++) {
        theirs[c] = printed_value(printed_cell(2, number, c));
        page_add(&mean[c], ours[c]);
    }
    page_ratio(s, "ratio", ours, theirs, COLUMNS);
}

void page_intermediates(sheet *s, const book *b) {
    page_mean mean[COLUMNS] = {{0.0, 0}};
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        if (b->scene[i].is_there) {
            put_scene(s, &b->scene[i], i, mean);
        }
    }
    page_printed(s, 2, AVERAGE, "AVG", "printed");
    sheet_line *line = sheet_add(s, "", "ours");
    sheet_put(line, 0, page_mean_of(&mean[0]), 1);
    sheet_put_text(line, 1, page_mean_of(&mean[1]), "-");
    sheet_put(line, 2, page_mean_of(&mean[2]), 1);
    sheet_note(s,
               "Ours are counted as printed, 28 bytes for each intermediate node. With the 32 "
               "that each saves, %% of total size are 3 more.");
}
