/* still - the marbles of scene_marbles for a picture: of glass, metal and paint, in a wooden tray
 *
 * The tray is level, on a table, its floor of boards whose grain is stripes of several browns. A
 * ball has four triangles for each of the scene's, and some of glass have three coloured vanes.
 *
 * SPDX-License-Identifier: MIT */
#ifndef STILL_H
#define STILL_H
#include "host_tools/scenes/painted.h"

/* Paints. Browns go from dark to light. */
enum still_paint {
    STILL_TABLE,
    STILL_GAP, /* between boards */
    STILL_BROWN,
    STILL_BROWNS = 10,
    STILL_RIM = STILL_BROWN + STILL_BROWNS, /* darker browns, of the rim */
    STILL_RIMS = 6,
    STILL_CLEAR = STILL_RIM + STILL_RIMS,
    STILL_GREEN,
    STILL_BLUE,
    STILL_AMBER,
    STILL_VIOLET,
    STILL_SILVER,
    STILL_GOLD,
    STILL_RED,
    STILL_YELLOW,
    STILL_WHITE,
    STILL_TURQUOISE,
    STILL_BLACK,
    STILL_VANE, /* in clear glass, VANES colours */
    STILL_VANES = 4,
    STILL_PAINTS = STILL_VANE + STILL_VANES
};

/* `triangles` and `frame` as of scene_marbles. */
int still_marbles(painted *p, uint64_t triangles, unsigned frame, fail *f);

/* Parts of it. The tray and the table below it. */
int still_tray(painted *p, fail *f);
/* Marble number `ball`, moved by three rows of four. */
int still_ball(painted *p, unsigned ball, const double matrix[12], fail *f);

#endif
