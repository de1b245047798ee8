/* polygon_sweep - see polygon_sweep.h
 *
 * A vertical line goes over the corners from left to right, at equal x from the
 * lowest up. Between an edge with the inside above it and the next edge there is
 * a gap; left of the line, what is not yet covered of it is bounded by a chain that
 * bulges to the right. A corner makes triangles with all of the chain it can see.
 * Edges are tested when they become neighbours: two that meet are neighbours
 * before they do, or have a corner in one point.
 * Sources: K. Mehlhorn and S. Hertel, "Fast Triangulation of Simple Polygons", 1983;
 * M. I. Shamos and D. Hoey, "Geometric Intersection Problems", 1976.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/polygon_sweep.h"

#include <math.h>
#include <stdlib.h>

#include "host_tools/base/heap.h"
#include "host_tools/mesh/orient2.h"

static uint32_t next_of(const polygon_sweep *s, uint32_t i) {
    return i + 1 < s->n ? i + 1 : 0;
}

static uint32_t before_of(const polygon_sweep *s, uint32_t i) {
    return i > 0 ? i - 1 : s->n - 1;
}

/* 1: the corners turn left, -1: right, 0: neither. */
static int turn(const polygon_sweep *s, uint32_t a, uint32_t b, uint32_t c) {
    const double area = orient2(s->point[a], s->point[b], s->point[c]);
    return (area > 0) - (area < 0);
}

static int is_left_of(const polygon_sweep *s, uint32_t a, uint32_t b) {
    const double *p = s->point[a], *q = s->point[b];
    return p[0] < q[0] || (p[0] == q[0] && p[1] < q[1]);
}

static int has_inside_above(const polygon_sweep *s, uint32_t edge) {
    return is_left_of(s, edge, next_of(s, edge));
}

static int side(const void *context, uint32_t edge, uint32_t point) {
    const polygon_sweep *s = context;
    const int turns = turn(s, edge, next_of(s, edge), point);
    return has_inside_above(s, edge) ? turns : -turns;
}

/* Whether a b c clearly turns, beyond the noise. */
static int is_clear(const polygon_sweep *s, uint32_t a, uint32_t b, uint32_t c) {
    const double *p = s->point[a], *q = s->point[b], *r = s->point[c];
    return fabs(orient2(p, q, r)) > orient2_noise(s->noise, p, q, r);
}

/* Whether c and d lie on different sides of a b, clearly. */
static int is_between(const polygon_sweep *s, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    return turn(s, a, b, c) * turn(s, a, b, d) < 0 && is_clear(s, a, b, c) && is_clear(s, a, b, d);
}

/* Whether two edges may be neighbours: they do not meet, except in the corner between. */
static int can_be_neighbours(polygon_sweep *s, uint32_t e, uint32_t f) {
    if (e == ORDER_NONE || f == ORDER_NONE || next_of(s, e) == f || next_of(s, f) == e) {
        return 1;
    }
    const uint32_t e_end = next_of(s, e), f_end = next_of(s, f);
    s->crosses |= is_between(s, e, e_end, f, f_end) && is_between(s, f, f_end, e, e_end);
    return turn(s, e, e_end, f) * turn(s, e, e_end, f_end) > 0 ||
           turn(s, f, f_end, e) * turn(s, f, f_end, e_end) > 0;
}

static int fits(polygon_sweep *s, uint32_t edge) {
    return can_be_neighbours(s, s->edge[edge].below, edge) &&
           can_be_neighbours(s, edge, s->edge[edge].above);
}

/* ---- chains ------------------------------------------------------------ */

static uint32_t new_link(polygon_sweep *s, uint32_t corner) {
    s->link[s->links] = (sweep_link){corner, ORDER_NONE, ORDER_NONE};
    return s->links++;
}

static void join(polygon_sweep *s, uint32_t lower, uint32_t higher) {
    s->link[lower].higher = higher;
    s->link[higher].lower = lower;
}

/* An outline that is not simple may lead to more than there is room for. */
static void emit(polygon_sweep *s, uint32_t a, uint32_t b, uint32_t c) {
    if (s->triangles < s->n - 2) {
        uint32_t *to = s->to + 3 * (size_t)s->triangles;
        to[0] = a;
        to[1] = b;
        to[2] = c;
    }
    s->triangles++;
}

/* Makes triangles of v and the chain from `link` upwards; returns the last link seen. */
static uint32_t see_upwards(polygon_sweep *s, uint32_t v, uint32_t link) {
    for (uint32_t up = s->link[link].higher; up != ORDER_NONE; up = s->link[link].higher) {
        if (turn(s, s->link[link].corner, v, s->link[up].corner) <= 0) {
            break;
        }
        emit(s, s->link[link].corner, v, s->link[up].corner);
        link = up;
    }
    return link;
}

