/* charts - see charts.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/charts.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "host_tools/tables/page_lines.h"
#include "host_tools/tables/plot.h"

enum { WIDE = 1000, HIGH = 400, SPLIT_AT = 660 };

const char *const charts_titles[CHARTS] = {
    "Figure 5.3: memory of the structures, and bytes per triangle",
    "Figure 5.4: speed beside the wBVH, still scenes",
    "Figure 5.5: speed beside the wBVH, scenes in motion"};

static const char *const size_names[BOOK_SIZES] = {"BVH", "wBVH", "BKD", "BPH", "BPH2"};

unsigned charts_need(unsigned number) {
    return number == 3 ? 1u << 0 : 1u << 2;
}

static void name_series(plot *p, unsigned series, const char *name) {
    snprintf(p->name[series], PLOT_NAME, "%s", name);
    p->series = series + 1 > p->series ? series + 1 : p->series;
}

static void name_group(plot *p, const char *name, const gallery_about *about) {
    char label[SHEET_LABEL];
    page_label(label, name, about);
    snprintf(p->group[p->groups++], PLOT_NAME, "%.*s", PLOT_NAME - 1, label);
}

static void draw_sizes(drawing *d, const book *b) {
    plot p;
    plot_clear(&p);
    p.is_log = 1;
    snprintf(p.title, sizeof p.title, "Memory consumption (black lines: as printed)");
    snprintf(p.unit, sizeof p.unit, "bytes");
    for (unsigned k = 0; k < BOOK_SIZES; k++) {
        name_series(&p, k, size_names[k]);
    }
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        if (b->scene[i].is_there) {
            for (unsigned k = 0; k < BOOK_SIZES; k++) {
                p.bar[p.groups][k] = b->scene[i].size[k].of[FIGURE_BYTES];
                p.mark[p.groups][k] = printed_value(printed_cell(1, i, 1 + k));
            }
            name_group(&p, printed_scenes[i].name, &b->scene[i].about);
        }
    }
    plot_draw(&p, d, (plot_area){0, 0, SPLIT_AT, HIGH});
}

/* The means over all scenes. */
static void draw_per_triangle(drawing *d, const book *b) {
    static const gallery_about own = {0, ""};
    plot p;
    plot_clear(&p);
    snprintf(p.title, sizeof p.title, "Average, per triangle");
    snprintf(p.unit, sizeof p.unit, "bytes/triangle");
    name_series(&p, 0, "ours");
    for (unsigned k = 0; k < BOOK_SIZES; k++) {
        page_mean ours = {0.0, 0}, theirs = {0.0, 0};
        for (unsigned i = 0; i < PRINTED_SCENES; i++) {
            if (b->scene[i].is_there) {
                page_add(&ours, b->scene[i].size[k].of[FIGURE_BYTES] / b->scene[i].triangles);
                page_add(&theirs, printed_bytes(i, 1 + k) / printed_scenes[i].triangles);
            }
        }
        p.bar[p.groups][0] = page_mean_of(&ours);
        p.mark[p.groups][0] = page_mean_of(&theirs);
        name_group(&p, size_names[k], &own);
    }
    plot_draw(&p, d, (plot_area){SPLIT_AT, 0, WIDE, HIGH});
}

static void fill_race(plot *p, const figures race[BOOK_SIDES][BOOK_RACERS], unsigned row) {
    for (unsigned side = 0; side < BOOK_SIDES; side++) {
        const double wbvh = race[side][BOOK_RACE_WBVH].of[FIGURE_SECONDS];
        const double theirs = printed_value(printed_cell(3, row, BOOK_SIDES + side)) /
                              printed_value(printed_cell(3, row, side));
        p->bar[p->groups][side] = wbvh / race[side][BOOK_RACE_BPH].of[FIGURE_SECONDS];
        p->mark[p->groups][side] = theirs;
        p->bar[p->groups][BOOK_SIDES + side] =
            wbvh / race[side][BOOK_RACE_ENGINE].of[FIGURE_SECONDS];
    }
}

static void start_race(plot *p, int moving) {
    static const char *const names[2] = {"BPH", "Planelet"};
    plot_clear(p);
    p->is_log = 1;
    p->line = 1.0;
    snprintf(p->title, sizeof p->title, "%s (black lines: the BPH as printed)",
             charts_titles[moving ? 2 : 1]);
    snprintf(p->unit, sizeof p->unit, "times as fast as the wBVH");
    for (unsigned k = 0; k < 2 * BOOK_SIDES; k++) {
        char name[PLOT_NAME];
        snprintf(name, sizeof name, "%s %s", names[k / BOOK_SIDES], book_sides[k % BOOK_SIDES]);
        name_series(p, k, name);
    }
}

static void draw_still(drawing *d, const book *b) {
    plot p;
    start_race(&p, 0);
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        if (b->scene[i].is_there) {
            fill_race(&p, b->scene[i].race, i);
            name_group(&p, printed_scenes[i].name, &b->scene[i].about);
        }
    }
    plot_draw(&p, d, (plot_area){0, 0, WIDE, HIGH});
}

static void draw_moving(drawing *d, const book *b) {
    plot p;
    start_race(&p, 1);
    for (unsigned i = 0; i < PRINTED_ANIMATIONS; i++) {
        if (b->animation[i].is_there) {
            fill_race(&p, b->animation[i].race, PRINTED_SCENES + i);
            name_group(&p, printed_animations[i].name, &b->animation[i].about);
        }
    }
    plot_draw(&p, d, (plot_area){0, 0, WIDE, HIGH});
}

int charts_make(drawing *d, const book *b, unsigned number, fail *f) {
    d->width = WIDE;
    d->height = HIGH;
    if (number == 3) {
        draw_sizes(d, b);
        draw_per_triangle(d, b);
    } else if (number == 4) {
        draw_still(d, b);
    } else {
        draw_moving(d, b);
    }
    return d->wrong ? fail_set(f, "plot", "out of memory; close other programs") : 0;
}
