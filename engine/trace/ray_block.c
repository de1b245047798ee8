/* ray_block - see ray_block.h; what follows where edge functions do not rule a hit out
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/ray_block.h"

#include "engine/base/small_stack.h"
#include "engine/trace/exact.h"
#include "engine/trace/triangle_seldom.h"
#include "engine/tree/primitive_id.h"

/* Four triangles' planes, and where the ray meets them. */
typedef struct planes {
    float normal[3][4];
    f4 enter; /* into each triangle's own box */
    f4 along; /* n . dir over the largest component of dir */
    f4 distance;
} planes;

/* What planes say of a block, before edge functions do. */
typedef struct passing {
    planes p;
    f4 leave, t;
    unsigned candidates, open; /* lanes that may be hit; and whose distance needs integers */
} passing;

/* Each triangle's own box on one axis, its near and its far plane. */
static inline void own_planes(const plt_wave_ray *r, const plt_bvh4_block *b, int a, f4 *near,
                              f4 *far) {
    const f4 c0 = f4_load_16(b->corner[0][a]), c1 = f4_load_16(b->corner[1][a]),
             c2 = f4_load_16(b->corner[2][a]);
    const f4 lo = f4_min(f4_min(c0, c1), c2), hi = f4_max(f4_max(c0, c1), c2);
    const m4 negative = f4_lt(f4_load_16(r->rdir[a]), f4_zero());
    *near = f4_select(negative, hi, lo);
    *far = f4_select(negative, lo, hi);
}

/* Where the ray enters each triangle's own box, as boxes.c would say. */
PLT_APART_ON_SMALL_STACKS static f4 own_enter(const plt_wave_ray *r, const plt_bvh4_block *b) {
    f4 n[3], near, far;
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        own_planes(r, b, a, &near, &far);
        n[a] = f4_mul(f4_sub(near, f4_load_16(r->near_org[a])), f4_load_16(r->rdir[a]));
    }
    return f4_max(f4_max(n[0], n[1]), n[2]);
}

/* And where it leaves it. */
PLT_APART_ON_SMALL_STACKS static f4 own_leave(const plt_wave_ray *r, const plt_bvh4_block *b) {
    f4 f[3], near, far;
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        own_planes(r, b, a, &near, &far);
        f[a] = f4_mul(f4_sub(far, f4_load_16(r->far_org[a])), f4_load_16(r->rdir[a]));
    }
    return f4_min(f4_min(f[0], f[1]), f[2]);
}

/* The planes that the triangles lie in, with normals as plt_triangle_normal, and where the ray
 * meets them; but for `enter`. */
PLT_APART_ON_SMALL_STACKS static void set_planes(const plt_wave_ray *r, const plt_bvh4_block *b,
                                                 planes *p) {
    const unsigned x = r->at.axis[0] / 4u, y = r->at.axis[1] / 4u, z = r->at.axis[2] / 4u;
    f4 first[3], second[3], numerator = f4_zero();
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 c0 = f4_load_16(b->corner[0][a]);
        first[a] = f4_sub(f4_load_16(b->corner[1][a]), c0);
        second[a] = f4_sub(f4_load_16(b->corner[2][a]), c0);
    }
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const int i = plt_axis_after[a], k = plt_axis_after[i];
        const f4 normal = f4_sub(f4_mul(first[i], second[k]), f4_mul(first[k], second[i]));
        const f4 p0 = f4_sub(f4_load_16(b->corner[0][a]), f4_all(r->org[a]));
        numerator = f4_add(numerator, f4_mul(normal, p0));
        f4_store(p->normal[a], normal);
    }
    p->along =
        f4_add(f4_load(p->normal[z]), f4_add(f4_mul(f4_load(p->normal[x]), f4_all(r->slope[0])),
                                             f4_mul(f4_load(p->normal[y]), f4_all(r->slope[1]))));
    p->distance = f4_div(f4_div(numerator, p->along), f4_all(r->along));
}

/* n . dir over dir[z], of one of triangle.c's normals. */
static float along_one(const plt_wave_ray *r, const float normal[3]) {
    const unsigned x = r->at.axis[0] / 4u, y = r->at.axis[1] / 4u, z = r->at.axis[2] / 4u;
    return normal[z] + (normal[x] * r->slope[0] + normal[y] * r->slope[1]);
}

/* ---- lanes that single precision may not decide --------------------------------- */

