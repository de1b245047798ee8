/* placement - turns, scales and moves a mesh onto its place in a scene
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/placement.h"

#include <math.h>

#include "engine/planelet_config.h"

typedef struct turn {
    double cos_x, sin_x, cos_y, sin_y;
} turn;

typedef struct box {
    double low[3], high[3];
} box;

/* Quarter turns are exact: a slab stays flat. */
static void cos_sin(double degrees, double *c, double *s) {
    static const double COS[] = {1, 0, -1, 0}, SIN[] = {0, 1, 0, -1};
    const double turned = fmod(degrees, 360.0);
    const double quarters = turned / 90.0;
    if (quarters == floor(quarters)) {
        const int quarter = (int)quarters & 3;
        *c = COS[quarter];
        *s = SIN[quarter];
        return;
    }
    const double radians = turned * (3.14159265358979323846 / 180.0);
    *c = cos(radians);
    *s = sin(radians);
}

static void turn_point(const turn *t, const float from[3], double to[3]) {
    const double x = (double)from[0], y = (double)from[1], z = (double)from[2];
    const double z_turned = t->sin_x * y + t->cos_x * z;
    to[0] = t->cos_y * x + t->sin_y * z_turned;
    to[1] = t->cos_x * y - t->sin_x * z;
    to[2] = t->cos_y * z_turned - t->sin_y * x;
}

static box box_of(const turn *t, const mesh *m, size_t first_triangle) {
    box b = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    for (size_t i = 3 * first_triangle; i < 3 * m->triangles; i++) {
        double p[3];
        turn_point(t, m->vertex + 3 * (size_t)m->triangle[i], p);
        for (int axis = 0; axis < 3; axis++) {
            b.low[axis] = fmin(b.low[axis], p[axis]);
            b.high[axis] = fmax(b.high[axis], p[axis]);
        }
    }
    return b;
}

static double longest_side(const box *b) {
    double longest = 0;
    for (int axis = 0; axis < 3; axis++) {
        longest = fmax(longest, b->high[axis] - b->low[axis]);
    }
    return longest;
}

/* False for NaN. */
static int within(double x) {
    return fabs(x) <= (double)PLT_COORD_MAX;
}

int placement_apply(const placement *p, mesh *m, size_t first_vertex, size_t first_triangle,
                    const char *path, fail *f) {
    turn t;
    cos_sin((double)p->turn_x, &t.cos_x, &t.sin_x);
    cos_sin((double)p->turn_y, &t.cos_y, &t.sin_y);
    const box b = box_of(&t, m, first_triangle);
    const double longest = longest_side(&b);
    if (!(longest > 0)) {
        return fail_set(f, path, "has no extent to scale; leave it out");
    }
    const double scale = (double)p->size / longest;
    const double centre[3] = {(b.low[0] + b.high[0]) / 2, b.low[1], (b.low[2] + b.high[2]) / 2};
    for (size_t i = first_vertex; i < m->vertices; i++) {
        float *v = m->vertex + 3 * i;
        double turned[3];
        turn_point(&t, v, turned);
        for (int axis = 0; axis < 3; axis++) {
            const double moved = (turned[axis] - centre[axis]) * scale + (double)p->base[axis];
            if (!within(moved)) {
                return fail_set(f, path, "its place is beyond +-2^40; choose smaller numbers");
            }
            v[axis] = (float)moved;
        }
    }
    return 0;
}
