/* lone_ray - see lone_ray.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/base/lone_ray.h"

#include <math.h>
#include <string.h>

#include "engine/trace/ray_bounds.h"

static int is_within(const float v[3], float limit) {
    return fabsf(v[0]) <= limit && fabsf(v[1]) <= limit && fabsf(v[2]) <= limit;
}

static float largest_of(const float v[3]) {
    return fmaxf(fmaxf(fabsf(v[0]), fabsf(v[1])), fabsf(v[2]));
}

static int is_valid(const plt_ray *ray) {
    return is_within(ray->org, PLT_COORD_MAX) && is_within(ray->dir, PLT_DIR_MOST) &&
           PLT_DIR_LEAST <= largest_of(ray->dir) && ray->tmin <= ray->tmax && 0.0f <= ray->tmax;
}

/* As packet_group.h has it: none is smaller than 2^-60 of the largest. */
static float reciprocal(float d, float tiny) {
    return 1.0f / (fabsf(d) < tiny ? (d < 0.0f ? -tiny : tiny) : d);
}

int lone_ray_set(lone_ray *r, const plt_box *scene, const plt_ray *ray) {
    if (!is_valid(ray)) {
        return 0;
    }
    plt_ray_origin_set(&r->origin, scene, ray->org);
    const float tiny = largest_of(ray->dir) * PLT_DIR_LEAST;
    for (int a = 0; a < 3; a++) {
        const float e =
            fmaxf(r->origin.reach * PLT_BOX_ERROR, fabsf(ray->org[a]) * PLT_ORIGIN_ERROR);
        const float up = ray->org[a] + 3.0f * e, down = ray->org[a] - 3.0f * e;
        r->dir[a] = ray->dir[a];
        r->rdir[a] = reciprocal(ray->dir[a], tiny);
        r->negative[a] = ray->dir[a] < 0.0f;
        r->early[a] = r->negative[a] ? down : up;
        r->late[a] = r->negative[a] ? up : down;
    }
    r->tmin = ray->tmin > 0.0f ? ray->tmin : 0.0f;
    r->tmax = ray->tmax;
    r->id = PLT_MISS;
    return 1;
}

int lone_ray_meet(lone_ray *r, const plt_record *triangle) {
    const uint32_t word = plt_get_u32(&triangle->word[9]), id = plt_primitive_id(word);
    float corner[3][3];
    plt_ray_hit hit;
    plt_record_corners(triangle, corner);
    if (!plt_triangle_ray(&r->origin, r->dir, (const float(*)[3])corner, r->tmax, id < r->id,
                          &hit) ||
        !(r->tmin <= hit.t)) {
        return 0;
    }
    r->hit = hit;
    r->tmax = hit.t;
    r->id = id;
    r->rotation = plt_primitive_rotation(word);
    return 1;
}

void lone_ray_store_miss(plt_hit *hit, int any) {
    *hit = (plt_hit){.triangle = any ? 0 : PLT_MISS};
}

void lone_ray_store(const lone_ray *r, plt_hit *hit, int any) {
    lone_ray_store_miss(hit, any);
    if (r->id != PLT_MISS && any) {
        hit->triangle = 1;
    } else if (r->id != PLT_MISS) {
        hit->triangle = r->id;
        hit->t = r->hit.t;
        plt_ray_hit_weights(&r->hit, r->rotation, &hit->u, &hit->v);
    }
}
