/* still_tray - the wooden tray of still.h, and the table
 *
 * An octagon, as that of tray.c: a floor of 17 rows of boards, and eight sides. Two of the rows'
 * borders go through corners of the octagon, so that the ends of a row are straight lines.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/marbles_state.h"
#include "host_tools/scenes/noise.h"
#include "host_tools/scenes/still.h"

#define FLOOR_REACH (MARBLES_REACH + 1.0)
#define DIAGONAL 1.4142135623730951 /* square root of 2 */
#define GAP 0.04
#define TABLE 90.0
enum { ROWS = 17, OUTER_ROWS = 5, STRIPES = 6, BOARDS = 3, RINGS = 5, CORNERS = 8, BANDS = 5 };

/* Half the octagon's width there. */
static double half_width(double z) {
    const double size = z < 0 ? -z : z, slanted = FLOOR_REACH * DIAGONAL - size;
    return slanted < FLOOR_REACH ? slanted : FLOOR_REACH;
}

/* Where row i begins. */
static double row_at(unsigned i) {
    const double inner = FLOOR_REACH * (DIAGONAL - 1.0);
    const double outer = (FLOOR_REACH - inner) / OUTER_ROWS;
    if (i <= OUTER_ROWS) {
        return -FLOOR_REACH + outer * i;
    }
    if (i >= ROWS - OUTER_ROWS) {
        return FLOOR_REACH - outer * (ROWS - i);
    }
    return -inner + 2.0 * inner / (ROWS - 2 * OUTER_ROWS) * (i - OUTER_ROWS);
}

static double smaller(double a, double b) {
    return a < b ? a : b;
}

static double larger(double a, double b) {
    return a > b ? a : b;
}

/* The part of the floor with z from `near` to `far` and x from `left` to `right`, as far as it is
 * in the octagon. */
static int add_floor(painted *p, double near, double far, double left, double right, unsigned paint,
                     fail *f) {
    const double a = half_width(near), b = half_width(far);
    const double x[4] = {larger(left, -a), larger(left, -b), smaller(right, b), smaller(right, a)};
    const double corner[4][3] = {{x[0], 0, near}, {x[1], 0, far}, {x[2], 0, far}, {x[3], 0, near}};
    return x[0] < x[3] && x[1] < x[2] ? painted_quad(p, corner, paint, f) : 0;
}

/* A board: its own brown, and stripes along it that are darker or lighter. */
static int add_board(painted *p, unsigned row, unsigned board, double left, double right, fail *f) {
    const double near = row_at(row) + GAP, width = row_at(row + 1) - near;
    const double own = 1.5 + 5.0 * noise_unit(row, board, 21);
    int wrong = 0;
    for (unsigned i = 0; i < STRIPES && !wrong; i++) {
        const double brown = own + 2.5 * noise_unit(row * BOARDS + board, i, 22);
        /* Of different widths: the grain of a board that is cut beside the heart. */
        const double from = width * (i + (i > 0 ? 0.5 * noise_unit(row, i, 23) : 0)) / STRIPES;
        const double to =
            width * (i + 1 + (i + 1 < STRIPES ? 0.5 * noise_unit(row, i + 1, 23) : 0)) / STRIPES;
        wrong = add_floor(p, near + from, near + to, left, right, STILL_BROWN + (unsigned)brown, f);
    }
    return wrong;
}

static int add_row(painted *p, unsigned row, fail *f) {
    /* Boards end where the row is as wide as anywhere: nearer than its narrow side. */
    const double narrow = smaller(half_width(row_at(row)), half_width(row_at(row + 1)));
    const double third = 2.0 * narrow / BOARDS;
    const double shift = third * (noise_unit(row, 0, 24) - 0.5);
    double left = -FLOOR_REACH;
    int wrong =
        add_floor(p, row_at(row), row_at(row) + GAP, -FLOOR_REACH, FLOOR_REACH, STILL_GAP, f);
    for (unsigned i = 0; i < BOARDS && !wrong; i++) {
        const double right = i + 1 < BOARDS ? -narrow + third * (i + 1) + shift : FLOOR_REACH;
        wrong = add_board(p, row, i, left, right - (i + 1 < BOARDS ? GAP : 0), f) ||
                (i + 1 < BOARDS && add_floor(p, row_at(row) + GAP, row_at(row + 1), right - GAP,
                                             right, STILL_GAP, f));
        left = right;
    }
    return wrong;
}

/* Height and distance of the sides, from below the tray over its edge to the floor; rows of bands
 * up to the next. */
static const double rings[RINGS][2] = {
    {-1.0, 16.0}, {1.2, 16.9}, {1.7, 16.5}, {1.7, FLOOR_REACH}, {0.0, FLOOR_REACH}};
static const unsigned bands[RINGS - 1] = {BANDS, 1, 3, BANDS - 1};

/* Corner `c` at that distance of the sides. */
static void set_corner(double to[3], unsigned c, double height, double out) {
    const double slope = DIAGONAL - 1.0; /* tangent of 1/16 of a circle */
    double x = out * (c & 1 ? slope : 1.0), z = out * (c & 1 ? 1.0 : slope);
    for (unsigned quarter = 0; quarter < c / 2; quarter++) {
        const double was = x;
        x = -z;
        z = was;
    }
    to[0] = x;
    to[1] = height;
    to[2] = z;
}

static int add_band(painted *p, unsigned side, unsigned ring, unsigned band, fail *f) {
    const double *a = rings[ring], *b = rings[ring + 1];
    double corner[4][3];
    const double from = (double)band / bands[ring], to = (double)(band + 1) / bands[ring];
    const double low[2] = {a[0] + from * (b[0] - a[0]), a[1] + from * (b[1] - a[1])};
    const double high[2] = {a[0] + to * (b[0] - a[0]), a[1] + to * (b[1] - a[1])};
    set_corner(corner[0], side, low[0], low[1]);
    set_corner(corner[1], side, high[0], high[1]);
    set_corner(corner[2], side + 1, high[0], high[1]);
    set_corner(corner[3], side + 1, low[0], low[1]);
    const double brown =
        2.0 * noise_unit(side, ring / 2, 25) + 3.5 * noise_unit(side * 8 + ring, band, 26);
    return painted_quad(p, corner, STILL_RIM + (unsigned)brown, f);
}

static int add_side(painted *p, unsigned side, fail *f) {
    int wrong = 0;
    for (unsigned ring = 0; ring + 1 < RINGS; ring++) {
        for (unsigned band = 0; band < bands[ring] && !wrong; band++) {
            wrong = add_band(p, side, ring, band, f);
        }
    }
    return wrong;
}

int still_tray(painted *p, fail *f) {
    static const double table[4][3] = {
        {-TABLE, -1, -TABLE}, {-TABLE, -1, TABLE}, {TABLE, -1, TABLE}, {TABLE, -1, -TABLE}};
    int wrong = painted_quad(p, table, STILL_TABLE, f);
    for (unsigned row = 0; row < ROWS && !wrong; row++) {
        wrong = add_row(p, row, f);
    }
    for (unsigned side = 0; side < CORNERS && !wrong; side++) {
        wrong = add_side(p, side, f);
    }
    return wrong ? -1 : 0;
}
