/* placement - rotates, scales and moves a mesh to its position in a scene
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/placement.h"

#include <math.h>

#include "host_tools/mesh/position.h"

typedef struct rotation {
    double cos_x, sin_x, cos_y, sin_y;
} rotation;

typedef struct box {
    double low[3], high[3];
} box;

/* Quarters of the circle are exact: a slab stays flat. */
static void cos_sin(double degrees, double *c, double *s) {
    static const double COS[] = {1, 0, -1, 0}, SIN[] = {0, 1, 0, -1};
    const double reduced = fmod(degrees, 360.0);
    const double quarters = reduced / 90.0;
    if (quarters == floor(quarters)) {
        const int quarter = (int)quarters & 3;
        *c = COS[quarter];
        *s = SIN[quarter];
        return;
    }
    const double radians = reduced * (3.14159265358979323846 / 180.0);
    *c = cos(radians);
    *s = sin(radians);
}

static void rotate(const rotation *r, const double from[3], double to[3]) {
    const double x = from[0], y = from[1], z = from[2];
    const double z_rotated = r->sin_x * y + r->cos_x * z;
    to[0] = r->cos_y * x + r->sin_y * z_rotated;
    to[1] = r->cos_x * y - r->sin_x * z;
    to[2] = r->cos_y * z_rotated - r->sin_y * x;
}

/* A vertex of the mesh to be placed. */
static void rotate_vertex(const rotation *r, const mesh *m, size_t vertex, int wide, double to[3]) {
    double from[3];
    for (int axis = 0; axis < 3; axis++) {
        from[axis] =
            wide ? mesh_wide(m, vertex, axis) : (double)m->vertex[3 * vertex + (size_t)axis];
    }
    rotate(r, from, to);
}

static box box_of(const rotation *r, const mesh *m, size_t first_triangle, int wide) {
    box b = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    for (size_t i = 3 * first_triangle; i < 3 * m->triangles; i++) {
        double p[3];
        rotate_vertex(r, m, m->triangle[i], wide, p);
        for (int axis = 0; axis < 3; axis++) {
            b.low[axis] = fmin(b.low[axis], p[axis]);
            b.high[axis] = fmax(b.high[axis], p[axis]);
        }
    }
    return b;
}

/* Normals turn with the mesh; how large it gets does not matter to them. */
static void turn_normals(const rotation *r, mesh_corners *c, size_t first, size_t end) {
    for (size_t i = 3 * first; i < 3 * end; i++) {
        double from[3], to[3];
        if (c->normal[i] != CORNER_NO_NORMAL) {
            corner_direction(c->normal[i], from);
            rotate(r, from, to);
            c->normal[i] = corner_normal(to);
        }
    }
}

int placement_apply(const placement *p, mesh *m, size_t first_vertex, size_t first_triangle,
                    int wide, const char *path, fail *f) {
    rotation r;
    cos_sin((double)p->angle_x, &r.cos_x, &r.sin_x);
    cos_sin((double)p->angle_y, &r.cos_y, &r.sin_y);
    if (m->triangles == first_triangle) {
        const size_t vertices = m->vertices - first_vertex;
        return fail_set(f, path, "%zu %s, no triangles: nothing to place; leave it out", vertices,
                        vertices == 1 ? "vertex" : "vertices");
    }
    const box b = box_of(&r, m, first_triangle, wide);
    const double longest = longest_side(b.low, b.high);
    if (!(longest > 0)) {
        return fail_set(f, path, "has no extent to scale; leave it out");
    }
    if (m->corners != NULL && m->corners->normal != NULL &&
        m->corners->triangles >= m->triangles) { /* the mesh has some */
        turn_normals(&r, m->corners, first_triangle, m->triangles);
    }
    if (wide && mesh_widen(m, f) != 0) { /* floats that were exact are so no more */
        return -1;
    }
    const double scale = (double)p->size / longest;
    const double centre[3] = {(b.low[0] + b.high[0]) / 2, b.low[1], (b.low[2] + b.high[2]) / 2};
    for (size_t i = first_vertex; i < m->vertices; i++) {
        float *v = m->vertex + 3 * i;
        double rotated[3];
        rotate_vertex(&r, m, i, wide, rotated);
        for (int axis = 0; axis < 3; axis++) {
            const double moved = (rotated[axis] - centre[axis]) * scale + (double)p->base[axis];
            if (!coordinate_is_valid(moved)) {
                return fail_set(f, path, "its position is beyond +-2^40; choose smaller numbers");
            }
            v[axis] = (float)moved;
            if (m->wide != NULL) {
                m->wide[3 * i + (size_t)axis] = wide ? moved : (double)v[axis];
            }
        }
    }
    return 0;
}
