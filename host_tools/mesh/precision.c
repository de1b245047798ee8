/* precision - see precision.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/precision.h"

#include <math.h>

#include "host_tools/base/heap.h"
#include "host_tools/mesh/position.h"

typedef struct corner {
    double wide[3];  /* moved */
    float single[3]; /* and narrowed */
    double moved;    /* by narrowing */
} corner;

static int is_zero(const double v[3]) {
    return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

/* Above 0 unless `v` is 0: below 1e-140 squares would lose digits, then all. */
static double length(const double v[3]) {
    const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    return square > 1e-280 ? sqrt(square) : hypot(hypot(v[0], v[1]), v[2]);
}

/* A mesh that stays where it is keeps the floats of its file. */
static corner corner_of(const mesh *m, size_t vertex, const double origin[3]) {
    const int stays = is_zero(origin);
    corner c;
    double d[3];
    for (int axis = 0; axis < 3; axis++) {
        c.wide[axis] = mesh_wide(m, vertex, axis) - origin[axis];
        c.single[axis] = stays ? m->vertex[3 * vertex + (size_t)axis] : (float)c.wide[axis];
        d[axis] = (double)c.single[axis] - c.wide[axis];
    }
    c.moved = length(d);
    return c;
}

/* 1: the edge loses its length. */
enum { RELATIVE_MOST = 1000000 }; /* edges; beyond, the number says nothing more */

static int add_edge(precision *p, const corner *a, const corner *b) {
    double d[3];
    for (int axis = 0; axis < 3; axis++) {
        d[axis] = a->wide[axis] - b->wide[axis];
    }
    if (is_zero(d)) {
        return 0;
    }
    const double moved = fmax(a->moved, b->moved);
    p->moved = fmax(p->moved, moved);
    p->relative = fmax(p->relative, fmin(moved / length(d), RELATIVE_MOST));
    return positions_are_equal(a->single, b->single);
}

precision precision_of(const mesh *m, size_t first, size_t end, const double origin[3]) {
    precision p = {0, 0, 0};
    if (m->wide == NULL && is_zero(origin)) {
        return p; /* floats all the way */
    }
    for (size_t i = first; i < end; i++) {
        const uint32_t *t = m->triangle + 3 * i;
        const corner c[3] = {corner_of(m, t[0], origin), corner_of(m, t[1], origin),
                             corner_of(m, t[2], origin)};
        int loses = 0;
        for (int k = 0; k < 3; k++) {
            loses |= add_edge(&p, &c[k], &c[(k + 1) % 3]);
        }
        p.vanished += (uint64_t)loses;
    }
    return p;
}

void precision_centre(const mesh *m, double centre[3]) {
    for (int axis = 0; axis < 3; axis++) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (size_t i = 0; i < 3 * m->triangles; i++) {
            const double x = mesh_wide(m, m->triangle[i], axis);
            low = fmin(low, x);
            high = fmax(high, x);
        }
        centre[axis] = m->triangles > 0 ? low / 2 + high / 2 + 0.0 : 0;
    }
}

static void drop_wide(mesh *m) {
    heap_drop(m->wide);
    m->wide = NULL;
}

static int check_used(const mesh *m, const double origin[3], const char *path, fail *f) {
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        for (int axis = 0; axis < 3; axis++) {
            if (!coordinate_is_valid(mesh_wide(m, m->triangle[i], axis) - origin[axis])) {
                return fail_set(f, path,
                                "moved by --origin it reaches beyond +-2^40; use --centre");
            }
        }
    }
    return 0;
}

int precision_settle(mesh *m, const double origin[3], const char *path, fail *f) {
    if (!is_zero(origin)) {
        if (check_used(m, origin, path, f) != 0) {
            return -1;
        }
        for (size_t i = 0; i < m->vertices; i++) {
            for (int axis = 0; axis < 3; axis++) {
                const double x = mesh_wide(m, i, axis) - origin[axis];
                m->vertex[3 * i + (size_t)axis] = coordinate_is_valid(x) ? (float)x : 0.0f;
            }
        }
    }
    drop_wide(m);
    return 0;
}
