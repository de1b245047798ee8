/* page_packets - Table 5.4: what packets meet in the BPH
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/page_kinds.h"
#include "host_tools/tables/page_lines.h"

enum { COLUMNS = 3 * BOOK_SIDES };

static void count(const figures traced[BOOK_SIDES], double *to) {
    for (unsigned i = 0; i < BOOK_SIDES; i++) {
        const double packets = traced[i].of[FIGURE_PACKETS];
        to[i] = traced[i].of[FIGURE_NODE_ISECTS] / packets;
        to[BOOK_SIDES + i] = traced[i].of[FIGURE_TRIANGLE_ISECTS] / packets;
        to[2 * BOOK_SIDES + i] = 100.0 * traced[i].of[FIGURE_MASKED];
    }
}

static void put_scene(sheet *s, const book_scene *scene, unsigned number) {
    double median[COLUMNS], sah[COLUMNS], theirs[COLUMNS];
    char label[SHEET_LABEL];
    page_label(label, printed_scenes[number].name, &scene->about);
    page_printed(s, 4, number, label, "printed");
    for (unsigned c = 0; c < COLUMNS; c++) {
        theirs[c] = printed_value(printed_cell(4, number, c));
    }
    count(scene->traced[BOOK_MEDIAN], median);
    count(scene->traced[BOOK_SAH], sah);
    page_line(s, "ours, median", median, COLUMNS, 1);
    page_ratio(s, "ratio", median, theirs, COLUMNS);
    page_line(s, "ours, SAH", sah, COLUMNS, 1);
    page_ratio(s, "SAH : median", sah, median, COLUMNS);
}

void page_packets(sheet *s, const book *b) {
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        if (b->scene[i].is_there) {
            put_scene(s, &b->scene[i], i);
        }
    }
    sheet_note(
        s,
        "Means over all packets of the views. Trees split in the spatial median, as the "
        "thesis does, or by the surface area heuristic, one triangle per leaf. Rays that are "
        "masked out are those of a packet at a node that had not met what is above it. At "
        "triangles there are more (trace --baseline bph --json).");
}
