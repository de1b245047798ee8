/* placed - an instance where its matrix puts it
 *
 * Rays are brought into the body's space by the inverse, as it was computed: that, and not the
 * matrix, is where triangles are. Boxes are such that a ray which meets one of them there passes
 * the box, tested as any other with origins that are moved by plt_placed_margin more (DESIGN.md,
 * section 5.7, has the proof).
 *
 * Source: Wald, Benthin, Slusallek, "Distributed interactive ray tracing of dynamic scenes", 2003
 * (move the boxes, transform the rays).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_INSTANCES_PLACED_H
#define PLT_INSTANCES_PLACED_H

#include "engine/base/box.h"
#include "engine/lanes/lanes.h"
#include "engine/planelet_config.h"

/* Rows of a matrix: three columns, then what is added. */
enum { PLT_MATRIX_FLOATS = 12 };

/* Sums of the sizes of a row's columns, and of that of the matrix times that of its inverse. */
#define PLT_MATRIX_SIZE_LEAST 9.5367431640625e-7f /* 2^-20 */
#define PLT_MATRIX_SIZE_MOST 1048576.0f           /* 2^20 */
#define PLT_MATRIX_SKEW_MOST 1024.0f

typedef struct plt_placed {
    float to_body[PLT_MATRIX_FLOATS];
    plt_box box; /* in the world */
    uint32_t body, first_id;
} plt_placed;

/* Where `matrix` puts a body of that box: its inverse and its box, and the largest of *spread and
 * its own. 0: it is not one: a number is none, out of range, or the matrix is too flat or too
 * skewed to be inverted. `to` is of no use then. */
int plt_placed_set(plt_placed *to, const float matrix[PLT_MATRIX_FLOATS], const plt_box *body,
                   float *spread);

/* How far origins are moved beyond what the boxes of any scene want, by a ray's reach and the size
 * of its origin's coordinate: 4 u of that, so that the sum does not round away. */
static inline f4 plt_placed_margin(float spread, f4 reach, f4 org) {
    const f4 least = f4_mul(f4_abs(org), f4_all(2.384185791015625e-7f));
    return f4_add(f4_mul(f4_all(spread), reach), least);
}

/* One order of operations, for every ray: columns from the left, then what is added. */
static inline f4 plt_placed_turned(const float row[4], const f4 v[3]) {
    return f4_add(f4_add(f4_mul(f4_all(row[0]), v[0]), f4_mul(f4_all(row[1]), v[1])),
                  f4_mul(f4_all(row[2]), v[2]));
}

static inline void plt_placed_ray(const plt_placed *p, const f4 org[3], const f4 dir[3],
                                  f4 org_there[3], f4 dir_there[3]) {
    for (int a = 0; a < 3; a++) {
        const float *row = &p->to_body[4 * a];
        org_there[a] = f4_add(plt_placed_turned(row, org), f4_all(row[3]));
        dir_there[a] = plt_placed_turned(row, dir);
    }
}

/* A normal of the body, in the world: times the transpose of the inverse. */
static inline void plt_placed_normal(const plt_placed *p, const f4 there[3], f4 normal[3]) {
    const float *m = p->to_body;
    for (int a = 0; a < 3; a++) {
        const float column[4] = {m[a], m[4 + a], m[8 + a], 0.0f};
        normal[a] = plt_placed_turned(column, there);
    }
}

#endif