static uint32_t see_downwards(polygon_sweep *s, uint32_t v, uint32_t link) {
    for (uint32_t down = s->link[link].lower; down != ORDER_NONE; down = s->link[link].lower) {
        if (turn(s, v, s->link[link].corner, s->link[down].corner) <= 0) {
            break;
        }
        emit(s, v, s->link[link].corner, s->link[down].corner);
        link = down;
    }
    return link;
}

/* ---- corners; each returns 0 when the outline is not simple -------------- */

/* A tip of the inside in a gap that is inside already, or of the outside in none: the
 * outline overlaps, if only clearly so. */
static int overlap(polygon_sweep *s, uint32_t v, uint32_t below) {
    polygon_order_insert(&s->order, below, v);
    const uint32_t above = s->edge[v].above;
    s->crosses |= (below == ORDER_NONE || is_clear(s, below, next_of(s, below), v)) &&
                  (above == ORDER_NONE || is_clear(s, above, next_of(s, above), v)) &&
                  is_clear(s, before_of(s, v), v, next_of(s, v));
    return 0;
}

/* Both edges go to the right, and v is a tip of the inside. */
static int begin_gap(polygon_sweep *s, uint32_t v, uint32_t below) {
    if (below != ORDER_NONE && has_inside_above(s, below)) {
        return overlap(s, v, below);
    }
    const uint32_t link = new_link(s, v);
    s->gap[v] = (sweep_gap){link, link, link};
    polygon_order_insert(&s->order, below, v);
    polygon_order_insert(&s->order, v, before_of(s, v));
    return fits(s, v) && fits(s, before_of(s, v));
}

/* Both edges go to the right, with the outside between them. */
static int split_gap(polygon_sweep *s, uint32_t v, uint32_t below) {
    if (below == ORDER_NONE || !has_inside_above(s, below)) {
        return overlap(s, v, below);
    }
    const sweep_gap gap = s->gap[below];
    const uint32_t seen = gap.rightmost, twin = new_link(s, s->link[seen].corner);
    const uint32_t lower = new_link(s, v), higher = new_link(s, v);
    uint32_t top = gap.highest;
    if (s->link[seen].higher != ORDER_NONE) {
        join(s, twin, s->link[seen].higher);
    } else {
        top = twin;
    }
    s->link[seen].higher = ORDER_NONE;
    join(s, see_downwards(s, v, seen), lower);
    join(s, higher, see_upwards(s, v, twin));
    s->gap[below] = (sweep_gap){gap.lowest, lower, lower};
    s->gap[v] = (sweep_gap){higher, top, higher};
    polygon_order_insert(&s->order, below, before_of(s, v));
    polygon_order_insert(&s->order, before_of(s, v), v);
    return fits(s, v) && fits(s, before_of(s, v));
}

/* Both edges come from the left, and v is a tip of the inside. */
static int end_gap(polygon_sweep *s, uint32_t v) {
    const uint32_t lower = before_of(s, v), above = s->edge[v].above, below = s->edge[lower].below;
    if (s->edge[lower].above != v) {
        return 0;
    }
    const sweep_gap gap = s->gap[lower];
    polygon_order_remove(&s->order, lower);
    polygon_order_remove(&s->order, v);
    return see_upwards(s, v, gap.lowest) == gap.highest && can_be_neighbours(s, below, above);
}

/* Both edges come from the left, with the outside between them. */
static int merge_gaps(polygon_sweep *s, uint32_t v) {
    const uint32_t higher = before_of(s, v), above = s->edge[higher].above;
    const uint32_t below = s->edge[v].below;
    if (s->edge[v].above != higher || below == ORDER_NONE || !has_inside_above(s, below)) {
        return 0;
    }
    const sweep_gap low = s->gap[below], high = s->gap[higher];
    const uint32_t link = new_link(s, v);
    join(s, see_downwards(s, v, low.highest), link);
    join(s, link, see_upwards(s, v, high.lowest));
    s->gap[below] = (sweep_gap){low.lowest, high.highest, link};
    polygon_order_remove(&s->order, v);
    polygon_order_remove(&s->order, higher);
    return can_be_neighbours(s, below, above);
}

