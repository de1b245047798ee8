/* polygon_ears - see polygon_ears.h
 *
 * A convex corner is an ear when the outline does not enter its triangle. If it
 * does, then its point furthest from the new edge is a corner that is not convex,
 * so only those are searched. An ear that is not one waits for the corner in its
 * way to be cut or to become convex.
 *
 * Outlines may touch themselves. Corners on the two old edges, or at the ear's
 * own tip, are in the way when the outline goes on inwards from there; corners on
 * the new edge never are. Cut like this, what is left never encloses a point a
 * negative number of times. What adds triangles without area is put off, except
 * at spikes and repeated corners, which leave no choice.
 * Source: G. H. Meisters, "Polygons Have Ears", 1975.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/polygon_ears.h"

#include "host_tools/base/heap.h"
#include "host_tools/mesh/orient2.h"

static const uint64_t WORK_MIN = 1u << 25, WORK_PER_CORNER = 160;
enum { WORK_OF_SIDES = 7 }; /* some, on which the corner exactly lies, take much longer */

/* What may be cut besides spikes; each phase begins when the one before is stuck. */
enum phase {
    CLEAN,    /* ears without a corner on the new edge; enough for simple outlines */
    TOUCHING, /* all ears */
    STRAIGHT, /* corners in the middle of a straight line, too */
    PHASES
};

/* Spikes go first: what has no width hides whether an ear beside it is one. */
enum queue { SPIKES, OTHERS };

enum kind { CONVEX, REFLEX, FLAT, SPIKE };

/* 1: left, -1: right, 0: neither, within the noise. */
static int turn(const polygon_ears *e, uint32_t a, uint32_t b, uint32_t c) {
    const double *p = e->point[a], *q = e->point[b], *r = e->point[c];
    const double area = orient2(p, q, r);
    const double tolerance = orient2_noise(e->noise, p, q, r);
    return (area > tolerance) - (area < -tolerance);
}

static enum kind kind_of(const polygon_ears *e, uint32_t b) {
    const uint32_t a = e->corner[b].before, c = e->corner[b].after;
    const int turns = turn(e, a, b, c);
    if (turns != 0) {
        return turns > 0 ? CONVEX : REFLEX;
    }
    const double *p = e->point[a], *q = e->point[b], *r = e->point[c];
    const double ahead = (q[0] - p[0]) * (r[0] - q[0]) + (q[1] - p[1]) * (r[1] - q[1]);
    return ahead > 0 ? FLAT : SPIKE;
}

static void enqueue(polygon_ears *e, uint32_t b, int queue) {
    if (e->corner[b].queued_after[queue] != b) {
        return;
    }
    e->corner[b].queued_after[queue] = POLYGON_NONE;
    if (e->queue_first[queue] == POLYGON_NONE) {
        e->queue_first[queue] = b;
    } else {
        e->corner[e->queue_last[queue]].queued_after[queue] = b;
    }
    e->queue_last[queue] = b;
}

static uint32_t dequeue(polygon_ears *e, int queue) {
    const uint32_t b = e->queue_first[queue];
    if (b != POLYGON_NONE) {
        e->queue_first[queue] = e->corner[b].queued_after[queue];
        e->corner[b].queued_after[queue] = b;
    }
    return b;
}

static void wait_for(polygon_ears *e, uint32_t b, uint32_t p) {
    ears_corner *waiter = &e->corner[b];
    waiter->waits_for = p;
    waiter->waiter_before = POLYGON_NONE;
    waiter->waiter_after = e->corner[p].waiter;
    if (waiter->waiter_after != POLYGON_NONE) {
        e->corner[waiter->waiter_after].waiter_before = b;
    }
    e->corner[p].waiter = b;
}

static void wait_no_more(polygon_ears *e, uint32_t b) {
    ears_corner *waiter = &e->corner[b];
    if (waiter->waits_for == POLYGON_NONE) {
        return;
    }
    if (waiter->waiter_before == POLYGON_NONE) {
        e->corner[waiter->waits_for].waiter = waiter->waiter_after;
    } else {
        e->corner[waiter->waiter_before].waiter_after = waiter->waiter_after;
    }
    if (waiter->waiter_after != POLYGON_NONE) {
        e->corner[waiter->waiter_after].waiter_before = waiter->waiter_before;
    }
    waiter->waits_for = POLYGON_NONE;
}

