/* triangle_ray - see triangle_ray.h; triangle.c says why each step is as it is
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/triangle_ray.h"

#include <string.h>

#include "engine/lanes/unroll.h"
#include "engine/trace/exact.h"
#include "engine/trace/ray_bounds.h"
#include "engine/trace/triangle_seldom.h"

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

/* A direction, as set_shear and set_reciprocals of packet.c have it. */
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

static inline void set_edges(plt_lone_edges *e, const plt_ray_origin *o, const direction *d,
                             const float corner[3][3]) {
    const float ox = o->org[d->x], oy = o->org[d->y], oz = o->org[d->z];
    float extent = 0.0f;
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        const float depth = corner[c][d->z] - oz;
        e->x[c] = (corner[c][d->x] - ox) - d->slope[0] * depth;
        e->y[c] = (corner[c][d->y] - oy) - d->slope[1] * depth;
        extent = most(most(size_of(e->x[c]), size_of(e->y[c])), extent);
    }
    e->weight[0] = cross(e->x[2], e->y[2], e->x[1], e->y[1]);
    e->weight[1] = cross(e->x[0], e->y[0], e->x[2], e->y[2]);
    e->weight[2] = cross(e->x[1], e->y[1], e->x[0], e->y[0]);
    e->error = o->reach * ((32.0f * PLT_U) * extent + (128.0f * PLT_U * PLT_U) * o->reach);
}

static plt_lone_ray lone_ray(const plt_ray_origin *o, const direction *d) {
    const plt_lone_ray ray = {
        {o->org[0], o->org[1], o->org[2]}, {d->dir[0], d->dir[1], d->dir[2]}, o->reach, d->z};
    return ray;
}

/* An edge function is within its error: integers decide. */
static int decide(const plt_ray_origin *o, const direction *d, const float corner[3][3],
                  plt_lone_edges *e) {
    const plt_lone_ray ray = lone_ray(o, d);
    const enum plt_meeting how = plt_decide_meeting(&ray, corner, e);
    if (how == PLT_MEETS_COARSELY) {
        plt_exact_weights(&ray, corner, e->weight);
    }
    return how != PLT_MISSES;
}

enum side { BESIDE, CLOSE, INSIDE };

static inline enum side side_of(const plt_lone_edges *e) {
    const float *w = e->weight, lo = least(least(w[0], w[1]), w[2]),
                hi = most(most(w[0], w[1]), w[2]);
    if (lo > e->error || hi < -e->error) {
        return INSIDE;
    }
    return lo < -e->error && hi > e->error ? BESIDE : CLOSE;
}

typedef struct interval {
    float enter, leave;
} interval;

/* Where the ray is inside the triangle's own box, as boxes.c would say. `longest`: a side of
 * that box, rounded. */
static inline interval own_box(const plt_ray_origin *o, const direction *d,
                               const float corner[3][3], float *longest) {
    const float tiny = d->largest * PLT_DIR_LEAST;
    float n[3], f[3], side = 0.0f;
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const float p = corner[0][a], q = corner[1][a], r = corner[2][a], dir = d->dir[a];
        const float lo = least(least(p, q), r), hi = most(most(p, q), r);
        side = most(hi - lo, side);
        if (dir < 0.0f) {
            const float rdir = 1.0f / (-dir < tiny ? -tiny : dir);
            n[a] = (hi - o->down[a]) * rdir;
            f[a] = (lo - o->up[a]) * rdir;
        } else {
            const float rdir = 1.0f / (dir < tiny ? tiny : dir);
            n[a] = (lo - o->up[a]) * rdir;
            f[a] = (hi - o->down[a]) * rdir;
        }
    }
    *longest = side;
    const interval i = {most(most(n[0], n[1]), n[2]), least(least(f[0], f[1]), f[2])};
    return i;
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

/* n . dir may be mostly rounding, or n underflow: sets hit->normal and hit->t anew. Returns
 * whether t needs integers. */
static int is_open(const plt_ray_origin *o, const direction *d, const float corner[3][3],
                   const interval *box, plt_ray_hit *hit) {
    float scaled[3];
    const unsigned kind = plt_scale_normal(corner, hit->normal, scaled);
    const float along = normal_along(scaled, d);
    if ((kind & PLT_NORMAL_IS_SMALL) != 0) {
        memcpy(hit->normal, scaled, sizeof scaled);
        hit->t = plane_distance(o, d, scaled, corner[0], along);
    }
    return plt_distance_is_open(along, kind, box->enter, box->leave);
}

static inline int is_nearer(float t, float tmax, int wins_ties) {
    return 0.0f <= t && (t < tmax || (wins_ties && t == tmax));
}

int plt_triangle_ray(const plt_ray_origin *o, const float dir[3], const float corner[3][3],
                     float tmax, int wins_ties, plt_ray_hit *hit) {
    direction d;
    plt_lone_edges e;
    float longest;
    if (!set_direction(&d, dir)) {
        return 0;
    }
    set_edges(&e, o, &d, corner);
    const enum side side = side_of(&e);
    if (side == BESIDE) {
        return 0;
    }
    const interval box = own_box(o, &d, corner, &longest);
    if (!(box.enter <= box.leave && box.enter <= tmax && 0.0f <= box.leave)) {
        return 0; /* t will be in it */
    }
    plt_triangle_normal(corner, hit->normal);
    const float along = normal_along(hit->normal, &d);
    int open = 0;
    hit->t = plane_distance(o, &d, hit->normal, corner[0], along);
    if (size_of(along) < plt_open_limit(longest)) {
        open = is_open(o, &d, corner, &box, hit);
    }
    hit->t = least(most(hit->t, box.enter), box.leave);
    if (!open && !is_nearer(hit->t, tmax, wins_ties)) {
        return 0;
    }
    if (side == CLOSE && !decide(o, &d, corner, &e)) {
        return 0;
    }
    memcpy(hit->weight, e.weight, sizeof hit->weight);
    if (open) {
        hit->t = least(most(plt_exact_distance(corner, o->org, dir), box.enter), box.leave);
        return is_nearer(hit->t, tmax, wins_ties);
    }
    return 1;
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
