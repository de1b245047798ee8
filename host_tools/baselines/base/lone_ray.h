/* lone_ray - a ray that is traced for itself: what it has found, and where it begins and ends
 *
 * A triangle's hit has the engine's bits (trace/triangle_ray.h), and of equal t the lower id stays.
 * So the order in which triangles come does not matter, only that none is left out that has a hit
 * no farther than the one found.
 *
 * That hit is reported at q = org + t dir, which is within 1.5 e of the triangle's own box on each
 * axis, e being how far the engine moves origins (DESIGN.md, 7.4 and 7.9). Distances to a plane are
 * therefore two: with the origin moved by 3 e towards the plane `early`, away from it `late`. For
 * every point x within 1.5 e of q on that axis: a plane that x has reached, or that the ray reaches
 * at x, has early <= t; one that x has not passed has t <= late. (Half of the 3 e is for x. The
 * rest, at least 24 u R and 6 u |org|, exceeds rounding: 3 u R in all of it, and u (|org| + 3 e) in
 * the moved origin.)
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_LONE_RAY_H
#define BASELINES_LONE_RAY_H

#include "engine/planelet.h"
#include "engine/trace/triangle_ray.h"
#include "engine/tree/record.h"

typedef struct lone_ray {
    plt_ray_origin origin;
    float dir[3], rdir[3];
    float early[3], late[3]; /* origins */
    int negative[3];         /* 1: dir is below 0 */
    float tmin, tmax;        /* tmax: of the hit, when there is one */
    uint32_t id, rotation;   /* PLT_MISS: none yet */
    plt_ray_hit hit;
} lone_ray;

/* 0: the ray hits nothing (planelet.h). `scene` is the box of all triangles, not empty. */
int lone_ray_set(lone_ray *r, const plt_box *scene, const plt_ray *ray);

/* Keeps the hit if it is the nearest so far; whether it is. */
int lone_ray_meet(lone_ray *r, const plt_record *triangle);

/* As plt_trace would say it. */
void lone_ray_store(const lone_ray *r, plt_hit *hit, int any);
void lone_ray_store_miss(plt_hit *hit, int any);

static inline float lone_ray_early(const lone_ray *r, int axis, float plane) {
    return (plane - r->early[axis]) * r->rdir[axis];
}

static inline float lone_ray_late(const lone_ray *r, int axis, float plane) {
    return (plane - r->late[axis]) * r->rdir[axis];
}

#endif
