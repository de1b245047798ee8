/* grid_single - single rays through a grid, cell by cell, which packets are compared with
 *
 * Any hit is the nearest: the plain test of Moeller and Trumbore, a mailbox, no packets, no lanes.
 * Its hits are not the engine's, bit for bit, but those of a fast traverser of single rays.
 *
 * Sources: Amanatides, Woo, "A fast voxel traversal algorithm for ray tracing", 1987; Moeller,
 * Trumbore, "Fast, minimum storage ray/triangle intersection", 1997.
 *
 * SPDX-License-Identifier: MIT */
#ifndef MEASURE_GRID_SINGLE_H
#define MEASURE_GRID_SINGLE_H

#include <math.h>

#include "engine/grid/grid.h"
#include "engine/tree/record.h"

typedef struct single {
    const plt_grid *grid; /* plain */
    const plt_record *records;
    uint32_t *mailbox;
    uint32_t stamp;
} single;

typedef struct single_hit {
    float t;
    uint32_t triangle;
} single_hit;

static inline void single_test(const plt_record *r, const plt_ray *ray, single_hit *hit) {
    float c[3][3], e1[3], e2[3], p[3], q[3], s[3];
    memcpy(c, r->word, sizeof c);
    for (int a = 0; a < 3; a++) {
        e1[a] = c[1][a] - c[0][a];
        e2[a] = c[2][a] - c[0][a];
        s[a] = ray->org[a] - c[0][a];
    }
    const float *d = ray->dir;
    p[0] = d[1] * e2[2] - d[2] * e2[1];
    p[1] = d[2] * e2[0] - d[0] * e2[2];
    p[2] = d[0] * e2[1] - d[1] * e2[0];
    const float det = e1[0] * p[0] + e1[1] * p[1] + e1[2] * p[2];
    if (det == 0.0f) {
        return;
    }
    const float inverse = 1.0f / det;
    const float u = (s[0] * p[0] + s[1] * p[1] + s[2] * p[2]) * inverse;
    if (u < 0.0f || u > 1.0f) {
        return;
    }
    q[0] = s[1] * e1[2] - s[2] * e1[1];
    q[1] = s[2] * e1[0] - s[0] * e1[2];
    q[2] = s[0] * e1[1] - s[1] * e1[0];
    const float v = (d[0] * q[0] + d[1] * q[1] + d[2] * q[2]) * inverse;
    if (v < 0.0f || u + v > 1.0f) {
        return;
    }
    const float t = (e2[0] * q[0] + e2[1] * q[1] + e2[2] * q[2]) * inverse;
    if (t >= ray->tmin && t < hit->t) {
        hit->t = t;
        hit->triangle = plt_primitive_id(r->word[9]);
    }
}

/* Where a ray is: its cell, where it leaves it along each axis, and what a cell adds to that. */
typedef struct single_way {
    int32_t cell[3], step[3], end[3];
    float leaves[3], adds[3];
} single_way;

/* 0: it passes the grid. */
static inline int single_enter(const plt_grid_level *l, const plt_ray *ray, single_way *w) {
    float enter = ray->tmin, leave = ray->tmax, rdir[3];
    for (int a = 0; a < 3; a++) {
        const float hi = l->lo[a] + (float)l->cells[a] * l->size[a];
        rdir[a] = 1.0f / ray->dir[a];
        const float t0 = (l->lo[a] - ray->org[a]) * rdir[a], t1 = (hi - ray->org[a]) * rdir[a];
        enter = fmaxf(enter, fminf(t0, t1));
        leave = fminf(leave, fmaxf(t0, t1));
    }
    if (!(enter <= leave)) {
        return 0;
    }
    for (int a = 0; a < 3; a++) {
        const float at = (ray->org[a] + enter * ray->dir[a] - l->lo[a]) * l->scale[a];
        const int32_t last = (int32_t)l->cells[a] - 1, cell = at > 0.0f ? (int32_t)at : 0;
        const int down = ray->dir[a] < 0.0f;
        w->cell[a] = cell < last ? cell : last;
        w->step[a] = down ? -1 : 1;
        w->end[a] = down ? -1 : last + 1;
        w->adds[a] = l->size[a] * fabsf(rdir[a]);
        w->leaves[a] =
            (l->lo[a] + (float)(w->cell[a] + !down) * l->size[a] - ray->org[a]) * rdir[a];
    }
    return 1;
}

static inline single_hit single_trace(single *s, const plt_ray *ray) {
    const plt_grid_level *l = &s->grid->top;
    single_hit hit = {ray->tmax, PLT_MISS};
    single_way w;
    if (!single_enter(l, ray, &w)) {
        return hit;
    }
    s->stamp++;
    for (;;) {
        const uint32_t cell = (uint32_t)w.cell[0] + (uint32_t)w.cell[1] * l->stride[1] +
                              (uint32_t)w.cell[2] * l->stride[2];
        for (uint32_t i = l->start[cell]; i < l->start[cell + 1]; i++) {
            const uint32_t index = l->reference[i];
            if (s->mailbox[index] != s->stamp) {
                s->mailbox[index] = s->stamp;
                single_test(&s->records[index], ray, &hit);
            }
        }
        const int a = w.leaves[0] < w.leaves[1] ? (w.leaves[0] < w.leaves[2] ? 0 : 2)
                                                : (w.leaves[1] < w.leaves[2] ? 1 : 2);
        if (hit.t <= w.leaves[a]) {
            return hit;
        }
        w.cell[a] += w.step[a];
        if (w.cell[a] == w.end[a]) {
            return hit;
        }
        w.leaves[a] += w.adds[a];
    }
}

#endif