static void corners_of(const plt_bvh4_block *b, unsigned lane, float corner[3][3]) {
    for (int c = 0; c < 3; c++) {
        for (int a = 0; a < 3; a++) {
            corner[c][a] = b->corner[c][a][lane];
        }
    }
}

static plt_lone_ray lone_ray(const plt_wave_ray *r, const plt_ray *ray) {
    const plt_lone_ray lone = {{ray->org[0], ray->org[1], ray->org[2]},
                               {ray->dir[0], ray->dir[1], ray->dir[2]},
                               r->reach,
                               r->at.axis[2] / 4};
    return lone;
}

/* t, from a scaled normal. */
static float scaled_distance(const plt_wave_ray *r, const float corner[3][3], const plt_ray *ray,
                             const float normal[3], float along) {
    float numerator = 0.0f;
    for (int a = 0; a < 3; a++) {
        numerator = numerator + normal[a] * (corner[0][a] - ray->org[a]);
    }
    return numerator / along / r->along;
}

static float clamped(float t, float enter, float leave) {
    t = t > enter ? t : enter;
    return t < leave ? t : leave;
}

/* Whether the distance of a lane needs integers; where products of the normal may underflow it
 * is computed anew, of a normal that is scaled. */
static int is_open(const plt_wave_ray *r, const plt_bvh4_block *b, const plt_ray *ray,
                   float normal[3], float enter, float leave, unsigned lane, float *t) {
    float corner[3][3], scaled[3];
    corners_of(b, lane, corner);
    const unsigned kind = plt_scale_normal(corner, normal, scaled);
    const float along = along_one(r, scaled);
    if ((kind & PLT_NORMAL_IS_SMALL) != 0) {
        *t = scaled_distance(r, corner, ray, scaled, along);
        memcpy(normal, scaled, sizeof scaled);
    }
    return plt_distance_is_open(along, kind, enter, leave) && enter <= r->tmax[0] &&
           r->tmin[0] <= leave;
}

/* Of `candidates`, those whose distance needs integers. */
static unsigned open_lanes(const plt_wave_ray *r, const plt_bvh4_block *b, const plt_ray *ray,
                           planes *p, f4 leaves, unsigned candidates) {
    float enter[4], leave[4], t[4];
    unsigned open = 0;
    f4_store(enter, p->enter);
    f4_store(leave, leaves);
    f4_store(t, p->distance);
    for (unsigned i = 0; i < 4; i++) {
        if (candidates >> i & 1u) {
            float normal[3] = {p->normal[0][i], p->normal[1][i], p->normal[2][i]};
            open |= (unsigned)is_open(r, b, ray, normal, enter[i], leave[i], i, &t[i]) << i;
            for (int a = 0; a < 3; a++) {
                p->normal[a][i] = normal[a];
            }
        }
    }
    p->distance = f4_load(t);
    return open;
}

/* ---- hits ------------------------------------------------------------------------ */

/* The four lanes, out of their registers. */
typedef struct lanes {
    float weight[3][4], x[3][4], y[3][4];
    float error[4], t[4], enter[4], leave[4];
} lanes;

static inline void set_lanes(lanes *l, const block_edges *e, f4 error, const passing *at) {
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        f4_store(l->weight[c], e->weight[c]);
        f4_store(l->x[c], e->x[c]);
        f4_store(l->y[c], e->y[c]);
    }
    f4_store(l->error, error);
    f4_store(l->t, at->t);
    f4_store(l->enter, at->p.enter);
    f4_store(l->leave, at->leave);
}

/* Bounds the errors of the edge functions. */
static f4 error_of(const plt_wave_ray *r, const block_edges *e) {
    const f4 reach = f4_all(r->reach);
    const f4 x = f4_max(f4_max(f4_abs(e->x[0]), f4_abs(e->x[1])), f4_abs(e->x[2]));
    const f4 y = f4_max(f4_max(f4_abs(e->y[0]), f4_abs(e->y[1])), f4_abs(e->y[2]));
    return f4_mul(reach, f4_add(f4_mul(f4_all(32.0f * PLT_U), f4_max(x, y)),
                                f4_mul(f4_all(128.0f * PLT_U * PLT_U), reach)));
}

