/* still_ball - the marbles of still.h
 *
 * A ball of scene_marbles_ball, each of whose triangles is cut in four, with corners on the sphere.
 * Vanes are three leaves about one axis, a sixth of the circle apart, each as two fans.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>

#include "host_tools/scenes/cos_sin.h"
#include "host_tools/scenes/noise.h"
#include "host_tools/scenes/scenes.h"
#include "host_tools/scenes/still.h"

enum { EDGES = 120, LEAF = 8, LEAVES = 3 };

/* Of the balls, in turns that lead nowhere. Clear ones with vanes are the last. */
static const uint8_t turns[] = {
    STILL_CLEAR,  STILL_RED,    STILL_VANE,      STILL_GREEN, STILL_WHITE, STILL_BLUE,
    STILL_AMBER,  STILL_SILVER, STILL_TURQUOISE, STILL_CLEAR, STILL_VANE,  STILL_YELLOW,
    STILL_VIOLET, STILL_GOLD,   STILL_VANE,      STILL_BLUE,  STILL_BLACK};

typedef struct cut {
    uint32_t low[EDGES], high[EDGES], middle[EDGES];
    unsigned count;
} cut;

static int add_vertex(mesh *m, const double matrix[12], const double at[3], fail *f) {
    double to[3];
    for (unsigned i = 0; i < 3; i++) {
        const double *row = matrix + 4 * i;
        to[i] = row[0] * at[0] + row[1] * at[1] + row[2] * at[2] + row[3];
    }
    return mesh_add_vertex(m, (float)to[0], (float)to[1], (float)to[2], f);
}

/* The vertex half way between two, which the unit ball then has; -1: out of memory. */
static int64_t middle_of(mesh *ball, cut *c, uint32_t a, uint32_t b, fail *f) {
    const uint32_t low = a < b ? a : b, high = a < b ? b : a;
    double v[3], length = 0;
    for (unsigned i = 0; i < c->count; i++) {
        if (c->low[i] == low && c->high[i] == high) {
            return c->middle[i];
        }
    }
    for (int i = 0; i < 3; i++) {
        v[i] = (double)ball->vertex[3 * low + i] + (double)ball->vertex[3 * high + i];
        length += v[i] * v[i];
    }
    length = sqrt(length);
    if (mesh_add_vertex(ball, (float)(v[0] / length), (float)(v[1] / length),
                        (float)(v[2] / length), f)) {
        return -1;
    }
    c->low[c->count] = low;
    c->high[c->count] = high;
    c->middle[c->count] = (uint32_t)ball->vertices - 1;
    return c->middle[c->count++];
}

/* Adds those that the ball's triangles are cut into; the ball gets their corners. */
static int cut_triangles(mesh *to, uint32_t first, mesh *ball, fail *f) {
    cut c = {.count = 0};
    for (size_t i = 0; i < ball->triangles; i++) {
        const uint32_t *t = ball->triangle + 3 * i;
        int64_t h[3];
        for (int k = 0; k < 3; k++) {
            h[k] = middle_of(ball, &c, t[k], t[(k + 1) % 3], f);
            if (h[k] < 0) {
                return -1;
            }
        }
        for (int k = 0; k < 3; k++) {
            if (mesh_add_triangle(to, first + t[k], first + (uint32_t)h[k],
                                  first + (uint32_t)h[(k + 2) % 3], f)) {
                return -1;
            }
        }
        if (mesh_add_triangle(to, first + (uint32_t)h[0], first + (uint32_t)h[1],
                              first + (uint32_t)h[2], f)) {
            return -1;
        }
    }
    return 0;
}

static int add_sphere(painted *p, const double matrix[12], unsigned paint, fail *f) {
    const uint32_t first = (uint32_t)p->m.vertices;
    mesh ball = {0};
    int wrong = scene_marbles_ball(&ball, f) || cut_triangles(&p->m, first, &ball, f);
    for (size_t i = 0; i < ball.vertices && !wrong; i++) {
        const float *v = ball.vertex + 3 * i;
        const double at[3] = {(double)v[0], (double)v[1], (double)v[2]};
        wrong = add_vertex(&p->m, matrix, at, f);
    }
    mesh_free(&ball);
    return wrong ? -1 : painted_are(p, paint, f);
}

/* A leaf in the plane of the axis, y, and `across`; it twists as it goes up. */
static int add_leaf(painted *p, const double matrix[12], unsigned leaf, unsigned paint, fail *f) {
    const uint32_t first = (uint32_t)p->m.vertices;
    int wrong = 0;
    for (unsigned i = 0; i <= LEAF && !wrong; i++) {
        const double up = 2.0 * i / LEAF - 1.0, wide = 0.34 * (1.0 - up * up);
        const cos_sin a = cos_sin_of(leaf * 2 * LEAF + i, 6 * LEAF); /* half a sixth: a twist */
        const double left[3] = {-wide * a.cosine, 0.72 * up, -wide * a.sine};
        const double right[3] = {wide * a.cosine, 0.72 * up, wide * a.sine};
        wrong = add_vertex(&p->m, matrix, left, f) || add_vertex(&p->m, matrix, right, f);
    }
    for (uint32_t i = 0; i < LEAF && !wrong; i++) {
        const uint32_t at = first + 2 * i;
        wrong = (i > 0 && mesh_add_triangle(&p->m, at, at + 1, at + 3, f)) ||
                (i + 1 < LEAF && mesh_add_triangle(&p->m, at, at + 3, at + 2, f));
    }
    return wrong ? -1 : painted_are(p, paint, f);
}

int still_ball(painted *p, unsigned ball, const double matrix[12], fail *f) {
    const unsigned paint = turns[(7 * ball + ball / 6) % sizeof turns];
    if (paint != STILL_VANE) {
        return add_sphere(p, matrix, paint, f);
    }
    const unsigned vane = STILL_VANE + (unsigned)(STILL_VANES * noise_unit(ball, 0, 27));
    int wrong = add_sphere(p, matrix, STILL_CLEAR, f);
    for (unsigned i = 0; i < LEAVES && !wrong; i++) {
        wrong = add_leaf(p, matrix, i, vane, f);
    }
    return wrong;
}
