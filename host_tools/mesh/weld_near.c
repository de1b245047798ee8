/* weld_near - see weld_near.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/weld_near.h"

#include <math.h>
#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/mesh/near_grid.h"
#include "host_tools/mesh/position.h"

static const double SUGGEST_MOST = 1e-4; /* of the longest side */
enum { SUGGEST_TRIES = 4 };              /* each a tenth of the one before */

static int is_collapsed(const mesh *m, size_t triangle) {
    int collapsed = 0;
    for (size_t k = 0; k < 3; k++) {
        const float *p = m->vertex + 3 * (size_t)m->triangle[3 * triangle + k];
        const float *q = m->vertex + 3 * (size_t)m->triangle[3 * triangle + (k + 1) % 3];
        collapsed |= positions_are_equal(p, q);
    }
    return collapsed;
}

typedef struct welding {
    size_t first, end; /* triangles */
    vertex_range range;
    uint32_t *to; /* by vertex of the range: where it goes; owned */
} welding;

/* Where each used vertex goes, in the order in which triangles use them. */
static void find_targets(welding *w, const mesh *m, near_grid *g, weld_near_result *result) {
    for (size_t i = 3 * w->first; i < 3 * w->end; i++) {
        const uint32_t v = m->triangle[i];
        uint32_t *to = &w->to[v - w->range.first];
        double far;
        if (*to == NEAR_GRID_NONE) {
            *to = near_grid_find(g, v, &far);
            result->moved += *to != NEAR_GRID_NONE && far > 0;
        }
        if (*to == NEAR_GRID_NONE) {
            *to = v;
            near_grid_add(g, v);
        }
    }
}

static void go(const welding *w, mesh *m, weld_near_result *result) {
    for (size_t i = w->first; i < w->end; i++) {
        const int before = is_collapsed(m, i);
        for (size_t k = 0; k < 3; k++) {
            m->triangle[3 * i + k] = w->to[m->triangle[3 * i + k] - w->range.first];
        }
        result->collapsed += (uint64_t)(!before && is_collapsed(m, i));
    }
}

int weld_near(mesh *m, size_t first, size_t end, double distance, weld_near_result *result) {
    near_grid g;
    welding w = {.first = first, .end = end, .range = mesh_vertices_of(m, first, end)};
    *result = (weld_near_result){0, 0};
    w.to = heap_get((uint64_t)w.range.count * sizeof *w.to);
    int status = near_grid_begin(&g, m->vertex, distance, w.range.count);
    if (w.to == NULL) {
        status = -1;
    }
    if (status == 0) {
        memset(w.to, 0xff, w.range.count * sizeof *w.to);
        find_targets(&w, m, &g, result);
        go(&w, m, result);
    }
    near_grid_free(&g);
    heap_drop(w.to);
    return status;
}

/* ---- a distance that helps ------------------------------------------------------------------ */

static double size_of(const mesh *m, size_t first, size_t end) {
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (size_t i = 3 * first; i < 3 * end; i++) {
        for (size_t axis = 0; axis < 3; axis++) {
            const double x = (double)m->vertex[3 * (size_t)m->triangle[i] + axis];
            low[axis] = fmin(low[axis], x);
            high[axis] = fmax(high[axis], x);
        }
    }
    return longest_side(low, high);
}

static int is_too_dense(const near_grid *g) {
    return g->steps > 256 * (uint64_t)g->points + 1000000;
}

/* The greatest distance from an open edge's end to the one nearest to it, of those within
 * `most`; 0 where ends lie so densely that this would take long. */
static int greatest_gap(const mesh *m, const open_edges *o, double most, double *gap) {
    near_grid g;
    *gap = 0;
    int status = near_grid_begin(&g, m->vertex, most, o->ends);
    for (size_t i = 0; i < o->ends && status == 0; i++) {
        near_grid_add(&g, o->end[i]);
    }
    for (size_t i = 0; i < g.points && status == 0 && !is_too_dense(&g); i++) {
        double far;
        if (near_grid_find(&g, g.point[i], &far) != NEAR_GRID_NONE) {
            *gap = fmax(*gap, far);
        }
    }
    *gap = is_too_dense(&g) ? 0 : *gap;
    near_grid_free(&g);
    return status;
}

/* To one digit, upwards. */
static double round_up(double x) {
    const double power = pow(10, floor(log10(x)));
    return ceil(x / power * (1 + 1e-9)) * power;
}

/* Open edges that stay when `distance` is welded, and what that does to triangles. */
static int try_distance(const mesh *m, size_t first, size_t end, double distance, uint64_t *left,
                        weld_near_result *result) {
    mesh copy = *m; /* the vertices are shared: they stay */
    open_edges o = {0, NULL, 0};
    copy.triangles = end - first;
    copy.triangle = heap_get(3 * (uint64_t)copy.triangles * sizeof *copy.triangle);
    if (copy.triangle == NULL) {
        return -1;
    }
    memcpy(copy.triangle, m->triangle + 3 * first, 3 * copy.triangles * sizeof *copy.triangle);
    int status = weld_near(&copy, 0, copy.triangles, distance, result);
    if (status == 0) {
        status = open_edges_find(&o, &copy, 0, copy.triangles);
    }
    *left = o.count;
    open_edges_free(&o);
    heap_drop(copy.triangle);
    return status;
}

uint64_t weld_near_bytes(uint64_t vertices) {
    return 4 * vertices + heap_cost(0) + near_grid_bytes(vertices);
}

/* The ends of all edges, and beside them: their grid, or a copy of the triangles that is welded
 * and looked at. */
uint64_t weld_near_suggest_bytes(uint64_t vertices, uint64_t triangles) {
    const uint64_t moving = weld_near_bytes(vertices);
    const uint64_t looking = open_edges_bytes(vertices, triangles) + 4 * vertices;
    return 4 * vertices + 12 * triangles + 3 * heap_cost(0) + (moving > looking ? moving : looking);
}

int weld_near_suggest(const mesh *m, size_t first, size_t end, const open_edges *o,
                      double *distance, uint64_t *left) {
    double gap = 0;
    const double most = SUGGEST_MOST * size_of(m, first, end);
    *distance = 0;
    *left = o->count;
    if (o->count == 0 || !(most > 0)) {
        return 0;
    }
    int status = greatest_gap(m, o, most, &gap);
    gap *= 3; /* corners that were one lie within some gaps of each other */
    for (int i = 0; i < SUGGEST_TRIES && gap > 0 && status == 0; i++, gap /= 10) {
        uint64_t stay = 0;
        weld_near_result result = {0, 0};
        status = try_distance(m, first, end, round_up(gap), &stay, &result);
        if (status == 0 && stay < o->count && result.collapsed == 0) {
            *distance = round_up(gap);
            *left = stay;
            return 0;
        }
    }
    return status;
}
