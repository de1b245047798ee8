/* plot - see plot.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/plot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define INK 0x202020u
#define GRID 0xD8D8D8u
#define LOG_LEAST 1e-12 /* so that powers of ten below it are numbers */

/* Told apart without colours by their order, and by people who do not see red or green: the hues
 * of Okabe and Ito, "Color Universal Design", 2008. */
static const uint32_t hues[PLOT_SERIES] = {0x0072B2, 0x56B4E9, 0xE69F00,
                                           0x009E73, 0xD55E00, 0xCC79A7};

enum { LEFT = 52, TOP = 44, BOTTOM = 30, LEGEND_ROW = 14, RIGHT = 8 };

void plot_clear(plot *p) {
    memset(p, 0, sizeof *p);
    p->line = (double)NAN;
    for (unsigned s = 0; s < PLOT_SERIES; s++) {
        p->colour[s] = hues[s];
        for (unsigned g = 0; g < PLOT_GROUPS; g++) {
            p->bar[g][s] = p->mark[g][s] = (double)NAN;
        }
    }
}

typedef struct scale {
    double least, most; /* of what is shown */
    double top, bottom; /* where they are drawn */
    int is_log;
} scale;

/* A logarithm has no place for what is not above 0: such bars have no height. */
static void take_in(scale *s, double value) {
    if (isfinite(value) && (!s->is_log || value >= LOG_LEAST)) {
        s->least = fmin(s->least, value);
        s->most = fmax(s->most, value);
    }
}

/* A step of 1, 2 or 5 times a power of ten, of which `most` has five to ten. */
static double nice_step(double most) {
    double step = 1.0;
    for (; step * 10.0 < most; step *= 10.0) {
    }
    for (; step > most; step /= 10.0) {
    }
    return most / step > 5.0 ? step : most / step > 2.0 ? 0.5 * step : 0.2 * step;
}

/* Of a value from LOG_LEAST up. */
static double power_below(double value) {
    double power = 1.0;
    for (; power > value; power /= 10.0) {
    }
    for (; power * 10.0 <= value; power *= 10.0) {
    }
    return power;
}

static scale scale_of(const plot *p, plot_area inner) {
    scale s = {.least = (double)INFINITY, .top = inner.y, .bottom = inner.y2, .is_log = p->is_log};
    for (unsigned g = 0; g < p->groups; g++) {
        for (unsigned k = 0; k < p->series; k++) {
            take_in(&s, p->bar[g][k]);
            take_in(&s, p->mark[g][k]);
        }
    }
    take_in(&s, p->line);
    if (!(s.most > 0.0)) {
        s.least = s.most = 1.0; /* nothing to show */
    }
    if (s.is_log) {
        const double least = s.least, power = power_below(least);
        s.least = 5.0 * power <= least ? 5.0 * power : 2.0 * power <= least ? 2.0 * power : power;
        s.most = fmax(10.0 * s.least, s.most * 1.15);
    } else {
        const double step = nice_step(s.most);
        s.least = 0.0;
        s.most = step * ceil(1.02 * s.most / step);
    }
    return s;
}

/* Rounded, so that logarithms that differ in the last bit draw the same pixels. */
static double height_of(const scale *s, double value) {
    const double part = s->is_log ? log10(value / s->least) / log10(s->most / s->least)
                                  : (value - s->least) / (s->most - s->least);
    const double high = fmax(0.0, fmin(1.0, part)) * (s->bottom - s->top);
    return s->bottom - floor(64.0 * high + 0.5) / 64.0;
}

static void tick(drawing *d, const scale *s, plot_area inner, double value) {
    char text[DRAWING_TEXT];
    const double y = height_of(s, value);
    const double k = value >= 1e9 ? 1e9 : value >= 1e6 ? 1e6 : value >= 1e3 ? 1e3 : 1.0;
    snprintf(text, sizeof text, "%.4g%s", value / k,
             k > 1e6   ? "G"
             : k > 1e3 ? "M"
             : k > 1.0 ? "K"
                       : "");
    drawing_line(d, inner.x, y, inner.x2, y, 0.75, GRID);
    drawing_letters(d, inner.x - 5.0, y + 3.5, DRAWING_END, 1, INK, text);
}

