/* page_speed - Table 5.3: rays per time, beside the wBVH's of the same run
 *
 * Frames per second are another machine's. What can be compared is how many times as fast the BPH
 * is as the wBVH, and cycles per ray: the thesis's are 1.7 GHz over its frames of 512 x 512 rays,
 * with shading.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "host_tools/tables/page_kinds.h"
#include "host_tools/tables/page_lines.h"

#define THEIR_HERTZ 1.7e9 /* section 5.1 */
#define THEIR_RAYS (512.0 * 512.0)

enum { COLUMNS = BOOK_SIDES * BOOK_RACERS };

typedef struct speed {
    double fps[COLUMNS];                           /* theirs */
    double their_cycles[COLUMNS], cost[COLUMNS];   /* per ray: cycles, or else nanoseconds */
    double their_factor[COLUMNS], factor[COLUMNS]; /* times as fast as the wBVH */
} speed;

static double cost_of(const figures *f, int has_cycles) {
    return has_cycles ? f->of[FIGURE_CYCLES] / f->of[FIGURE_RAYS]
                      : 1e9 * f->of[FIGURE_SECONDS] / f->of[FIGURE_RAYS];
}

static void fill(speed *to, const figures race[BOOK_SIDES][BOOK_RACERS], unsigned row,
                 int has_cycles) {
    for (unsigned c = 0; c < COLUMNS; c++) {
        const unsigned side = c % BOOK_SIDES, racer = c / BOOK_SIDES;
        const figures *own = &race[side][racer], *wbvh = &race[side][BOOK_RACE_WBVH];
        const int is_theirs = c < printed_of(3)->columns;
        to->fps[c] = is_theirs ? printed_value(printed_cell(3, row, c)) : (double)NAN;
        to->their_cycles[c] = THEIR_HERTZ / (to->fps[c] * THEIR_RAYS);
        to->their_factor[c] = to->fps[c] / to->fps[side];
        to->cost[c] = cost_of(own, has_cycles);
        to->factor[c] = wbvh->of[FIGURE_SECONDS] / own->of[FIGURE_SECONDS];
    }
}

static void put_row(sheet *s, const char *name, const gallery_about *about, const speed *v,
                    int has_cycles) {
    char label[SHEET_LABEL];
    page_label(label, name, about);
    sheet_line *line = sheet_add(s, label, "printed, fps");
    for (unsigned c = 0; c < COLUMNS; c++) {
        sheet_put(line, c, v->fps[c], 0);
    }
    page_line(s, "printed, cycles/ray", v->their_cycles, COLUMNS, 0);
    page_line(s, has_cycles ? "ours, cycles/ray" : "ours, ns/ray", v->cost, COLUMNS, 0);
    page_line(s, "printed, x wBVH", v->their_factor, COLUMNS, 2);
    page_line(s, "ours, x wBVH", v->factor, COLUMNS, 2);
    page_ratio(s, "ratio of those", v->factor, v->their_factor, COLUMNS);
}

/* Whether the system lets cycles be counted: then it did in all rows. */
static int counts_cycles(const book *b) {
    int there = 0, counted = 0;
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        const double cycles = b->scene[i].race[0][BOOK_RACE_WBVH].of[FIGURE_CYCLES];
        there += b->scene[i].is_there;
        counted += b->scene[i].is_there && isfinite(cycles);
    }
    return there > 0 && counted == there;
}

static void set_columns(sheet *s) {
    s->columns = COLUMNS;
    for (unsigned c = 0; c < COLUMNS; c++) {
        static const char *const racers[BOOK_RACERS] = {"wBVH", "BPH", "Planelet"};
        s->group[c] = racers[c / BOOK_SIDES];
        s->column[c] = book_sides[c % BOOK_SIDES];
    }
}

/* Geometric: of factors. */
static void put_mean(sheet *s, const speed *rows, unsigned count, const char *name) {
    double ours[COLUMNS], theirs[COLUMNS];
    for (unsigned c = 0; c < COLUMNS; c++) {
        page_mean own = {0.0, 0}, printed = {0.0, 0};
        for (unsigned i = 0; i < count; i++) {
            page_add(&own, log(rows[i].factor[c]));
            page_add(&printed, log(rows[i].their_factor[c]));
        }
        ours[c] = exp(page_mean_of(&own));
        theirs[c] = exp(page_mean_of(&printed));
    }
    sheet_line *line = sheet_add(s, name, "printed, x wBVH");
    for (unsigned c = 0; c < COLUMNS; c++) {
        sheet_put(line, c, theirs[c], 2);
    }
    page_line(s, "ours, x wBVH", ours, COLUMNS, 2);
}

void page_speed(sheet *s, const book *b) {
    speed row[PRINTED_SCENES + PRINTED_ANIMATIONS];
    unsigned rows = 0;
    const int has_cycles = counts_cycles(b);
    set_columns(s);
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        if (b->scene[i].is_there) {
            fill(&row[rows], b->scene[i].race, i, has_cycles);
            put_row(s, printed_scenes[i].name, &b->scene[i].about, &row[rows++], has_cycles);
        }
    }
    const unsigned still = rows;
    for (unsigned i = 0; i < PRINTED_ANIMATIONS; i++) {
        if (b->animation[i].is_there) {
            fill(&row[rows], b->animation[i].race, PRINTED_SCENES + i, has_cycles);
            put_row(s, printed_animations[i].name, &b->animation[i].about, &row[rows++],
                    has_cycles);
        }
    }
    put_mean(s, row, still, "mean, still");
    put_mean(s, row + still, rows - still, "mean, moving");
    sheet_note(s,
               "x wBVH: how many times as fast as our wBVH, which traced the same packets in "
               "turn with it. Planelet is the engine's own tree. Printed cycles are 1.7 GHz "
               "over frames of 512x512 rays, with shading. Ours are without. Means are geometric.");
    sheet_note(s, has_cycles ? "Cycles are those that the processor counts (perf_event_open)."
                             : "The system does not let cycles be counted: ours are nanoseconds "
                               "of the processor's time per ray.");
    sheet_note(s, "Animations: %u frames each, evenly spread. Trees are refitted from the first.",
               b->options.steps);
}
