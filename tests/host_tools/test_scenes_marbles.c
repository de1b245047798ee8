/* test_scenes_marbles - the rolling marbles obey mechanics
 *
 * The tray and the balls are measured from the mesh alone where possible,
 * so that the mechanics and what is drawn cannot disagree.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/scenes/contacts.h"
#include "host_tools/scenes/marbles.h"
#include "host_tools/scenes/scenes.h"
#include "tests/test.h"

#define VERTICES 42u /* of the tray and of each ball */
#define FLOOR_RING 32u
#define BELOW 40u
#define MIDDLE 41u
#define FRAMES 600u

static void frame_of(mesh *m, unsigned triangles, unsigned frame) {
    fail f = {""};
    m->vertices = m->triangles = 0;
    CHECK(scene_marbles(m, triangles, frame, &f) == 0, "%s", f.text);
}

static void frame_mesh(mesh *m, unsigned frame) {
    frame_of(m, SCENE_MARBLES_MOST, frame);
}

static void point(const mesh *m, size_t vertex, double *p) {
    for (unsigned c = 0; c < 3; c++) {
        p[c] = (double)m->vertex[3 * vertex + c];
    }
}

static double dot(const double *a, const double *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void minus(const double *a, const double *b, double *out) {
    for (unsigned c = 0; c < 3; c++) {
        out[c] = a[c] - b[c];
    }
}

static void centre(const mesh *m, unsigned ball, double *out) {
    double p[3];
    out[0] = out[1] = out[2] = 0.0;
    for (unsigned i = 0; i < VERTICES; i++) {
        point(m, VERTICES * (ball + 1) + i, p);
        for (unsigned c = 0; c < 3; c++) {
            out[c] += p[c] / VERTICES;
        }
    }
}

/* Unit vector from the tray's underside to its floor, and the floor. */
static void tray_up(const mesh *m, double *up, double *middle) {
    double below[3];
    point(m, BELOW, below);
    point(m, MIDDLE, middle);
    minus(middle, below, up);
    const double length = sqrt(dot(up, up));
    for (unsigned c = 0; c < 3; c++) {
        up[c] /= length;
    }
}

/* How far the ball's centre is inside the wall `w` of the mesh. */
static double inside(const mesh *m, const double *ball, unsigned w) {
    double a[3], b[3], middle[3], half[3], to[3];
    point(m, FLOOR_RING + w, a);
    point(m, FLOOR_RING + (w + 1) % MARBLES_WALLS, b);
    point(m, MIDDLE, middle);
    for (unsigned c = 0; c < 3; c++) {
        half[c] = 0.5 * (a[c] + b[c]) - middle[c];
    }
    minus(ball, middle, to);
    const double length = sqrt(dot(half, half));
    return length - dot(to, half) / length;
}

/* How far from the sphere of radius 1 the ball's vertices are at worst. */
static double dent(const mesh *m, unsigned ball, const double *middle) {
    double worst = 0.0, p[3];
    for (unsigned i = 0; i < VERTICES; i++) {
        point(m, VERTICES * (ball + 1) + i, p);
        minus(p, middle, p);
        worst = fmax(worst, fabs(sqrt(dot(p, p)) - 1.0));
    }
    return worst;
}

static void check_frame(const mesh *m, double *deepest, double *outermost, double *lift) {
    static double at[MARBLES][3];
    double up[3], middle[3], to[3];
    tray_up(m, up, middle);
    for (unsigned i = 0; i + 1 < m->vertices / VERTICES; i++) {
        centre(m, i, at[i]);
        CHECK(dent(m, i, at[i]) < 1e-5, "marble %u is no ball", i);
        minus(at[i], middle, to);
        *lift = fmax(*lift, fabs(dot(to, up) - 1.0));
        for (unsigned w = 0; w < MARBLES_WALLS; w++) {
            *outermost = fmax(*outermost, 1.0 - inside(m, at[i], w));
        }
        for (unsigned j = 0; j < i; j++) {
            minus(at[i], at[j], to);
            *deepest = fmax(*deepest, 2.0 - sqrt(dot(to, to)));
        }
    }
}

static void check_positions(unsigned triangles) {
    mesh m = {0}, first = {0};
    double deepest = -1.0, outermost = -1.0, lift = 0.0;
    frame_of(&first, triangles, 0);
    CHECK(first.triangles == triangles, "%zu of %u triangles", first.triangles, triangles);
    for (unsigned k = 0; k <= FRAMES; k++) {
        frame_of(&m, triangles, k);
        check_frame(&m, &deepest, &outermost, &lift);
        CHECK(m.vertices == first.vertices && m.triangles == first.triangles &&
                  !memcmp(m.triangle, first.triangle, 12 * m.triangles),
              "frame %u has other triangles", k);
    }
    CHECK(deepest < MARBLES_OVERLAP, "%g in another", deepest);
    CHECK(deepest > 0.0, "they never touched");
    CHECK(outermost < MARBLES_OVERLAP, "%g in a wall", outermost);
    CHECK(outermost > 0.0, "they never met a wall");
    CHECK(lift < 1e-5, "%g off the floor", lift);
    mesh_free(&m);
    mesh_free(&first);
}

static void test_positions(void) {
    test("marbles: over 600 frames none leaves the tray, none is 1 % of a radius in another");
    check_positions(SCENE_MARBLES_MOST);
    test("... and so it is with 29 of them");
    check_positions(30 * 80);
}

static void test_any_frame(void) {
    mesh m[3] = {{0}, {0}, {0}};
    test("marbles: a frame is the same whichever was asked for before");
    frame_mesh(&m[0], 90);
    frame_mesh(&m[1], 91);
    frame_mesh(&m[1], 12);
    frame_mesh(&m[1], 90);
    frame_of(&m[2], 160, 91);
    frame_mesh(&m[2], 91);
    CHECK(!memcmp(m[0].vertex, m[1].vertex, 12 * m[0].vertices), "frame 90 differs");
    CHECK(memcmp(m[0].vertex, m[2].vertex, 12 * m[0].vertices), "frame 91 is frame 90");
    for (unsigned i = 0; i < 3; i++) {
        mesh_free(&m[i]);
    }
}

static void test_motion(void) {
    mesh before = {0}, after = {0};
    double a[3], b[3], path[MARBLES] = {0}, second = 0.0, fastest = 0.0;
    test("marbles: every one rolls 40 radii in 600 frames, together they are never at rest");
    frame_mesh(&before, 0);
    for (unsigned k = 1; k <= FRAMES; k++) {
        frame_mesh(&after, k);
        for (unsigned i = 0; i < MARBLES; i++) {
            centre(&before, i, a);
            centre(&after, i, b);
            minus(b, a, b);
            const double length = sqrt(dot(b, b));
            path[i] += length;
            second += length / MARBLES;
            fastest = fmax(fastest, length);
        }
        const mesh swap = before;
        before = after;
        after = swap;
        if (k % 25 == 0) {
            CHECK(second > 0.5, "second %u: %g radii on the average", k / 25, second);
            second = 0.0;
        }
    }
    for (unsigned i = 0; i < MARBLES; i++) {
        CHECK(path[i] > 40.0, "marble %u: %g radii", i, path[i]);
    }
    CHECK(fastest > 0.3 && fastest < 2.0, "the fastest went %g in a frame", fastest);
    mesh_free(&before);
    mesh_free(&after);
}

/* The highest point of a rolling ball goes in the direction of the ball, and
 * faster. */
static void test_tops(void) {
    mesh before = {0}, after = {0};
    unsigned long forward = 0, all = 0;
    test("marbles: seen in the mesh, tops run ahead of their balls");
    for (unsigned k = 0; k < FRAMES; k++) {
        frame_mesh(&before, k);
        frame_mesh(&after, k + 1);
        for (unsigned i = 0; i < MARBLES; i++) {
            double a[3], b[3], moved[3], p[3], q[3], top = 0.0;
            unsigned highest = 0;
            centre(&before, i, a);
            centre(&after, i, b);
            minus(b, a, moved);
            const double distance = sqrt(dot(moved, moved));
            if (distance < 0.1 || distance > 0.5) {
                continue;
            }
            for (unsigned v = 0; v < VERTICES; v++) {
                point(&before, VERTICES * (i + 1) + v, p);
                highest = v == 0 || p[1] > top ? v : highest;
                top = v == 0 || p[1] > top ? p[1] : top;
            }
            point(&before, VERTICES * (i + 1) + highest, p);
            point(&after, VERTICES * (i + 1) + highest, q);
            minus(q, p, q);
            all++;
            forward += dot(q, moved) > 1.3 * distance * distance;
        }
    }
    CHECK(all > 10000, "only %lu were looked at", all);
    CHECK(forward > all / 100 * 90, "%lu of %lu", forward, all);
    mesh_free(&before);
    mesh_free(&after);
}

/* The spin, in radians per second, that a step gave the ball. */
static void spin_between(const double *p, const double *q, double step, double *spin) {
    for (unsigned i = 0; i < 3; i++) { /* vector part of 2 q p^-1 */
        const unsigned j = (i + 1) % 3, k = (i + 2) % 3;
        spin[i] = 2.0 / step *
                  (q[i + 1] * p[0] - q[0] * p[i + 1] - q[j + 1] * p[k + 1] + q[k + 1] * p[j + 1]);
    }
}

static void test_rolling(void) {
    marbles m, next;
    const double step = 0.04 / MARBLES_STEPS;
    unsigned long rolling = 0, agreeing = 0, all = 0;
    test("marbles: nearly every fast one spins as its own motion makes it roll");
    marbles_start(&m, MARBLES);
    for (unsigned k = 0; k < FRAMES; k++) {
        marbles_frame(&m);
        next = m;
        marbles_step(&next);
        for (unsigned i = 0; i < MARBLES; i++) {
            const marble *a = &m.marble[i], *b = &next.marble[i];
            const double vx = (b->x - a->x) / step, vz = (b->z - a->z) / step;
            const double speed = sqrt(vx * vx + vz * vz);
            double spin[3];
            if (speed < 5.0) {
                continue;
            }
            spin_between(a->orientation, b->orientation, step, spin);
            const double x = vx + spin[2], z = vz - spin[0];
            all++;
            rolling += sqrt(x * x + z * z) < 0.1 * speed;
            agreeing += -vx * spin[2] + vz * spin[0] > 0.0;
        }
    }
    CHECK(all > 10000, "only %lu were fast", all);
    CHECK(rolling > all / 100 * 90, "%lu of %lu roll to within 10 %%", rolling, all);
    CHECK(agreeing > all / 1000 * 995, "%lu of %lu rotate in the right direction", agreeing, all);
}

static double energy(const marbles *m) {
    double sum = 0.0;
    for (unsigned i = 0; i < MARBLES; i++) {
        const marble *a = &m->marble[i];
        sum += 0.5 * (a->vx * a->vx + a->vz * a->vz) + 0.2 * dot(a->spin, a->spin);
        sum -= MARBLES_GRAVITY * (a->x * m->lean_x + a->z * m->lean_z);
    }
    return sum;
}

static void test_energy(void) {
    /* What it takes to push one of the 109 one radius up the steepest lean. */
    const double bound = MARBLES_GRAVITY * 0.07;
    marbles m, still;
    test(
        "marbles: the tray held still, energy never rises above its least by more than "
        "one marble takes for a radius uphill, and all but 2 % of the motion dies");
    marbles_start(&m, MARBLES);
    for (unsigned k = 1; k <= 400; k++) {
        marbles_frame(&m);
        if (k % 20) {
            continue;
        }
        still = m;
        double least = energy(&still), worst = 0.0;
        for (unsigned i = 0; i < 2000; i++) {
            marbles_step(&still);
            const double now = energy(&still);
            least = now < least ? now : least;
            worst = fmax(worst, now - least);
        }
        CHECK(worst < bound, "frame %u: %g more, %g allowed", k, worst, bound);
    }
    for (unsigned i = 0; i < 10000; i++) {
        marbles_step(&still);
    }
    double speed = 0.0;
    for (unsigned i = 0; i < MARBLES; i++) {
        speed += hypot(still.marble[i].vx, still.marble[i].vz) / MARBLES;
    }
    CHECK(speed < 0.02 * 12.0, "still at %g radii per second", speed);
}

/* At rest, 0.2 radii apart from each other, from the left. */
static void lay_out(marbles *m) {
    unsigned count = 0;
    for (int i = 0; i < 13 * 13 && count < MARBLES; i++) {
        const double x = 2.2 * (i / 13 - 6), z = 2.2 * (i % 13 - 6);
        int fits = 1;
        for (unsigned w = 0; w < MARBLES_WALLS; w++) {
            fits &= x * marbles_wall[w][0] + z * marbles_wall[w][1] < MARBLES_REACH;
        }
        if (fits) {
            m->marble[count++] = (marble){.x = x, .z = z, .orientation = {1.0}};
        }
    }
    CHECK(count == MARBLES, "only %u found a position", count);
}

static void test_slope(void) {
    marbles m = {.count = MARBLES};
    test("marbles: one that rolls freely gets 5/7 of gravity along the lean, less the resistance");
    lay_out(&m);
    m.lean_x = 0.05;
    for (unsigned i = 0; i < 100; i++) {
        marbles_step(&m);
    }
    const marble *first = &m.marble[0]; /* the wall it rolls to is far */
    const double expected = 0.2 * MARBLES_GRAVITY * (0.05 * 5.0 / 7.0 - 0.006);
    CHECK(fabs(first->vx - expected) < 0.01 * expected, "%g, not %g", first->vx, expected);
    CHECK(fabs(first->spin[2] + first->vx) < 1e-9, "it slides");
}

int main(void) {
    test_positions();
    test_any_frame();
    test_motion();
    test_tops();
    test_rolling();
    test_energy();
    test_slope();
    return test_done();
}
