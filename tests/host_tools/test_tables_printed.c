/* test_tables_printed - the thesis's numbers agree with one another, where they are to
 *
 * What follows from Tables 5.1, 5.2 and 5.5 together is known from elsewhere (engine/DESIGN.md):
 * a digit that is copied wrong shows.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "host_tools/tables/printed.h"
#include "tests/test.h"

/* Whether `cell` is `value` in the digits it is printed with. */
static int says(const char *cell, double value) {
    return fabs(printed_value(cell) - value) <= 0.5 * printed_step(cell) + 1e-9;
}

/* The same where the last digit is rounded or cut off, as it is in Tables 5.2 and 5.5. */
static int nearly_says(const char *cell, double value) {
    return fabs(printed_value(cell) - value) < printed_step(cell);
}

static void check_cells(void) {
    test("cells are read as they are meant");
    CHECK(printed_value("1,285K") == 1285000.0, "%g", printed_value("1,285K"));
    CHECK(printed_value("0.5K") == 500.0 && printed_step("0.5K") == 100.0, "%g",
          printed_value("0.5K"));
    CHECK(printed_value("9K(13)") == 9000.0 && printed_in_brackets("9K(13)") == 13.0, "%g",
          printed_in_brackets("9K(13)"));
    CHECK(printed_value("12") == 12.0 && printed_step("12") == 1.0, "%g", printed_step("12"));
    CHECK(isnan(printed_value("-")) && isnan(printed_in_brackets("12")), "no number is one");
    CHECK(printed_value("3.82") == 3.82 && fabs(printed_step("3.82") - 0.01) < 1e-12, "%g",
          printed_step("3.82"));
}

static void check_nodes(void) {
    static const unsigned pairs[PRINTED_SCENES] = {5,     237,   2111,  3248,   4240,  6154,
                                                   29301, 30867, 69535, 329704, 411972};
    static const unsigned nodes[PRINTED_SCENES] = {6,     378,   3266,   5551,   6900,  9700,
                                                   40149, 47161, 104581, 541709, 675743};
    test("bytes saved are whole multiples of 28, which gives intermediates and nodes");
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        const double saved = printed_value(printed_cell(2, i, 1));
        CHECK(fmod(saved, 28.0) == 0.0, "%s: %g", printed_scenes[i].name, saved);
        CHECK(printed_intermediates(i) == pairs[i], "%s: %u", printed_scenes[i].name,
              printed_intermediates(i));
        CHECK(printed_nodes(i) == nodes[i], "%s: %u", printed_scenes[i].name, printed_nodes(i));
    }
    test("nodes times 32 are the BPH of Table 5.1, whose first column is the triangles");
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        CHECK(says(printed_cell(1, i, 4), 32.0 * nodes[i]), "%s", printed_scenes[i].name);
        CHECK(says(printed_cell(1, i, 0), printed_scenes[i].triangles), "%s",
              printed_scenes[i].name);
    }
}

static void check_shares(void) {
    double leaves = 0.0, sizes = 0.0;
    test("shares of leafs and of size follow from them");
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        const double pairs = printed_intermediates(i);
        const double single = printed_scenes[i].triangles - 2.0 * pairs;
        const double saved = 28.0 * pairs;
        const double leaf_share = 100.0 * pairs / (pairs + single);
        const double size_share = 100.0 * saved / (saved + 32.0 * printed_nodes(i));
        CHECK(nearly_says(printed_cell(2, i, 0), leaf_share), "%s: %g", printed_scenes[i].name,
              leaf_share);
        CHECK(nearly_says(printed_cell(2, i, 2), size_share), "%s: %g", printed_scenes[i].name,
              size_share);
        leaves += leaf_share / PRINTED_SCENES;
        sizes += size_share / PRINTED_SCENES;
    }
    CHECK(nearly_says(printed_cell(2, PRINTED_SCENES, 0), leaves), "mean of leafs: %g", leaves);
    CHECK(nearly_says(printed_cell(2, PRINTED_SCENES, 2), sizes), "mean of sizes: %g", sizes);
}

