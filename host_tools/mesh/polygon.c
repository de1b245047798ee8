/* polygon - see polygon.h
 *
 * Simple outlines are swept. Those that touch themselves are cut into ears: with
 * exact signs first. What rounding to single precision has made
 * cross itself by a hair is cut a second time with signs that leave noise alone.
 *
 * Triangles that all turn left cover every point as often as the outline winds
 * around it, so never less than 0 times. The outline reversed, joined to a frame
 * around it, winds 1 time less around every point; when that can be cut too, the
 * outline winds around no point more than once, and nothing overlaps.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/polygon.h"

#include <math.h>
#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/mesh/orient2.h"
#include "host_tools/mesh/polygon_plane.h"

enum { FRAME = 6 }; /* points of the outside that the outline does not have */

static const double NOT_MEANT = 0x1p-9;   /* of the area; a dent deeper than that is one */
static const double MUCH_NOISE = 0x1p-7;  /* of a face's size: it says nothing any more */
static const double WIDE_NOISE = 0x1p-16; /* of a face's size: doubles have not more */

static void write_fan(uint32_t n, uint32_t *to) {
    for (uint32_t i = 1; i < n - 1; i++) {
        *to++ = 0;
        *to++ = i;
        *to++ = i + 1;
    }
}

/* 1: left, -1: right, 0: neither, within the noise. */
static int turn(const double a[2], const double b[2], const double c[2], double noise) {
    const double area = orient2(a, b, c), tolerance = orient2_noise(noise, a, b, c);
    return (area > tolerance) - (area < -tolerance);
}

static int is_apart(const double a[2], const double b[2], double noise) {
    return fabs(b[0] - a[0]) > 8 * noise || fabs(b[1] - a[1]) > 8 * noise;
}

/* Where b lies, looked at from corner 0 along the first edge. */
enum side { AHEAD, LEFT, BEHIND, RIGHT };

static enum side side_of(const double a[2], const double first[2], const double b[2],
                         double noise) {
    const int turns = turn(a, first, b, noise);
    if (turns != 0) {
        return turns > 0 ? LEFT : RIGHT;
    }
    const double along = (first[0] - a[0]) * (b[0] - a[0]) + (first[1] - a[1]) * (b[1] - a[1]);
    return along > 0 ? AHEAD : BEHIND;
}

/* Directions from corner 0, which turn left by one full turn at most. */
typedef struct sweep {
    const double *first, *last; /* corners that were clearly apart from corner 0 */
    enum side last_side, furthest;
    int has_area, is_round;
} sweep;

/* Whether it may go on to b. Where the outline has gone through corner 0, it is on to b
 * that it turns left from the last. */
static int sweeps_on(sweep *s, const double a[2], const double b[2], double noise) {
    if (!s->first) {
        *s = (sweep){.first = b, .last = b};
        return 1;
    }
    const enum side side = side_of(a, s->first, b, noise);
    if (side <= s->last_side && turn(a, s->last, b, noise) < 0 &&
        !(side == AHEAD && s->last_side == RIGHT)) {
        return 0;
    }
    s->has_area |= side == LEFT || side == RIGHT;
    s->is_round |= s->has_area && s->furthest >= BEHIND && side == AHEAD;
    if ((s->furthest == RIGHT && side == LEFT) || (s->is_round && side != AHEAD)) {
        return 0;
    }
    s->furthest = side > s->furthest ? side : s->furthest;
    s->last = b;
    s->last_side = side;
    return 1;
}

/* Whether no triangle of the fan turns right, and no two cover the same directions. */
static int is_fan(const double (*point)[2], uint32_t n, double noise) {
    sweep s = {.first = NULL};
    for (uint32_t i = 1; i < n; i++) {
        if (i + 1 < n && turn(point[0], point[i], point[i + 1], noise) < 0) {
            return 0;
        }
        if (is_apart(point[0], point[i], noise) && !sweeps_on(&s, point[0], point[i], noise)) {
            return 0;
        }
    }
    return 1;
}

/* Whether what the fan fills beside the outline is too little to be meant: far from the
 * origin, noise is as large as a notch may be. Or there is no area that could be meant. */
static int misses_little(const double (*point)[2], uint32_t n, double noise) {
    double right = 0, all = 0;
    for (uint32_t i = 1; i + 1 < n; i++) {
        const double area = orient2(point[0], point[i], point[i + 1]);
        right += area < 0 ? -area : 0;
        all += area;
    }
    const int has_no_area = fabs(all) <= 4 * noise && noise < MUCH_NOISE;
    return right <= NOT_MEANT * all || has_no_area;
}

/* What is convex but for rounding gives a fan, too. */
static int fills_by_fan(const double (*point)[2], uint32_t n, double noise) {
    return is_fan(point, n, 0) || (is_fan(point, n, noise) && misses_little(point, n, noise));
}

