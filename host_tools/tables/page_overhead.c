/* page_overhead - Table 5.6: what more packets meet because of treelets
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/page_kinds.h"
#include "host_tools/tables/page_lines.h"

enum { COLUMNS = BOOK_TREELETS, AVERAGE = PRINTED_SCENES };

static const char *const order_lines[BOOK_ORDERS] = {"Figure 4.2", "text of 4.2", "mirrored",
                                                     "sorted", "depth first"};

static void count(const figures treed[BOOK_TREELETS], double *to) {
    for (unsigned c = 0; c < COLUMNS; c++) {
        to[c] = treed[c].of[FIGURE_NODE_ISECTS] / treed[c].of[FIGURE_PACKETS];
    }
}

/* Over what is met without treelets, which is the first column of the first order. */
static void put_share(sheet *s, const char *what, const double *values, double without) {
    sheet_line *line = sheet_add(s, "", what);
    for (unsigned c = 1; c < COLUMNS; c++) {
        sheet_put(line, c, 100.0 * (values[c] / without - 1.0), 0);
    }
}

static void put_scene(sheet *s, const book_scene *scene, unsigned number, const char *label,
                      double *theirs) {
    double values[BOOK_ORDERS][COLUMNS];
    page_printed(s, 6, number, label, "printed");
    for (unsigned c = 0; c < COLUMNS; c++) {
        theirs[c] = printed_value(printed_cell(6, number, c));
    }
    put_share(s, "... % more", theirs, theirs[0]);
    for (unsigned order = 0; order < BOOK_ORDERS; order++) {
        count(scene->treed[order], values[order]);
        page_line(s, order_lines[order], values[order], COLUMNS, 1);
        put_share(s, "... % more", values[order], values[order][0]);
        if (order == BOOK_ORDER_MIRRORED) {
            page_ratio(s, "ratio", values[order], theirs, COLUMNS);
        }
    }
}

static void put_means(sheet *s, const book *b) {
    double mean[COLUMNS];
    page_printed(s, 6, AVERAGE, "AVG", "printed");
    for (unsigned order = 0; order < BOOK_ORDERS; order++) {
        page_mean sum[COLUMNS] = {{0.0, 0}};
        for (unsigned i = 0; i < PRINTED_SCENES; i++) {
            double values[COLUMNS];
            count(b->scene[i].treed[order], values);
            for (unsigned c = 0; c < COLUMNS; c++) {
                page_add(&sum[c], values[c]);
            }
        }
        for (unsigned c = 0; c < COLUMNS; c++) {
            mean[c] = page_mean_of(&sum[c]);
        }
        page_line(s, order_lines[order], mean, COLUMNS, 1);
        put_share(s, "... % more", mean, mean[0]);
    }
}

void page_overhead(sheet *s, const book *b) {
    double theirs[COLUMNS];
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        if (b->scene[i].is_there) {
            char label[SHEET_LABEL];
            page_label(label, printed_scenes[i].name, &b->scene[i].about);
            put_scene(s, &b->scene[i], i, label, theirs);
        }
    }
    put_means(s, b);
    sheet_note(s,
               "The first column is the BPH without treelets, the nearer child first. Figure 4.2: "
               "edges as they come, to the letter. text of 4.2: likewise, the nearer child of a "
               "node first, so that far edges are on top. mirrored: the farther one first, so "
               "that near edges are: it comes nearest to the printed figures, and the ratio is of "
               "it. None of the three tests again what has waited.");
    sheet_note(s,
               "sorted: a treelet's edges by distance, and tested again when they are taken. "
               "depth first: across treelets, as the engine does with scenes in memory.");
}