static void release_waiters(polygon_ears *e, uint32_t p) {
    while (e->corner[p].waiter != POLYGON_NONE) {
        const uint32_t b = e->corner[p].waiter;
        wait_no_more(e, b);
        enqueue(e, b, OTHERS);
    }
    e->corner[p].is_touched = 0;
}

/* A neighbour of `b` has changed. */
static void update(polygon_ears *e, uint32_t b) {
    const enum kind kind = kind_of(e, b);
    const int is_convex = kind == CONVEX;
    polygon_tree_mark(&e->tree, b, !is_convex);
    if (is_convex || e->corner[b].is_touched) {
        release_waiters(e, b);
    }
    enqueue(e, b, kind == SPIKE ? SPIKES : OTHERS);
}

static void emit(polygon_ears *e, uint32_t a, uint32_t b, uint32_t c) {
    if (e->to) {
        *e->to++ = a;
        *e->to++ = b;
        *e->to++ = c;
    }
}

static void cut(polygon_ears *e, uint32_t b) {
    ears_corner *tip = &e->corner[b];
    emit(e, tip->before, b, tip->after);
    tip->is_cut = 1;
    e->corner[tip->before].after = tip->after;
    e->corner[tip->after].before = tip->before;
    e->left--;
    e->some = tip->before;
    polygon_tree_mark(&e->tree, b, 0);
    release_waiters(e, b);
    update(e, tip->before);
    update(e, tip->after);
}

/* Whether p, which touches a b or b c or both, has a neighbour on the inner side of
 * what it touches. */
static int goes_inwards(const polygon_ears *e, uint32_t a, uint32_t b, uint32_t c, uint32_t p,
                        int is_left_of_ab, int is_left_of_bc) {
    const uint32_t neighbour[2] = {e->corner[p].before, e->corner[p].after};
    for (int k = 0; k < 2; k++) {
        if ((is_left_of_ab || turn(e, a, b, neighbour[k]) > 0) &&
            (is_left_of_bc || turn(e, b, c, neighbour[k]) > 0)) {
            return 1;
        }
    }
    return 0;
}

/* How often what is left of the outline winds around the middle of a triangle. */
static int winding_inside(polygon_ears *e, const uint32_t triangle[3]) {
    double middle[2] = {0, 0};
    for (int k = 0; k < 3; k++) {
        middle[0] += e->point[triangle[k]][0] / 3;
        middle[1] += e->point[triangle[k]][1] / 3;
    }
    int winding = 0;
    uint32_t at = e->some;
    for (uint32_t i = 0; i < e->left; i++) {
        const double *p = e->point[at], *q = e->point[e->corner[at].after];
        if (p[1] <= middle[1] && q[1] > middle[1]) {
            winding += orient2(p, q, middle) > 0;
        } else if (p[1] > middle[1] && q[1] <= middle[1]) {
            winding -= orient2(p, q, middle) < 0;
        }
        at = e->corner[at].after;
    }
    e->work += e->left / 4;
    return winding;
}

static int is_ahead(const polygon_ears *e, uint32_t from, uint32_t to, uint32_t x) {
    const double *p = e->point[from], *q = e->point[to], *r = e->point[x];
    return turn(e, from, to, x) == 0 &&
           (q[0] - p[0]) * (r[0] - p[0]) + (q[1] - p[1]) * (r[1] - p[1]) > 0;
}

/* Whether p, which touches b, is where the outline comes back from c to b to a. Between
 * there and back is either a cut without width into what is inside, and b is as good an
 * ear as any, or the bend of a passage without width. */
static int is_bend(polygon_ears *e, uint32_t a, uint32_t b, uint32_t c, uint32_t p) {
    return is_ahead(e, b, c, e->corner[p].before) && is_ahead(e, b, a, e->corner[p].after) &&
           winding_inside(e, (const uint32_t[]){a, b, c}) != 1;
}

/* Whether p forbids to cut b. */
static int is_in_the_way(polygon_ears *e, uint32_t b, uint32_t p) {
    const uint32_t a = e->corner[b].before, c = e->corner[b].after;
    if (p == a || p == b || p == c) {
        return 0;
    }
    const int above = turn(e, c, a, p);
    const int ab = above >= 0 ? turn(e, a, b, p) : -1;
    const int bc = ab >= 0 ? turn(e, b, c, p) : -1;
    if (above < 0 || ab < 0 || bc < 0) {
        return 0;
    }
    if (above == 0) {
        return e->phase == CLEAN && ab > 0 && bc > 0;
    }
    if (ab > 0 && bc > 0) {
        return 1;
    }
    const int inwards = goes_inwards(e, a, b, c, p, ab > 0, bc > 0) ||
                        (ab == 0 && bc == 0 && is_bend(e, a, b, c, p));
    e->corner[p].is_touched |= (uint8_t)inwards;
    return inwards;
}