static int triangulate_quad(const double (*point)[2], double noise, uint32_t *to) {
    if (turn(point[1], point[2], point[3], noise) < 0 ||
        turn(point[3], point[0], point[1], noise) < 0) {
        write_fan(4, to);
        return POLYGON_OVERLAPS;
    }
    memcpy(to, (const uint32_t[]){1, 2, 3, 3, 0, 1}, 6 * sizeof *to);
    return POLYGON_FILLED;
}

static int reserve(polygon *p, uint32_t n) {
    const size_t room = 2 * (size_t)n + FRAME;
    if (room <= p->room) {
        return 0;
    }
    heap_drop(p->point);
    p->room = 0;
    p->point =
        room <= SIZE_MAX / sizeof *p->point ? heap_get((uint64_t)room * sizeof *p->point) : NULL;
    if (!p->point) {
        return -1;
    }
    p->room = room;
    return 0;
}

static int is_before(const double a[2], const double b[2]) {
    return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]);
}

static int is_same(const double a[2], const double b[2]) {
    return a[0] == b[0] && a[1] == b[1];
}

/* Among the corners furthest to the left, the one whose edge from before comes from the
 * highest: nothing of the outline is above that edge there. */
static uint32_t leftmost(const double (*point)[2], uint32_t n) {
    uint32_t least = 0;
    for (uint32_t i = 1; i < n; i++) {
        least = is_before(point[i], point[least]) ? i : least;
    }
    const double *at = point[least], *above = NULL;
    for (uint32_t i = 0; i < n; i++) {
        const double *before = point[i > 0 ? i - 1 : n - 1];
        if (is_same(point[i], at) && !is_same(before, at) &&
            (!above || orient2(at, above, before) > 0)) {
            above = before;
            least = i;
        }
    }
    return least;
}

/* A frame, a bridge to the outline, and that reversed: n + FRAME points. */
static void surround(const double (*point)[2], uint32_t n, double (*to)[2]) {
    double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY};
    for (uint32_t i = 0; i < n; i++) {
        for (int a = 0; a < 2; a++) {
            lo[a] = fmin(lo[a], point[i][a] - 0.5);
            hi[a] = fmax(hi[a], point[i][a] + 0.5);
        }
    }
    const double frame[5][2] = {
        {lo[0], lo[1]}, {hi[0], lo[1]}, {hi[0], hi[1]}, {lo[0], hi[1]}, {lo[0], lo[1]}};
    memcpy(to, frame, sizeof frame);
    uint32_t at = leftmost(point, n);
    for (uint32_t i = 5; i < n + FRAME; i++) {
        memcpy(to[i], point[at], sizeof to[i]);
        at = at > 0 ? at - 1 : n - 1;
    }
}

/* Exactly, and if that does not come out, within the noise. */
static int cut(polygon *p, const double (*point)[2], uint32_t n, double noise, uint32_t *to) {
    int result = polygon_ears_cut(&p->ears, point, n, 0, to);
    if (result == EARS_LEFT) {
        result = polygon_ears_cut(&p->ears, point, n, noise, to);
    }
    return result == EARS_GIVEN_UP ? EARS_LEFT : result;
}

/* Outlines that may touch themselves. */
static int cut_twice(polygon *p, uint32_t n, double noise, uint32_t *to) {
    double(*outside)[2] = p->point + n;
    const int result = cut(p, (const double(*)[2])p->point, n, noise, to);
    if (result != EARS_ALL_CUT) {
        return result;
    }
    surround((const double(*)[2])p->point, n, outside);
    return cut(p, (const double(*)[2])outside, n + FRAME, noise, NULL);
}

static int triangulate_many(polygon *p, uint32_t n, double noise, uint32_t *to) {
    int result = polygon_sweep_cut(&p->sweep, (const double(*)[2])p->point, n, noise, to);
    if (result == SWEEP_TOUCHES) {
        result = cut_twice(p, n, noise, to);
    }
    if (result > 0) {
        return POLYGON_FILLED;
    }
    write_fan(n, to);
    return result == 0 ? POLYGON_OVERLAPS : POLYGON_NO_MEMORY;
}

int polygon_triangulate(polygon *p, const double (*corner)[3], uint32_t n, uint32_t *to) {
    double few[4][2];
    if (n > 4 && reserve(p, n) != 0) {
        write_fan(n, to);
        return POLYGON_NO_MEMORY;
    }
    double(*own)[2] = n > 4 ? p->point : few;
    const double(*point)[2] = (const double(*)[2])own;
    double noise = n > 3 ? polygon_project(corner, n, own) : -1;
    noise = p->wide ? fmin(noise, WIDE_NOISE) : noise;
    if (noise < 0 || fills_by_fan(point, n, noise)) {
        write_fan(n, to);
        return POLYGON_FILLED;
    }
    return n > 4 ? triangulate_many(p, n, noise, to) : triangulate_quad(point, noise, to);
}

void polygon_free(polygon *p) {
    heap_drop(p->point);
    polygon_sweep_free(&p->sweep);
    polygon_ears_free(&p->ears);
    *p = (polygon){.wide = p->wide};
}
