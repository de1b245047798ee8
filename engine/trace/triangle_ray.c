/* triangle_ray - see triangle_ray.h; triangle.c says why each step is as it is
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/triangle_ray.h"

#include <string.h>

#include "engine/lanes/unroll.h"
#include "engine/trace/exact.h"
#include "engine/trace/ray_bounds.h"
#include "engine/trace/triangle_seldom.h"

/* As in triangle.c: what is asked seldom stays apart. */
#ifdef __GNUC__
#define RARELY __attribute__((noinline)) static
#else
#define RARELY static
#endif

/* As f4_min and f4_max: of a NaN and a number the second one. */
static inline float least(float a, float b) {
    return a < b ? a : b;
}

static inline float most(float a, float b) {
    return a > b ? a : b;
}

static inline float size_of(float a) {
    return __builtin_fabsf(a);
}

void plt_ray_origin_set(plt_ray_origin *o, const plt_box *scene, const float org[3]) {
    float reach = PLT_REACH_LEAST;
    for (int a = 0; a < 3; a++) {
        reach = most(size_of(scene->lo[a] - org[a]), reach);
        reach = most(size_of(scene->hi[a] - org[a]), reach);
    }
    o->reach = reach * PLT_REACH_ROUNDING;
    for (int a = 0; a < 3; a++) {
        const float e = most(o->reach * PLT_BOX_ERROR, size_of(org[a]) * PLT_ORIGIN_ERROR);
        o->org[a] = org[a];
        o->up[a] = org[a] + e;
        o->down[a] = org[a] - e;
    }
}

/* A direction, as set_shear and set_reciprocals of packet_set.c have it. */
typedef struct direction {
    const float *dir;
    int x, y, z; /* axes: z is that of the largest component */
    float slope[2], largest;
} direction;

static inline int set_direction(direction *d, const float dir[3]) {
    const float x = size_of(dir[0]), y = size_of(dir[1]), z = size_of(dir[2]);
    d->dir = dir;
    d->z = y <= x && z <= x ? 0 : (z <= y ? 1 : 2);
    d->x = plt_axis_after[d->z];
    d->y = plt_axis_after[d->x];
    const float along = dir[d->z];
    d->largest = size_of(along);
    d->slope[0] = dir[d->x] / along;
    d->slope[1] = dir[d->y] / along;
    return d->largest >= PLT_DIR_LEAST;
}

static inline float cross(float ax, float ay, float bx, float by) {
    return ax * by - ay * bx;
}

/* A bound of six sheared coordinates, and of the error that goes with it: the sum takes fewer
 * instructions than the greatest. */
static inline float error_of(const plt_ray_origin *o, float extent) {
    return o->reach * ((32.0f * PLT_U) * extent + (128.0f * PLT_U * PLT_U) * o->reach);
}

static inline float extent_most(const plt_lone_edges *e) {
    float extent = 0.0f;
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        extent = most(most(size_of(e->x[c]), size_of(e->y[c])), extent);
    }
    return extent;
}

/* e->error is at least what it is in triangle.c. */
static inline void set_edges(plt_lone_edges *e, const plt_ray_origin *o, const direction *d,
                             const float corner[3][3]) {
    const float ox = o->org[d->x], oy = o->org[d->y], oz = o->org[d->z];
    float extent = 0.0f;
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        const float depth = corner[c][d->z] - oz;
        e->x[c] = (corner[c][d->x] - ox) - d->slope[0] * depth;
        e->y[c] = (corner[c][d->y] - oy) - d->slope[1] * depth;
        extent += size_of(e->x[c]) + size_of(e->y[c]);
    }
    e->weight[0] = cross(e->x[2], e->y[2], e->x[1], e->y[1]);
    e->weight[1] = cross(e->x[0], e->y[0], e->x[2], e->y[2]);
    e->weight[2] = cross(e->x[1], e->y[1], e->x[0], e->y[0]);
    e->error = error_of(o, extent) * 1.000001f;
}

static plt_lone_ray lone_ray(const plt_ray_origin *o, const direction *d) {
    const plt_lone_ray ray = {
        {o->org[0], o->org[1], o->org[2]}, {d->dir[0], d->dir[1], d->dir[2]}, o->reach, d->z};
    return ray;
}

enum side { BESIDE, CLOSE, INSIDE };