static unsigned sure_lanes(const block_edges *e, f4 error) {
    const f4 least = f4_min(f4_min(e->weight[0], e->weight[1]), e->weight[2]);
    const f4 most = f4_max(f4_max(e->weight[0], e->weight[1]), e->weight[2]);
    return m4_mask(m4_or(f4_lt(error, least), f4_lt(most, f4_neg(error))));
}

/* Is a lane's triangle met? One that is too close to call gets other weights if its own are
 * too coarse for u and v. */
static int is_met(const plt_wave_ray *r, const plt_bvh4_block *b, const plt_ray *ray, lanes *l,
                  unsigned i) {
    const plt_lone_ray lone = lone_ray(r, ray);
    float corner[3][3];
    const plt_lone_edges e = {{l->weight[0][i], l->weight[1][i], l->weight[2][i]},
                              {l->x[0][i], l->x[1][i], l->x[2][i]},
                              {l->y[0][i], l->y[1][i], l->y[2][i]},
                              l->error[i]};
    corners_of(b, i, corner);
    const enum plt_meeting how = plt_decide_meeting(&lone, corner, &e);
    if (how == PLT_MEETS_COARSELY) {
        float weight[3];
        plt_exact_weights(&lone, corner, weight);
        for (int c = 0; c < 3; c++) {
            l->weight[c][i] = weight[c];
        }
    }
    return how != PLT_MISSES;
}

static void set_exact_distance(const plt_bvh4_block *b, const plt_ray *ray, lanes *l, unsigned i) {
    float corner[3][3];
    corners_of(b, i, corner);
    l->t[i] = clamped(plt_exact_distance(corner, ray->org, ray->dir), l->enter[i], l->leave[i]);
}

/* The triangle of the nearest hit so far, where hits go. */
static inline uint32_t *id_of(const plt_wave_job *job, uint32_t number) {
    return job->rays != NULL ? &job->hits[number].triangle
                             : &job->packet->rays[number / 4].id[number % 4];
}

/* For any hit there is no id, and tmax is -1 once there is one. */
static int is_nearer(const plt_wave_ray *r, const plt_wave_job *job, float t, uint32_t id) {
    return r->tmin[0] <= t &&
           (t < r->tmax[0] || (t == r->tmax[0] && (job->any || id < *id_of(job, r->number))));
}

static float weight_of(const lanes *l, unsigned corner, unsigned i, float sum) {
    const float w = l->weight[corner][i] / sum;
    const float above = w > 0.0f ? w : 0.0f;
    return above < 1.0f ? above : 1.0f;
}

/* Of a ray of the packet, what its group keeps of the nearest hit. */
static void record_in_group(const plt_wave_job *job, uint32_t number, const planes *p, unsigned i,
                            const plt_hit *hit) {
    plt_group_rays *g = &job->packet->rays[number / 4];
    const unsigned lane = number % 4;
    job->packet->slabs.group[number / 4].tmax[lane] = hit->t;
    g->id[lane] = hit->triangle;
#if PLT_WITH_HULLS
    if (!job->packet->surfaces) {
        g->u[lane] = hit->u;
        g->v[lane] = hit->v;
        return;
    }
#else
    g->u[lane] = hit->u;
    g->v[lane] = hit->v;
#endif
    for (int a = 0; a < 3; a++) {
        g->normal[a][lane] = p->normal[a][i];
    }
}

/* The hit goes to its place at once; of any hit only that there is one. */
static void record(plt_wave_ray *r, const lanes *l, unsigned i, uint32_t word,
                   const plt_wave_job *job, const planes *p) {
    const float sum = (l->weight[0][i] + l->weight[1][i]) + l->weight[2][i];
    const unsigned first = plt_axis_after[plt_primitive_rotation(word)];
    if (job->any) {
        f4_store(r->tmax, f4_all(-1.0f));
        *id_of(job, r->number) = 1;
        return;
    }
    f4_store(r->tmax, f4_all(l->t[i]));
    const plt_hit hit = {.t = l->t[i],
                         .u = weight_of(l, first, i, sum),
                         .v = weight_of(l, plt_axis_after[first], i, sum),
                         .triangle = plt_primitive_id(word)};
    if (job->rays != NULL) {
        job->hits[r->number] = hit;
    } else {
        record_in_group(job, r->number, p, i, &hit);
    }
}

/* Lanes that may be nearer than the hit so far: at the same distance the lower id decides. */
static unsigned nearer_lanes(const plt_wave_ray *r, f4 t) {
    return m4_mask(m4_and(f4_le(f4_load_16(r->tmin), t), f4_le(t, f4_load_16(r->tmax))));
}

