/* test_scenes_still - the picture's marbles are where the mechanics has them, closed, and outside
 * in
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/scenes/scenes.h"
#include "host_tools/scenes/still.h"
#include "tests/test.h"

enum { BALL_VERTICES = 162, BALL_TRIANGLES = 320, FRAME = 60 };

static const double none[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

static double at(const mesh *m, uint32_t vertex, int axis) {
    return (double)m->vertex[3 * vertex + (uint32_t)axis];
}

/* Six times the volume of what some triangles enclose. */
static double volume(const mesh *m, size_t first, size_t count) {
    double sum = 0;
    for (size_t i = first; i < first + count; i++) {
        const uint32_t *t = m->triangle + 3 * i;
        double v[3][3];
        for (int k = 0; k < 9; k++) {
            v[k / 3][k % 3] = at(m, t[k / 3], k % 3);
        }
        sum += v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
               v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
               v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
    }
    return sum;
}

/* Each edge of a closed mesh is run through once in either direction. */
static unsigned open_edges(const mesh *m, size_t first, size_t count) {
    unsigned open = 0;
    for (size_t i = 3 * first; i < 3 * (first + count); i++) {
        const uint32_t a = m->triangle[i], b = m->triangle[i / 3 * 3 + (i + 1) % 3];
        unsigned back = 0;
        for (size_t j = 3 * first; j < 3 * (first + count); j++) {
            back += m->triangle[j] == b && m->triangle[j / 3 * 3 + (j + 1) % 3] == a;
        }
        open += back != 1;
    }
    return open;
}

static unsigned floor_of(size_t i) {
    return (unsigned)i;
}

static void balls(void) {
    unsigned seen[STILL_PAINTS] = {0}, vanes = 0;
    test("a ball is closed, of radius 1, its outside out; some of clear glass have vanes within");
    for (unsigned ball = 0; ball < 109; ball++) {
        painted p = {.paint = NULL};
        fail f = {""};
        CHECK(still_ball(&p, ball, none, &f) == 0, "%s", f.text);
        CHECK(p.filled == p.m.triangles && p.m.triangles >= BALL_TRIANGLES, "painted");
        for (uint32_t v = 0; v < p.m.vertices; v++) {
            const double x = at(&p.m, v, 0), y = at(&p.m, v, 1), z = at(&p.m, v, 2);
            const double r = sqrt(x * x + y * y + z * z);
            CHECK(v < BALL_VERTICES ? fabs(r - 1) < 1e-6 : r < 0.9, "%u: %g", floor_of(v), r);
        }
        if (ball == 0) {
            CHECK(open_edges(&p.m, 0, BALL_TRIANGLES) == 0, "closed");
        }
        const double whole = volume(&p.m, 0, BALL_TRIANGLES) / 6;
        CHECK(whole > 4.0 && whole < 4.18879, "%g", whole);
        seen[p.paint[0]]++;
        if (p.m.triangles > BALL_TRIANGLES) {
            CHECK(p.paint[0] == STILL_CLEAR && p.paint[BALL_TRIANGLES] >= STILL_VANE, "vanes");
            vanes++;
        }
        painted_free(&p);
    }
    for (unsigned i = STILL_CLEAR; i < STILL_VANE; i++) {
        CHECK(seen[i] >= 4, "of paint %u there are %u", i, seen[i]);
    }
    CHECK(vanes >= 8, "%u", vanes);
}

static void tray(void) {
    painted p = {.paint = NULL};
    fail f = {""};
    double area = 0;
    test("the floor's boards and gaps cover the octagon once, faces up");
    CHECK(still_tray(&p, &f) == 0 && p.filled == p.m.triangles, "%s", f.text);
    for (size_t i = 0; i < p.m.triangles; i++) {
        const uint32_t *t = p.m.triangle + 3 * i;
        const double ax = at(&p.m, t[1], 0) - at(&p.m, t[0], 0);
        const double az = at(&p.m, t[1], 2) - at(&p.m, t[0], 2);
        const double bx = at(&p.m, t[2], 0) - at(&p.m, t[0], 0);
        const double bz = at(&p.m, t[2], 2) - at(&p.m, t[0], 2);
        if (p.paint[i] >= STILL_GAP && p.paint[i] < STILL_RIM) {
            CHECK(az * bx - ax * bz >= 0, "triangle %u lies on its face", floor_of(i));
            area += (az * bx - ax * bz) / 2;
        }
    }
    const double due = 8 * (sqrt(2) - 1) * 15 * 15; /* an octagon whose sides are 15 away */
    CHECK(fabs(area - due) < 1e-3, "%g not %g", area, due);
    painted_free(&p);
}

static void positions(void) {
    static double matrix[SCENE_MARBLES_INSTANCES][12];
    painted p = {.paint = NULL};
    fail f = {""};
    test("marbles lie on the level floor, as far from each other as in the scene of that frame");
    CHECK(still_marbles(&p, SCENE_MARBLES_MOST, FRAME, &f) == 0, "%s", f.text);
    const unsigned bodies = scene_marbles_matrices(SCENE_MARBLES_MOST, FRAME, matrix);
    double last[3] = {0, 0, 0};
    unsigned ball = 0;
    for (size_t i = 0; i < p.m.triangles; i++) {
        if (p.paint[i] < STILL_CLEAR || p.paint[i] >= STILL_VANE ||
            i + BALL_TRIANGLES > p.m.triangles) {
            continue;
        }
        double middle[3] = {0, 0, 0}, apart = 0, due = 0;
        for (size_t k = 0; k < (size_t)3 * BALL_TRIANGLES; k++) {
            for (int a = 0; a < 3; a++) {
                middle[a] += at(&p.m, p.m.triangle[3 * i + k], a) / (3 * BALL_TRIANGLES);
            }
        }
        CHECK(fabs(middle[1] - 1) < 1e-3, "ball %u is at a height of %g", ball, middle[1]);
        ball++;
        for (int a = 0; a < 3; a++) {
            const double step = matrix[ball][4 * a + 3] - matrix[ball - 1][4 * a + 3];
            apart += (middle[a] - last[a]) * (middle[a] - last[a]);
            due += step * step;
            last[a] = middle[a];
        }
        CHECK(ball == 1 || fabs(apart - due) < 1e-2, "%u: %g not %g", ball, apart, due);
        i += BALL_TRIANGLES - 1;
    }
    CHECK(ball == 109 && bodies == 110, "%u balls", ball);
    painted_free(&p);
}

int main(void) {
    balls();
    tray();
    positions();
    return test_done();
}