static inline enum side side_of(const float w[3], float error) {
    if (w[0] > error) {
        return w[1] > error && w[2] > error     ? INSIDE
               : w[1] < -error || w[2] < -error ? BESIDE
                                                : CLOSE;
    }
    if (w[0] < -error) {
        return w[1] < -error && w[2] < -error ? INSIDE
               : w[1] > error || w[2] > error ? BESIDE
                                              : CLOSE;
    }
    return (w[1] > error && w[2] < -error) || (w[1] < -error && w[2] > error) ? BESIDE : CLOSE;
}

/* An edge function is close to its error, or within: integers may decide. 0: a miss. Works the
 * direction and the edges out again, so that they need not be in memory for the others. */
RARELY int decide(const plt_ray_origin *o, const float dir[3], const float corner[3][3],
                  float weight[3]) {
    direction d;
    plt_lone_edges e;
    set_direction(&d, dir);
    set_edges(&e, o, &d, corner);
    e.error = error_of(o, extent_most(&e));
    const enum side side = side_of(e.weight, e.error);
    if (side != CLOSE) {
        return side == INSIDE;
    }
    const plt_lone_ray ray = lone_ray(o, &d);
    const enum plt_meeting how = plt_decide_meeting(&ray, corner, &e);
    if (how == PLT_MEETS_COARSELY) {
        plt_exact_weights(&ray, corner, weight);
    }
    return how != PLT_MISSES;
}

typedef struct interval {
    float enter, leave;
} interval;

/* Where the ray is between the planes of the triangle's own box on an axis. */
static interval slab_of(const plt_ray_origin *o, const float dir[3], const float corner[3][3],
                        int a) {
    const float p = corner[0][a], q = corner[1][a], r = corner[2][a], d = dir[a];
    const float lo = least(least(p, q), r), hi = most(most(p, q), r);
    const float tiny =
        most(most(size_of(dir[0]), size_of(dir[1])), size_of(dir[2])) * PLT_DIR_LEAST;
    const int negative = d < 0.0f;
    const float rdir = 1.0f / (size_of(d) < tiny ? (negative ? -tiny : tiny) : d);
    const float low = (lo - o->up[a]) * rdir, high = (hi - o->down[a]) * rdir;
    const interval i = {negative ? high : low, negative ? low : high};
    return i;
}

/* Where the ray is inside that box, as boxes.c would say. */
static interval own_box(const plt_ray_origin *o, const float dir[3], const float corner[3][3]) {
    const interval x = slab_of(o, dir, corner, 0), y = slab_of(o, dir, corner, 1),
                   z = slab_of(o, dir, corner, 2);
    const interval i = {most(most(x.enter, y.enter), z.enter),
                        least(least(x.leave, y.leave), z.leave)};
    return i;
}

/* Whether t is surely between that box's planes on an axis. */
RARELY int is_between(const plt_ray_origin *o, const float dir[3], const float corner[3][3], int a,
                      float t) {
    const interval i = slab_of(o, dir, corner, a);
    return i.enter < t && t < i.leave;
}

/* Whether t is inside the interval of own_box, where the clamp does nothing. So it is if the
 * point at t is in the box, as that is wider than its rounding (DESIGN.md, section 7.7). */
static inline int is_in_box(const plt_ray_origin *o, const float dir[3], const float corner[3][3],
                            float t) {
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const float at = o->org[a] + t * dir[a];
        const int in = corner[0][a] <= at ? corner[1][a] >= at || corner[2][a] >= at
                                          : corner[1][a] <= at || corner[2][a] <= at;
        if (!in && !is_between(o, dir, corner, a, t)) {
            return 0;
        }
    }
    return 1;
}

static inline float normal_along(const float normal[3], const direction *d) {
    return normal[d->z] + (normal[d->x] * d->slope[0] + normal[d->y] * d->slope[1]);
}

static inline float plane_distance(const plt_ray_origin *o, const direction *d,
                                   const float normal[3], const float p0[3], float along) {
    float numerator = 0.0f;
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        numerator = numerator + normal[a] * (p0[a] - o->org[a]);
    }
    return numerator / along / d->dir[d->z];
}

static inline int is_nearer(float t, float tmax, int wins_ties) {
    return 0.0f <= t && (t < tmax || (wins_ties && t == tmax));
}

/* n . dir may be mostly rounding, or n underflow: sets hit->normal and hit->t anew. Returns
 * whether t needs integers. */