static void tick_within(drawing *d, const scale *s, plot_area inner, double value) {
    if (value > 0.999 * s->least && value <= s->most) {
        tick(d, s, inner, value);
    }
}

static void draw_ticks(drawing *d, const scale *s, plot_area inner) {
    if (s->is_log) {
        for (double v = power_below(s->least); v <= s->most; v *= 10.0) {
            tick_within(d, s, inner, v);
            if (s->most / s->least <= 100.0) {
                tick_within(d, s, inner, 2.0 * v);
                tick_within(d, s, inner, 5.0 * v);
            }
        }
    } else {
        const double step = nice_step(s->most);
        for (unsigned i = 0; i * step <= 1.001 * s->most; i++) {
            tick(d, s, inner, i * step);
        }
    }
}

/* The mark is a black line across its bar. */
static void draw_group(const plot *p, drawing *d, const scale *s, plot_area inner, unsigned g) {
    const double wide = (inner.x2 - inner.x) / p->groups;
    const double each = 0.8 * wide / p->series;
    const double left = inner.x + (g + 0.1) * wide;
    for (unsigned k = 0; k < p->series; k++) {
        const double x = left + k * each, bar = p->bar[g][k], mark = p->mark[g][k];
        if (isfinite(bar)) {
            drawing_rectangle(d, x + 0.5, height_of(s, bar), x + each - 0.5, s->bottom,
                              p->colour[k]);
        }
        if (isfinite(mark)) {
            const double y = height_of(s, mark);
            drawing_line(d, x + 0.5, y, x + each - 0.5, y, 1.5, INK);
        }
    }
    /* Names that are too wide for their groups take turns on two lines. */
    const int is_low = wide < 62.0 && p->groups > 1 && g % 2 == 1;
    drawing_letters(d, inner.x + (g + 0.5) * wide, s->bottom + (is_low ? 24.0 : 13.0),
                    DRAWING_MIDDLE, 1, INK, p->group[g]);
}

static void draw_legend(const plot *p, drawing *d, plot_area where) {
    double x = where.x + LEFT, y = where.y + 27.0;
    for (unsigned k = 0; k < p->series; k++) {
        const double wide = 20.0 + (double)DRAWING_ADVANCE * (double)strlen(p->name[k]);
        if (x + wide > where.x2 && x > where.x + LEFT) {
            x = where.x + LEFT;
            y += LEGEND_ROW;
        }
        drawing_rectangle(d, x, y - 7.0, x + 9.0, y + 1.0, p->colour[k]);
        drawing_letters(d, x + 13.0, y + 0.5, DRAWING_START, 1, INK, p->name[k]);
        x += wide + 8.0;
    }
}

/* Rows that the legend has below its first. */
static unsigned legend_rows(const plot *p, plot_area where) {
    double x = where.x + LEFT;
    unsigned rows = 1;
    for (unsigned k = 0; k < p->series; k++) {
        const double wide = 20.0 + (double)DRAWING_ADVANCE * (double)strlen(p->name[k]);
        if (x + wide > where.x2 && x > where.x + LEFT) {
            x = where.x + LEFT;
            rows++;
        }
        x += wide + 8.0;
    }
    return rows;
}

void plot_draw(const plot *p, drawing *d, plot_area where) {
    const plot_area inner = {where.x + LEFT,
                             where.y + TOP + LEGEND_ROW * (double)legend_rows(p, where) - 6.0,
                             where.x2 - RIGHT, where.y2 - BOTTOM};
    const scale s = scale_of(p, inner);
    drawing_letters(d, where.x + LEFT, where.y + 12.0, DRAWING_START, 1, INK, p->title);
    draw_legend(p, d, where);
    drawing_letters(d, where.x + 4.0, inner.y - 8.0, DRAWING_START, 1, INK, p->unit);
    draw_ticks(d, &s, inner);
    for (unsigned g = 0; g < p->groups; g++) {
        draw_group(p, d, &s, inner, g);
    }
    if (isfinite(p->line)) {
        drawing_line(d, inner.x, height_of(&s, p->line), inner.x2, height_of(&s, p->line), 1.0,
                     INK);
    }
    drawing_line(d, inner.x, s.bottom, inner.x2, s.bottom, 1.0, INK);
}
