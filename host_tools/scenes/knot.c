/* knot - a closed tube along the trefoil, the (2, 3) torus knot
 *
 * Ring i has its centre on the knot at the parameter i / rings and lies in the
 * plane of the torus's normal and of that normal's cross product with the
 * tangent. These axes return to themselves once around, and the last ring meets
 * the first.
 * Invariant: every edge has exactly two triangles, one in each direction.
 *
 * Source: C. C. Adams, "The Knot Book", 1994, section 5.1 (torus knots).
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>

#include "host_tools/scenes/cos_sin.h"
#include "host_tools/scenes/counts.h"

#define AROUND_AXIS 2u /* times */
#define AROUND_TUBE 3u /* of the torus; times */
#define MAJOR 2.0
#define MINOR 0.9
#define TUBE 0.5
#define ASPECT 10u /* length of the knot / circumference of its own tube */

typedef struct ring_axes {
    double centre[3], normal[3], side[3];
} ring_axes;

static ring_axes axes_of(uint32_t ring, uint32_t rings) {
    const cos_sin u = cos_sin_of((uint64_t)AROUND_AXIS * ring, rings);
    const cos_sin v = cos_sin_of((uint64_t)AROUND_TUBE * ring, rings);
    const double reach = MAJOR + MINOR * v.cosine;
    const double along = AROUND_AXIS * reach, across = AROUND_TUBE * MINOR;
    const double speed = sqrt(along * along + across * across);
    const double a = along / speed, b = across / speed;
    /* tangent = a east + b north; side = normal x tangent = b east - a north */
    const double east[3] = {-u.sine, 0.0, u.cosine};
    const double north[3] = {-v.sine * u.cosine, v.cosine, -v.sine * u.sine};
    ring_axes k = {{reach * u.cosine, MINOR * v.sine, reach * u.sine},
                   {v.cosine * u.cosine, v.sine, v.cosine * u.sine},
                   {0.0, 0.0, 0.0}};
    for (unsigned c = 0; c < 3; c++) {
        k.side[c] = b * east[c] - a * north[c];
    }
    return k;
}

static int add_ring(mesh *m, uint32_t ring, uint32_t rings, uint32_t sides, fail *f) {
    const ring_axes k = axes_of(ring, rings);
    for (uint32_t j = 0; j < sides; j++) {
        const cos_sin w = cos_sin_of(j, sides);
        float p[3];
        for (unsigned c = 0; c < 3; c++) {
            p[c] = (float)(k.centre[c] + TUBE * (w.cosine * k.normal[c] + w.sine * k.side[c]));
        }
        if (mesh_add_vertex(m, p[0], p[1], p[2], f)) {
            return -1;
        }
    }
    return 0;
}

/* The triangles between ring `here` and ring `next`, by first vertex. */
static int add_band(mesh *m, uint32_t here, uint32_t next, uint32_t sides, fail *f) {
    for (uint32_t j = 0; j < sides; j++) {
        const uint32_t k = j + 1 < sides ? j + 1 : 0;
        if (mesh_add_triangle(m, here + j, next + j, next + k, f) ||
            mesh_add_triangle(m, here + j, next + k, here + k, f)) {
            return -1;
        }
    }
    return 0;
}

static int add(mesh *m, uint32_t first, uint32_t rings, uint32_t sides, fail *f) {
    for (uint32_t i = 0; i < rings; i++) {
        if (add_ring(m, i, rings, sides, f)) {
            return -1;
        }
    }
    for (uint32_t i = 0; i < rings; i++) {
        const uint32_t next = i + 1 < rings ? i + 1 : 0;
        if (add_band(m, first + i * sides, first + next * sides, sides, f)) {
            return -1;
        }
    }
    return 0;
}

int scene_knot(mesh *m, uint64_t triangles, fail *f) {
    const size_t vertices = m->vertices, before = m->triangles;
    if (count_check(m, "knot", triangles, 24, SCENE_TRIANGLES_MAX, f)) {
        return -1;
    }
    const uint32_t root = count_root(triangles / 2 / ASPECT), sides = root < 3 ? 3 : root;
    const uint32_t rings = (uint32_t)(triangles / 2 / sides);
    if (add(m, (uint32_t)vertices, rings, sides, f) == 0) {
        return 0;
    }
    m->vertices = vertices;
    m->triangles = before;
    return -1;
}