static int is_open(const plt_ray_origin *o, const float dir[3], const float corner[3][3],
                   const interval *box, plt_ray_hit *hit) {
    direction d;
    float scaled[3];
    set_direction(&d, dir);
    const unsigned kind = plt_scale_normal(corner, hit->normal, scaled);
    const float along = normal_along(scaled, &d);
    if ((kind & PLT_NORMAL_IS_SMALL) != 0) {
        memcpy(hit->normal, scaled, sizeof scaled);
        hit->t = plane_distance(o, &d, scaled, corner[0], along);
    }
    return plt_distance_is_open(along, kind, box->enter, box->leave);
}

enum distance { NO_HIT, CLAMPED, EXACT };

/* hit->t where the plane's may not do: n . dir is little (`little`), or the point lies outside
 * the triangle's box. Integers are for hits alone: EXACT says that the edges were decided. */
RARELY enum distance decide_distance(const plt_ray_origin *o, const float dir[3],
                                     const float corner[3][3], int little, enum side side,
                                     float tmax, plt_ray_hit *hit) {
    enum distance how = CLAMPED;
    const interval box = own_box(o, dir, corner);
    if (!(box.enter <= box.leave && box.enter <= tmax && 0.0f <= box.leave)) {
        return NO_HIT; /* t would be in it */
    }
    if (little && is_open(o, dir, corner, &box, hit)) {
        if (side == CLOSE && !decide(o, dir, corner, hit->weight)) {
            return NO_HIT;
        }
        hit->t = plt_exact_distance(corner, o->org, dir);
        how = EXACT;
    }
    hit->t = least(most(hit->t, box.enter), box.leave);
    return how;
}

/* The normal, n . dir over dir[z], and what it must be below if n . dir is mostly rounding or
 * the triangle a sliver: that is plt_open_limit with the edges' own sizes. */
static inline float set_normal(const float c[3][3], const direction *d, float normal[3],
                               float *limit) {
    const float first[3] = {c[1][0] - c[0][0], c[1][1] - c[0][1], c[1][2] - c[0][2]};
    const float second[3] = {c[2][0] - c[0][0], c[2][1] - c[0][1], c[2][2] - c[0][2]};
    plt_cross(first, second, normal);
    const float f = size_of(first[0]) + size_of(first[1]) + size_of(first[2]);
    const float s = size_of(second[0]) + size_of(second[1]) + size_of(second[2]);
    *limit = 4.0f * PLT_SLIVER * f * s + 4.0f * PLT_NORMAL_LEAST;
    return normal_along(normal, d);
}

int plt_triangle_ray(const plt_ray_origin *o, const float dir[3], const float corner[3][3],
                     float tmax, int wins_ties, plt_ray_hit *hit) {
    direction d;
    plt_lone_edges e;
    float limit;
    if (!set_direction(&d, dir)) {
        return 0;
    }
    set_edges(&e, o, &d, corner);
    enum side side = side_of(e.weight, e.error);
    if (side == BESIDE) {
        return 0;
    }
    hit->weight[0] = e.weight[0];
    hit->weight[1] = e.weight[1];
    hit->weight[2] = e.weight[2];
    const float along = set_normal(corner, &d, hit->normal, &limit);
    const int little = size_of(along) < limit;
    hit->t = plane_distance(o, &d, hit->normal, corner[0], along);
    if (little || !is_in_box(o, dir, corner, hit->t)) {
        const enum distance how = decide_distance(o, dir, corner, little, side, tmax, hit);
        if (how == NO_HIT) {
            return 0;
        }
        side = how == EXACT ? INSIDE : side;
    }
    return is_nearer(hit->t, tmax, wins_ties) &&
           (side == INSIDE || decide(o, dir, corner, hit->weight));
}

void plt_ray_hit_weights(const plt_ray_hit *hit, uint32_t rotation, float *u, float *v) {
    const float *w = hit->weight, sum = (w[0] + w[1]) + w[2];
    const unsigned first = plt_axis_after[rotation], second = plt_axis_after[first];
    *u = least(most(w[first] / sum, 0.0f), 1.0f);
    *v = least(most(w[second] / sum, 0.0f), 1.0f);
}

void plt_hit_normal(const float corner[3][3], float normal[3]) {
    plt_triangle_normal(corner, normal);
    const float most_of = most(most(size_of(normal[0]), size_of(normal[1])), size_of(normal[2]));
    if (most_of < PLT_NORMAL_LEAST) {
        float scaled[3];
        plt_scale_normal(corner, normal, scaled);
        memcpy(normal, scaled, sizeof scaled);
    }
}