/* From the left to the right, with the inside above. */
static int go_on_below(polygon_sweep *s, uint32_t v) {
    const uint32_t old = before_of(s, v);
    const sweep_gap gap = s->gap[old];
    const uint32_t link = new_link(s, v);
    join(s, link, see_upwards(s, v, gap.lowest));
    s->gap[v] = (sweep_gap){link, gap.highest, link};
    polygon_order_replace(&s->order, old, v);
    return fits(s, v);
}

/* From the right to the left, with the inside below. */
static int go_on_above(polygon_sweep *s, uint32_t v) {
    const uint32_t below = s->edge[v].below, new = before_of(s, v);
    if (below == ORDER_NONE || !has_inside_above(s, below)) {
        return 0;
    }
    const sweep_gap gap = s->gap[below];
    const uint32_t link = new_link(s, v);
    join(s, see_downwards(s, v, gap.highest), link);
    s->gap[below] = (sweep_gap){gap.lowest, link, link};
    polygon_order_replace(&s->order, v, new);
    return fits(s, new);
}

static int pass(polygon_sweep *s, uint32_t v) {
    const uint32_t before = before_of(s, v), next = next_of(s, v);
    const int from_left = is_left_of(s, before, v), to_right = is_left_of(s, v, next);
    if (from_left && to_right) {
        return go_on_below(s, v);
    }
    if (!from_left && !to_right) {
        return go_on_above(s, v);
    }
    const int turns = turn(s, before, v, next);
    if (turns == 0) {
        return 0;
    }
    if (from_left) {
        return turns > 0 ? end_gap(s, v) : merge_gaps(s, v);
    }
    int is_on = 0;
    const uint32_t below = polygon_order_find(&s->order, side, s, v, &is_on);
    if (is_on) {
        return 0;
    }
    return turns > 0 ? begin_gap(s, v, below) : split_gap(s, v, below);
}

/* ---- the pass ---------------------------------------------------------- */

static int reserve(polygon_sweep *s, size_t n) {
    if (n <= s->room) {
        return 0;
    }
    const uint64_t work = s->work;
    polygon_sweep_free(s);
    s->work = work;
    if (n > SIZE_MAX / (2 * sizeof *s->event)) {
        return -1;
    }
    s->event = heap_get((uint64_t)n * sizeof *s->event);
    s->edge = heap_get((uint64_t)n * sizeof *s->edge);
    s->gap = heap_get((uint64_t)n * sizeof *s->gap);
    s->link = heap_get(2 * (uint64_t)n *
                       sizeof *s->link); /* 3 at a split, which begins 2 edges, else 1 */
    if (!s->event || !s->edge || !s->gap || !s->link) {
        polygon_sweep_free(s);
        return -1;
    }
    s->room = n;
    return 0;
}

void polygon_sweep_free(polygon_sweep *s) {
    heap_drop(s->event);
    heap_drop(s->edge);
    heap_drop(s->gap);
    heap_drop(s->link);
    *s = (polygon_sweep){0};
}

static int compare_events(const void *a, const void *b) {
    const sweep_event *e = a, *f = b;
    for (int k = 0; k < 2; k++) {
        if (e->at[k] != f->at[k]) {
            return e->at[k] < f->at[k] ? -1 : 1;
        }
    }
    return e->corner < f->corner ? -1 : e->corner > f->corner;
}

/* Puts the corners in order; 0 when two are in one point. */
static int sort_corners(polygon_sweep *s) {
    for (uint32_t i = 0; i < s->n; i++) {
        s->event[i] = (sweep_event){{s->point[i][0], s->point[i][1]}, i};
    }
    qsort(s->event, s->n, sizeof *s->event, compare_events);
    for (uint32_t i = 1; i < s->n; i++) {
        const double *p = s->event[i - 1].at, *q = s->event[i].at;
        if (p[0] == q[0] && p[1] == q[1]) {
            return 0;
        }
    }
    return 1;
}

int polygon_sweep_cut(polygon_sweep *s, const double (*point)[2], uint32_t n, double noise,
                      uint32_t *to) {
    if (reserve(s, n) != 0) {
        return SWEEP_NO_MEMORY;
    }
    s->point = point;
    s->n = n;
    s->noise = noise;
    s->crosses = 0;
    s->to = to;
    s->links = s->triangles = 0;
    s->order = (polygon_order){.edge = s->edge, .root = ORDER_NONE};
    int is_simple = sort_corners(s);
    for (uint32_t i = 0; i < n && is_simple; i++) {
        is_simple = pass(s, s->event[i].corner);
    }
    s->work += s->order.steps;
    if (is_simple && s->triangles == n - 2) {
        return SWEEP_FILLED;
    }
    return s->crosses ? SWEEP_CROSSES : SWEEP_TOUCHES;
}