/* Below the limit of its triangle's plt_open_limit. */
static unsigned low_lanes(const plt_bvh4_block *b, f4 along) {
    const f4 longest = f4_load_16(b->longest);
    const f4 limit = f4_add(f4_mul(f4_mul(f4_all(4.0f * PLT_SLIVER), longest), longest),
                            f4_all(4.0f * PLT_NORMAL_LEAST));
    return m4_mask(f4_lt(f4_abs(along), limit));
}

/* t is the distance clamped to its triangle's box: at most the greater of distance and enter, and
 * no less than enter. A NaN becomes `enter` by the rule of max. */
unsigned plt_block_may_be_nearer(const plt_wave_ray *r, const plt_bvh4_block *b) {
    planes p;
    p.enter = own_enter(r, b);
    set_planes(r, b, &p);
    const unsigned ahead = m4_mask(f4_le(f4_load_16(r->tmin), f4_max(p.distance, p.enter)));
    const unsigned above = m4_mask(f4_le(p.enter, f4_load_16(r->tmax)));
    return (ahead | low_lanes(b, p.along)) & above;
}

/* By its bit. */
static const uint8_t lane_of[9] = {0, 0, 1, 0, 2, 0, 0, 0, 3};

/* Of the candidates those that the ray meets: keeps the nearest. 0: there is none. */
static int keep_nearest(plt_wave_ray *r, const plt_bvh4_block *b, const plt_wave_job *job,
                        const planes *p, lanes *l, unsigned candidates, unsigned sure,
                        unsigned open) {
    const plt_ray ray = plt_wave_ray_get(job, r->number);
    int is_hit = 0;
    for (; candidates != 0; candidates &= candidates - 1) {
        const unsigned bit = candidates & (0u - candidates), i = lane_of[bit];
        if ((sure & bit) == 0 && !is_met(r, b, &ray, l, i)) {
            continue;
        }
        if ((open & bit) != 0) {
            set_exact_distance(b, &ray, l, i);
        }
        if (is_nearer(r, job, l->t[i], plt_primitive_id(b->word[i]))) {
            record(r, l, i, b->word[i], job, p);
            is_hit = 1;
        }
    }
    return is_hit;
}

/* Of lanes `may`. */
PLT_APART_ON_SMALL_STACKS static void pass_planes(const plt_wave_ray *r, const plt_bvh4_block *b,
                                                  const plt_wave_job *job, unsigned may,
                                                  passing *to) {
    to->p.enter = own_enter(r, b);
    set_planes(r, b, &to->p);
    to->leave = own_leave(r, b);
    to->open = 0;
    const unsigned inside = may & m4_mask(f4_le(to->p.enter, to->leave));
    const unsigned low = inside & low_lanes(b, to->p.along);
    if (low != 0) {
        const plt_ray ray = plt_wave_ray_get(job, r->number);
        to->open = open_lanes(r, b, &ray, &to->p, to->leave, low);
    }
    to->t = f4_min(f4_max(to->p.distance, to->p.enter), to->leave);
    to->candidates = inside & (nearer_lanes(r, to->t) | to->open);
}

/* Edge functions again, and how sure they are. Returns the lanes whose sign is. */
PLT_APART_ON_SMALL_STACKS static unsigned
edges_again(const plt_wave_ray *r, const plt_bvh4_block *b, const passing *at, lanes *l) {
    block_edges e;
    plt_block_edges(r, b, &e);
    const f4 error = error_of(r, &e);
    set_lanes(l, &e, error, at);
    return sure_lanes(&e, error);
}

/* Of the candidates those that the ray meets. */
PLT_APART_ON_SMALL_STACKS static int keep_candidates(plt_wave_ray *r, const plt_bvh4_block *b,
                                                     const plt_wave_job *job, const passing *at) {
    lanes l;
    const unsigned sure = edges_again(r, b, at, &l);
    return keep_nearest(r, b, job, &at->p, &l, at->candidates, sure, at->open);
}

int plt_block_hits(plt_wave_ray *r, const plt_bvh4_block *b, const plt_wave_job *job,
                   unsigned may) {
    passing at;
    pass_planes(r, b, job, may, &at);
    return at.candidates != 0 && keep_candidates(r, b, job, &at);
}