static uint32_t find_in_the_way(polygon_ears *e, uint32_t b) {
    const uint32_t a = e->corner[b].before, c = e->corner[b].after;
    tree_search s =
        polygon_tree_search(&e->tree, e->point[a], e->point[b], e->point[c], 4 * e->noise);
    uint32_t p = polygon_tree_next(&s);
    while (p != POLYGON_NONE && !is_in_the_way(e, b, p)) {
        e->work += WORK_OF_SIDES;
        p = polygon_tree_next(&s);
    }
    e->work += s.visits;
    return p;
}

static void try_to_cut(polygon_ears *e, uint32_t b) {
    const enum kind kind = kind_of(e, b);
    e->work++;
    wait_no_more(e, b);
    if (kind == CONVEX) {
        const uint32_t p = find_in_the_way(e, b);
        if (p == POLYGON_NONE) {
            cut(e, b);
        } else {
            wait_for(e, b, p);
        }
    } else if (kind == SPIKE || (kind == FLAT && e->phase == STRAIGHT)) {
        cut(e, b);
    }
}

/* Tries one corner; 0 when none is left to try. */
static int try_next(polygon_ears *e) {
    const uint32_t spike = dequeue(e, SPIKES);
    if (spike != POLYGON_NONE) {
        e->work++;
        if (!e->corner[spike].is_cut && kind_of(e, spike) == SPIKE) {
            wait_no_more(e, spike);
            cut(e, spike);
        }
        return 1;
    }
    const uint32_t b = dequeue(e, OTHERS);
    if (b != POLYGON_NONE && !e->corner[b].is_cut) {
        try_to_cut(e, b);
    }
    return b != POLYGON_NONE;
}

static int reserve(polygon_ears *e, size_t n) {
    if (n <= e->room) {
        return 0;
    }
    heap_drop(e->corner);
    e->room = 0;
    e->corner =
        n <= SIZE_MAX / sizeof *e->corner ? heap_get((uint64_t)n * sizeof *e->corner) : NULL;
    if (!e->corner) {
        return -1;
    }
    e->room = n;
    return 0;
}

static int begin(polygon_ears *e, uint32_t n) {
    if (reserve(e, n) != 0 || polygon_tree_build(&e->tree, e->point, n) != 0) {
        return -1;
    }
    e->queue_first[SPIKES] = e->queue_first[OTHERS] = POLYGON_NONE;
    for (uint32_t i = 0; i < n; i++) {
        e->corner[i] = (ears_corner){.before = i > 0 ? i - 1 : n - 1,
                                     .after = i < n - 1 ? i + 1 : 0,
                                     .queued_after = {i, i},
                                     .waits_for = POLYGON_NONE,
                                     .waiter = POLYGON_NONE};
    }
    for (uint32_t i = 0; i < n; i++) {
        update(e, i);
    }
    return 0;
}

/* Tries all that are left again, with more allowed. */
static void begin_phase(polygon_ears *e, int phase) {
    e->phase = phase;
    uint32_t b = e->some;
    for (uint32_t i = 0; i < e->left; i++) {
        enqueue(e, b, OTHERS);
        b = e->corner[b].after;
    }
}

int polygon_ears_cut(polygon_ears *e, const double (*point)[2], uint32_t n, double noise,
                     uint32_t *to) {
    e->point = point;
    e->noise = noise;
    e->to = to;
    e->left = n;
    e->some = 0;
    e->phase = CLEAN;
    if (begin(e, n) != 0) {
        return EARS_NO_MEMORY;
    }
    e->corners += n;
    while (e->left > 3) {
        if (e->work > WORK_MIN + WORK_PER_CORNER * e->corners) {
            return EARS_GIVEN_UP;
        }
        if (!try_next(e)) {
            if (e->phase + 1 == PHASES) {
                return EARS_LEFT;
            }
            begin_phase(e, e->phase + 1);
        }
    }
    const uint32_t b = e->some, a = e->corner[b].before, c = e->corner[b].after;
    emit(e, a, b, c);
    return turn(e, a, b, c) >= 0 ? EARS_ALL_CUT : EARS_LEFT;
}

void polygon_ears_free(polygon_ears *e) {
    heap_drop(e->corner);
    polygon_tree_free(&e->tree);
    *e = (polygon_ears){0};
}
