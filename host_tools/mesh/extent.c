/* extent - see extent.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/extent.h"

#include "host_tools/mesh/position.h"

static const float *corner(const mesh *m, size_t triangle, size_t k) {
    return m->vertex + 3 * (size_t)m->triangle[3 * triangle + k];
}

int mesh_has_area(const mesh *m, size_t triangle) {
    const float *p = corner(m, triangle, 0), *q = corner(m, triangle, 1),
                *r = corner(m, triangle, 2);
    double e[3], g[3];
    for (int a = 0; a < 3; a++) {
        e[a] = (double)q[a] - (double)p[a];
        g[a] = (double)r[a] - (double)p[a];
    }
    return e[1] * g[2] != e[2] * g[1] || e[2] * g[0] != e[0] * g[2] || e[0] * g[1] != e[1] * g[0];
}

static void add_corners(plt_box *b, const mesh *m, size_t triangle) {
    for (size_t k = 0; k < 3; k++) {
        plt_box_add_point(b, corner(m, triangle, k));
    }
}

plt_box mesh_box(const mesh *m) {
    plt_box b = plt_box_empty();
    for (size_t i = 0; i < m->triangles; i++) {
        add_corners(&b, m, i);
    }
    return b;
}

plt_box mesh_area_box(const mesh *m) {
    plt_box b = plt_box_empty();
    for (size_t i = 0; i < m->triangles; i++) {
        if (mesh_has_area(m, i)) {
            add_corners(&b, m, i);
        }
    }
    return b;
}

int mesh_counts(const mesh *m, const plt_box *box, size_t triangle) {
    const float *p = corner(m, triangle, 0), *q = corner(m, triangle, 1),
                *r = corner(m, triangle, 2);
    int inside = 1;
    for (int a = 0; a < 3; a++) {
        inside &= p[a] >= box->lo[a] && p[a] <= box->hi[a] && q[a] >= box->lo[a] &&
                  q[a] <= box->hi[a] && r[a] >= box->lo[a] && r[a] <= box->hi[a];
    }
    return inside && !positions_are_equal(p, q) && !positions_are_equal(q, r) &&
           !positions_are_equal(p, r);
}