static void check_treelets(void) {
    unsigned right = 0, sum = 0, cells = 0;
    test("Table 5.5 is what nodes are short of whole treelets, in 98 of 99 cells");
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        for (unsigned c = 0; c < PRINTED_TREELET_SIZES; c++) {
            const unsigned size = printed_treelet_sizes[c];
            const double least = 32.0 * ((size - printed_nodes(i) % size) % size);
            const char *cell = printed_cell(5, i, c);
            const int is_right = nearly_says(cell, least);
            right += (unsigned)is_right;
            cells++;
            CHECK(is_right || (i == PRINTED_HAND && size == 256), "%s %u: %s, not %g",
                  printed_scenes[i].name, size, cell, least);
        }
    }
    CHECK(right == 98 && cells == 99, "%u of %u", right, cells);
    test("... and the mean of incomplete treelets is that of the brackets");
    for (unsigned c = 0; c < PRINTED_TREELET_SIZES; c++) {
        sum = 0;
        for (unsigned i = 0; i < PRINTED_SCENES; i++) {
            sum += (unsigned)printed_in_brackets(printed_cell(5, i, c));
        }
        CHECK(says(printed_cell(5, PRINTED_SCENES, c), sum / 11.0), "size %u: %u",
              printed_treelet_sizes[c], sum);
    }
}

static void check_overhead(void) {
    test("Table 5.6 begins as Table 5.4 does, and its means are those of its rows");
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        CHECK(strcmp(printed_cell(6, i, 0), printed_cell(4, i, 0)) == 0, "%s",
              printed_scenes[i].name);
    }
    for (unsigned c = 0; c < printed_of(6)->columns; c++) {
        double mean = 0.0;
        for (unsigned i = 0; i < PRINTED_SCENES; i++) {
            mean += printed_value(printed_cell(6, i, c)) / PRINTED_SCENES;
        }
        CHECK(says(printed_cell(6, PRINTED_SCENES, c), mean), "column %u: %g", c, mean);
    }
}

static void check_shape(void) {
    test("every cell is there, and the misprint is 8K");
    for (unsigned t = 1; t <= PRINTED_TABLES; t++) {
        const printed_table *p = printed_of(t);
        for (unsigned i = 0; i < p->rows * p->columns; i++) {
            CHECK(p->cell[i] != NULL && p->cell[i][0] != '\0', "Table %s, cell %u", p->number, i);
        }
    }
    CHECK(printed_bytes(PRINTED_SHUTTLE, 5) == 8000.0, "%g", printed_bytes(PRINTED_SHUTTLE, 5));
    CHECK(printed_bytes(PRINTED_SHUTTLE, 4) == 12000.0, "%g", printed_bytes(PRINTED_SHUTTLE, 4));
}

/* Whether a remark on Table 5.1 has the range of a column, without the ground, per triangle. */
static void check_range(unsigned column, const char *format, unsigned remark) {
    double least = 1e9, most = 0.0;
    char text[32];
    for (unsigned i = PRINTED_GROUND + 1; i < PRINTED_SCENES; i++) {
        const double bytes = printed_bytes(i, column) / printed_scenes[i].triangles;
        least = fmin(least, bytes);
        most = fmax(most, bytes);
    }
    snprintf(text, sizeof text, format, least, most);
    CHECK(strstr(printed_of(1)->remark[remark], text) != NULL, "%s: %s", text,
          printed_of(1)->remark[remark]);
}

static void check_remarks(void) {
    test("bytes per triangle in the remarks are those of the table");
    check_range(1, "%.0f to %.0f", 2);
    check_range(4, "%.1f to %.1f", 1);
    test("... and so is the most that treelets of buddha cost");
    const double more = 100.0 * (printed_value(printed_cell(6, PRINTED_BUDDHA, 3)) /
                                     printed_value(printed_cell(6, PRINTED_BUDDHA, 0)) -
                                 1.0);
    CHECK(fabs(more - 87.0) < 0.5 && strstr(printed_of(6)->remark[0], "87 %") != NULL, "%g", more);
}

int main(void) {
    check_cells();
    check_nodes();
    check_shares();
    check_treelets();
    check_overhead();
    check_shape();
    check_remarks();
    return test_done();
}
