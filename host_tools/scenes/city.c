/* city - people leave the lift of a skyscraper for all parts of a city
 *
 * The case that a refitted tree is worst at: in frame 0 the people stand so close that they are a
 * small part of any tree; then their boxes grow over the whole city. One in three
 * goes up to a roof, one stays in a street, one goes down to the subway.
 *
 * Source: Karrenberg 2007, section 6.2.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/noise.h"
#include "host_tools/scenes/scenes.h"
#include "host_tools/scenes/solids.h"

enum {
    SEED = 71,
    SIDE = 13, /* blocks of houses */
    ROW = 24,  /* people, ROW x ROW of them */
    PEOPLE = ROW * ROW,
    LIFT_FRAMES = 25, /* from the roof to the street */
    DETAIL = 32
};

#define PITCH 20.0 /* from block to block */
#define HOUSE 7.0  /* half of a house's side */
#define TOWER 72.0 /* height of the skyscraper in the middle */
#define SPACE 0.6  /* between people in the lift */
#define SPEED 3.0  /* that people walk per frame: minutes pass like seconds */
#define SUBWAY_Y (-6.0)
#define LIFT_Z PITCH /* in the square before the skyscraper */

typedef struct point {
    double x, y, z;
} point;

/* ---- houses ------------------------------------------------------------------------ */

/* Half sizes. */
static void stretch(const void *how, double p[3]) {
    const double *half = how;
    for (unsigned a = 0; a < 3; a++) {
        p[a] *= half[a];
    }
}

/* 0: the square. */
static double height_of(int column, int row) {
    const double chance = noise_unit((uint32_t)(column + SIDE), (uint32_t)(row + SIDE), SEED);
    const double height = 8.0 + 40.0 * chance * chance;
    return column != 0 || row < 0 || row > 1 ? height : row == 0 ? TOWER : 0.0;
}

static void add_houses(solids *s) {
    const unsigned cells[3] = {3, 6, 3};
    for (int row = -SIDE / 2; row <= SIDE / 2; row++) {
        for (int column = -SIDE / 2; column <= SIDE / 2; column++) {
            const double height = height_of(column, row);
            const double half[3] = {HOUSE, 0.5 * height, HOUSE};
            const place at = place_at(PITCH * column, half[1], PITCH * row);
            if (height > 0.0) {
                solid_block(s, &at, cells, stretch, half);
            }
        }
    }
}

static void add_ground(solids *s) {
    const unsigned cells[3] = {SIDE, 1, SIDE};
    const double half[3] = {0.5 * PITCH * SIDE, 0.25, 0.5 * PITCH * SIDE};
    const place at = place_at(0.0, -half[1], 0.0);
    solid_block(s, &at, cells, stretch, half);
}

/* ---- people ------------------------------------------------------------------------ */

/* From `from` towards `to` by what is left of the path, which is used up. */
static double go(double from, double to, double *left) {
    const double way = to > from ? to - from : from - to;
    const double part = way < *left ? way : *left;
    *left -= part;
    return to > from ? from + part : from - part;
}

/* The nearest of the streets between rows of houses. */
static double street_near(double x) {
    const int column = (int)(x / PITCH);
    return PITCH * (column + (x < 0.0 ? -0.5 : 0.5));
}

/* Each another place in a street, spread over the city. */
static point goal_of(unsigned person) {
    const double reach = 0.5 * PITCH * (SIDE - 2);
    point goal = {reach * (2.0 * (person % ROW) / (ROW - 1) - 1.0), 0.0,
                  reach * (2.0 * (person / ROW) / (ROW - 1) - 1.0)};
    goal.x = street_near(goal.x);
    if (person % 3 == 1) {
        goal.y = height_of((int)(goal.x / PITCH), (int)(goal.z / PITCH));
    } else if (person % 3 == 2) {
        goal.y = SUBWAY_Y;
    }
    return goal;
}

/* Down with the lift, out one after the other, along the streets, up or down last. */
static point where_is(unsigned person, unsigned frame) {
    const unsigned rides = frame < LIFT_FRAMES ? frame : LIFT_FRAMES;
    const unsigned leaves = LIFT_FRAMES + person / 32;
    const point goal = goal_of(person);
    point p = {SPACE * (person % ROW - 0.5 * (ROW - 1)),
               TOWER * (double)(LIFT_FRAMES - rides) / LIFT_FRAMES,
               LIFT_Z + SPACE * (person / ROW - 0.5 * (ROW - 1))};
    double left = frame > leaves ? SPEED * (frame - leaves) : 0.0;
    p.x = go(p.x, goal.x, &left);
    p.z = go(p.z, goal.z, &left);
    p.y = left > 0.0 ? go(p.y, goal.y, &left) : p.y;
    return p;
}

static void add_people(solids *s, unsigned frame) {
    static const double body[3] = {0.25, 0.7, 0.2}, head[3] = {0.15, 0.2, 0.15};
    for (unsigned i = 0; i < PEOPLE; i++) {
        const point p = where_is(i, frame);
        const place feet = place_at(p.x, p.y, p.z);
        const place chest = place_moved(&feet, 0.0, 0.72, 0.0);
        const place face = place_moved(&feet, 0.0, 1.62, 0.0);
        solid_box(s, &chest, body[0], body[1], body[2]);
        solid_box(s, &face, head[0], head[1], head[2]);
    }
}

int scene_city(mesh *m, unsigned frame, fail *f) {
    const size_t vertices = m->vertices, triangles = m->triangles;
    solids s = {.m = m, .detail = DETAIL, .f = f};
    add_ground(&s);
    add_houses(&s);
    add_people(&s, frame);
    if (s.wrong) {
        m->vertices = vertices;
        m->triangles = triangles;
        return -1;
    }
    return 0;
}
