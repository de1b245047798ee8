/* room_shelf - a shelf on the wall of -z with books of all sizes
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/room.h"

#define HALF 0.75 /* wide */
#define DEEP 0.32
#define BOARDS 6u
#define RISE 0.36 /* from board to board */
#define BOARD 0.014

static place shelf_place(void) {
    return place_at(-1.35, 0.0, -ROOM_Z + 0.5 * DEEP - ROOM_INTO);
}

static void add_case(room *r) {
    const place at = shelf_place();
    const double high = RISE * (BOARDS - 1) + 0.1, middle = 0.5 * high - ROOM_INTO;
    for (int side = -1; side <= 1; side += 2) {
        const place upright = place_moved(&at, side * (HALF + BOARD), middle, 0.0);
        solid_box(&r->s, &upright, BOARD, 0.5 * high, 0.5 * DEEP);
    }
    const place back = place_moved(&at, 0.0, middle, -0.5 * DEEP + 0.008);
    solid_box(&r->s, &back, HALF, 0.5 * high - 0.01, 0.006);
    for (unsigned i = 0; i < BOARDS; i++) {
        const place board = place_moved(&at, 0.0, 0.06 + RISE * i, 0.0);
        solid_box(&r->s, &board, HALF + 0.003, BOARD, 0.5 * DEEP - 0.004);
    }
}

typedef struct book {
    double thick, high, deep; /* half of them */
} book;

/* The back of a book bends outwards, in its own x and z. */
static void as_spine(const void *how, double p[3]) {
    const book *b = how;
    const double out = p[2] > 0.0 ? 0.35 * b->thick * (1.0 - p[0] * p[0]) : 0.0;
    p[0] *= b->thick - 0.0005;
    p[1] *= b->high - 0.001;
    p[2] = b->deep + 0.002 * p[2] + out;
}

/* Standing, with its back towards +z: pages, two covers, a spine. */
static void add_book(room *r, const place *middle, const book *b) {
    const unsigned cells[3] = {solid_divisions(&r->s, 4), 1, 1};
    const place pages = place_moved(middle, 0.0, 0.0, -0.002);
    solid_box(&r->s, &pages, b->thick - 0.0025, b->high - 0.005, b->deep - 0.003);
    for (int side = -1; side <= 1; side += 2) {
        const place cover = place_moved(middle, side * (b->thick - 0.0015), 0.0, 0.0);
        solid_box(&r->s, &cover, 0.0015, b->high, b->deep);
    }
    solid_block(&r->s, middle, cells, as_spine, b);
}

static book some_book(const room *r, uint32_t which) {
    return (book){0.009 + 0.018 * room_random(r, 20, which),
                  0.095 + 0.05 * room_random(r, 21, which),
                  0.075 + 0.04 * room_random(r, 22, which)};
}

/* From `x` to the right; the last of a row leans on the one before it. */
static double add_row(room *r, const place *board, double x, double end, uint32_t *which) {
    const unsigned most = 5 + (unsigned)(9.0 * room_random(r, 23, *which));
    for (unsigned i = 0; i < most; i++, ++*which) {
        const book b = some_book(r, *which);
        const int leans = i + 1 == most;
        if (x + 2.0 * b.thick + (leans ? 0.08 : 0.0) > end) {
            return end;
        }
        const place foot = place_moved(board, x, BOARD - 0.001, 0.1 - b.deep);
        const place on_edge = place_rotated(&foot, 2, leans ? 0.035 : 0.0);
        const place flush = place_moved(&on_edge, leans ? 0.055 : 0.0, leans ? -0.012 : 0.0, 0.0);
        const place middle = place_moved(&flush, b.thick, b.high, 0.0);
        add_book(r, &middle, &b);
        x += 2.0 * b.thick + 0.0015 + (leans ? 0.07 : 0.0);
    }
    return x;
}

/* Some books lying on each other, and a ball on them. */
static double add_pile(room *r, const place *board, double x, double end, uint32_t *which) {
    double y = BOARD - 0.001;
    if (x + 0.3 > end) {
        return end;
    }
    for (unsigned i = 0; i < 4; i++, ++*which) {
        const book b = some_book(r, *which);
        const place lying = place_moved(board, x + 0.15, y + b.thick, 0.02);
        const place on_side = place_rotated(&lying, 2, 0.25);
        const place turned = place_rotated(&on_side, 0, 0.02 * (room_random(r, 24, *which) - 0.5));
        add_book(r, &turned, &b);
        y += 2.0 * b.thick;
    }
    const place ball = place_moved(board, x + 0.15, y + 0.038, 0.0);
    solid_ball(&r->s, &ball, (double[]){0.04, 0.04, 0.04}, 6);
    return x + 0.31;
}

static void add_books(room *r) {
    const place at = shelf_place();
    uint32_t which = 0;
    for (unsigned i = 0; i + 1 < BOARDS; i++) {
        const place board = place_moved(&at, 0.0, 0.06 + RISE * i, 0.0);
        double x = -HALF + 0.004;
        while (x < HALF - 0.05) {
            x = add_row(r, &board, x, HALF - 0.004, &which);
            if (x < HALF - 0.05 && room_random(r, 25, which) < 0.4) {
                x = add_pile(r, &board, x, HALF - 0.004, &which);
            }
        }
    }
}

void room_shelf(room *r) {
    add_case(r);
    add_books(r);
}
