/* page_sizes - Table 5.1: bytes of the structures
 *
 * Ratios are of bytes per triangle, so that meshes of another size that stand in compare, too.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "host_tools/tables/page_kinds.h"
#include "host_tools/tables/page_lines.h"

enum { COLUMNS = 1 + BOOK_SIZES, FIRST = 1 };

/* Of the BPH all digits are known (printed.h), of the others those that are printed. */
static double their_bytes(unsigned scene, unsigned size) {
    return size == BOOK_BPH ? (double)PRINTED_NODE_BYTES * printed_nodes(scene)
                            : printed_bytes(scene, FIRST + size);
}

static void per_triangle(const book_scene *scene, unsigned number, double *ours, double *theirs) {
    ours[0] = scene->triangles;
    theirs[0] = printed_scenes[number].triangles;
    for (unsigned k = 0; k < BOOK_SIZES; k++) {
        ours[FIRST + k] = scene->size[k].of[FIGURE_BYTES] / scene->triangles;
        theirs[FIRST + k] = their_bytes(number, k) / theirs[0];
    }
}

static void put_scene(sheet *s, const book *b, unsigned number) {
    const book_scene *scene = &b->scene[number];
    double ours[COLUMNS], theirs[COLUMNS];
    char label[SHEET_LABEL], text[SHEET_TEXT];
    page_label(label, printed_scenes[number].name, &scene->about);
    page_printed(s, 1, number, label, "printed");
    sheet_line *line = sheet_add(s, "", "ours");
    sheet_with_commas(text, sizeof text, scene->triangles);
    sheet_put_text(line, 0, scene->triangles, text);
    for (unsigned k = 0; k < BOOK_SIZES; k++) {
        sheet_put_bytes(line, FIRST + k, scene->size[k].of[FIGURE_BYTES]);
    }
    per_triangle(scene, number, ours, theirs);
    line = sheet_add(s, "", "printed, B/triangle");
    for (unsigned c = FIRST; c < COLUMNS; c++) {
        sheet_put(line, c, theirs[c], 1);
    }
    line = sheet_add(s, "", "ours, B/triangle");
    for (unsigned c = FIRST; c < COLUMNS; c++) {
        sheet_put(line, c, ours[c], 1);
    }
    page_ratio(s, "ratio", ours, theirs, COLUMNS);
}

/* The mean over all rows of one structure's bytes over another's, in percent. */
static void put_share(sheet *s, const book *b, const char *row, unsigned of) {
    page_mean ours[BOOK_SIZES] = {{0.0, 0}}, theirs[BOOK_SIZES] = {{0.0, 0}};
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        for (unsigned k = 0; k < of && b->scene[i].is_there; k++) {
            const figures *size = b->scene[i].size;
            page_add(&ours[k], 100.0 * size[of].of[FIGURE_BYTES] / size[k].of[FIGURE_BYTES]);
            page_add(&theirs[k],
                     100.0 * printed_bytes(i, FIRST + of) / printed_bytes(i, FIRST + k));
        }
    }
    sheet_line *printed = sheet_add(s, row, "printed, mean %");
    for (unsigned k = 0; k < of; k++) {
        sheet_put(printed, FIRST + k, page_mean_of(&theirs[k]), 0);
    }
    sheet_line *own = sheet_add(s, "", "ours, mean %");
    for (unsigned k = 0; k < of; k++) {
        sheet_put(own, FIRST + k, page_mean_of(&ours[k]), 0);
    }
}

void page_sizes(sheet *s, const book *b) {
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        if (b->scene[i].is_there) {
            put_scene(s, b, i);
        }
    }
    put_share(s, b, "BPH of it", BOOK_BPH);
    put_share(s, b, "BPH2 of it", BOOK_BPH2);
    sheet_note(s,
               "K are 1000 bytes. Ratios are of bytes per triangle, and that of the shuttle's BPH2 "
               "is to 8K, not to the misprint. The BPH's printed bytes per triangle are from its "
               "nodes, which Table 5.2 gives, the others from rounded thousands.");
}
