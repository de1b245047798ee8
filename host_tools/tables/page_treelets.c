/* page_treelets - Table 5.5: empty slots of treelets
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "host_tools/tables/page_kinds.h"
#include "host_tools/tables/page_lines.h"

enum { COLUMNS = PRINTED_TREELET_SIZES, INCOMPLETE = PRINTED_SCENES, BYTES = PRINTED_SCENES + 1 };

/* As the thesis writes bytes: in full below 1000, else thousands. */
static void put(sheet_line *line, unsigned column, double bytes, double incomplete) {
    char text[SHEET_TEXT], brackets[SHEET_TEXT] = "";
    if (isfinite(incomplete)) {
        snprintf(brackets, sizeof brackets / 2, "(%.0f)", incomplete);
    }
    if (bytes < 1000.0) {
        snprintf(text, sizeof text, "%.0f%.8s", bytes, brackets);
    } else {
        snprintf(text, sizeof text, "%.0fK%.8s", bytes / 1000.0, brackets);
    }
    sheet_put_text(line, column, bytes, isfinite(bytes) ? text : "-");
}

/* What the last treelet has empty when all others are full. */
static double least_of(double nodes, unsigned size) {
    return PRINTED_NODE_BYTES * (size * ceil(nodes / size) - nodes);
}

static void put_scene(sheet *s, const book_scene *scene, unsigned number, page_mean *bytes,
                      page_mean *incomplete) {
    char label[SHEET_LABEL];
    page_label(label, printed_scenes[number].name, &scene->about);
    page_printed(s, 5, number, label, "printed");
    sheet_line *rule = sheet_add(s, "", "their nodes");
    sheet_line *ours = sheet_add(s, "", "ours");
    sheet_line *share = sheet_add(s, "", "ours, % of size");
    for (unsigned c = 0; c < COLUMNS; c++) {
        const figures *f = &scene->treelets[c];
        const double empty = PRINTED_NODE_BYTES * (f->of[FIGURE_SLOTS] - f->of[FIGURE_NODES]);
        put(rule, c, least_of(printed_nodes(number), printed_treelet_sizes[c]), (double)NAN);
        put(ours, c, empty, f->of[FIGURE_INCOMPLETE]);
        sheet_put(share, c, 100.0 * empty / f->of[FIGURE_BYTES], 2);
        page_add(&bytes[c], empty);
        page_add(&incomplete[c], f->of[FIGURE_INCOMPLETE]);
    }
}

void page_treelets(sheet *s, const book *b) {
    page_mean bytes[COLUMNS] = {{0.0, 0}}, incomplete[COLUMNS] = {{0.0, 0}};
    double mean[COLUMNS];
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        if (b->scene[i].is_there) {
            put_scene(s, &b->scene[i], i, bytes, incomplete);
        }
    }
    for (unsigned c = 0; c < COLUMNS; c++) {
        mean[c] = page_mean_of(&incomplete[c]);
    }
    page_printed(s, 5, INCOMPLETE, "AVG incTL", "printed");
    page_line(s, "ours", mean, COLUMNS, 2);
    page_printed(s, 5, BYTES, "AVG bytes", "printed");
    sheet_line *line = sheet_add(s, "", "ours");
    for (unsigned c = 0; c < COLUMNS; c++) {
        put(line, c, page_mean_of(&bytes[c]), (double)NAN);
    }
    sheet_note(s,
               "their nodes: 32 bytes for each node that the thesis's tree, whose nodes Table "
               "5.1 gives, is short of whole treelets: the least there can be. Ours is of our "
               "tree, which has some nodes more or fewer, by the thesis's slot rule.");
}
