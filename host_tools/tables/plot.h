/* plot - groups of bars, some with a mark where the thesis has its value
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLOT_H
#define PLOT_H
#include <stdint.h>

#include "host_tools/tables/drawing.h"

enum { PLOT_GROUPS = 12, PLOT_SERIES = 6, PLOT_NAME = 40 };

typedef struct plot_area {
    double x, y, x2, y2; /* with heads and legend */
} plot_area;

typedef struct plot {
    char title[3 * PLOT_NAME], unit[2 * PLOT_NAME];
    unsigned groups, series;
    char group[PLOT_GROUPS][PLOT_NAME];
    char name[PLOT_SERIES][PLOT_NAME];
    uint32_t colour[PLOT_SERIES];
    double bar[PLOT_GROUPS][PLOT_SERIES];  /* NaN: there is none */
    double mark[PLOT_GROUPS][PLOT_SERIES]; /* likewise */
    int is_log; /* bars begin at 1, 2 or 5 times a power of ten; those not above 0 have no height */
    double line; /* across all groups, at this value; NaN: none */
} plot;

/* All NaN, with the colours of this folder. */
void plot_clear(plot *p);
void plot_draw(const plot *p, drawing *d, plot_area where);

#endif
