/* kd_stray - see kd_stray.h
 *
 * Source: Wald, Havran, "On building fast kd-trees for ray tracing, and on doing that in
 * O(N log N)", 2006 (perfect splits); Sutherland, Hodgman, "Reentrant polygon clipping", 1974.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/kd/kd_stray.h"

#include <math.h>

#include "engine/trace/ray_bounds.h"
#include "host_tools/base/heap.h"

/* Rays count as near up to so many times the scene's longest side. */
#define REACH 3.0f
/* Of triangles that lie nearly across an axis most of the box is plane: there is little to cut, and
 * strays would be many (a city's walls: 29 per triangle). */
#define ACROSS 0.99
/* 2^-6, and 2^-18 for 2^-19 times the root of 3. */
#define SLIVER 0.015625
#define OFF 3.814697265625e-6

/* ---- the scene -------------------------------------------------------------------- */

static void corners_of(const kd_scene *s, uint32_t triangle, double corner[3][3]) {
    for (int c = 0; c < 3; c++) {
        for (int a = 0; a < 3; a++) {
            corner[c][a] = (double)plt_record_float(&s->triangles->record[triangle], c, a);
        }
    }
}

static double length_of(const double v[3]) {
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static kd_plane plane_of(const kd_scene *s, uint32_t triangle) {
    double p[3][3], edge[3][3], normal[3], length[3];
    kd_plane to = {{0.0f, 0.0f, 0.0f}, -1.0f};
    corners_of(s, triangle, p);
    for (int i = 0; i < 3; i++) {
        for (int a = 0; a < 3; a++) {
            edge[i][a] = p[(i + 1) % 3][a] - p[i][a];
        }
        length[i] = length_of(edge[i]);
    }
    for (int a = 0; a < 3; a++) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        normal[a] = edge[0][b] * edge[1][c] - edge[0][c] * edge[1][b];
    }
    const double size = length_of(normal);
    const double least = fmin(fmin(length[0], length[1]), length[2]);
    const double sine = size * least / (length[0] * length[1] * length[2]);
    const double most = fmax(fmax(fabs(normal[0]), fabs(normal[1])), fabs(normal[2]));
    if (sine >= SLIVER && most < ACROSS * size) { /* not if it is no number */
        for (int a = 0; a < 3; a++) {
            to.normal[a] = (float)(normal[a] / size);
        }
        to.off = (float)(OFF * (double)s->reach / sine);
    }
    return to;
}

static void set_margins(kd_scene *s) {
    const plt_box *b = &s->triangles->box;
    float furthest = 0.0f;
    s->reach = fmaxf(REACH * plt_box_longest_side(b), PLT_REACH_LEAST);
    for (int a = 0; a < 3; a++) {
        furthest = fmaxf(furthest, fmaxf(fabsf(b->lo[a]), fabsf(b->hi[a])));
    }
    s->margin =
        4.00001f * fmaxf(s->reach * PLT_BOX_ERROR, (furthest + s->reach) * PLT_ORIGIN_ERROR);
}

int kd_scene_set(kd_scene *s, const triangle_set *triangles, int is_clipped) {
    s->triangles = triangles;
    if (triangles->count == 0) {
        return 0;
    }
    set_margins(s);
    if (is_clipped && s->plane == NULL) {
        s->plane = heap_get((uint64_t)triangles->count * sizeof *s->plane);
        if (s->plane == NULL) {
            return -1;
        }
    }
    for (uint32_t i = 0; is_clipped && i < triangles->count; i++) {
        s->plane[i] = plane_of(s, i);
    }
    return 0;
}

void kd_scene_free(kd_scene *s) {
    heap_drop(s->plane);
    s->plane = NULL;
}

kd_reference kd_whole(const kd_scene *s, uint32_t triangle) {
    const plt_box b = plt_record_box(&s->triangles->record[triangle]);
    kd_reference r = {.triangle = triangle};
    for (int a = 0; a < 3; a++) {
        r.lo[a] = b.lo[a] - s->margin;
        r.hi[a] = b.hi[a] + s->margin;
    }
    return r;
}

/* ---- clipping --------------------------------------------------------------------- */

enum { POINTS_MOST = 3 + 6 };

typedef struct polygon {
    double point[POINTS_MOST][3];
    int count;
} polygon;

/* Keeps what has sign * x <= sign * at on an axis. */
static void cut(polygon *p, int axis, double sign, double at) {
    polygon to = {.count = 0};
    for (int i = 0; i < p->count; i++) {
        const double *from = p->point[i], *next = p->point[(i + 1) % p->count];
        const double d = sign * (from[axis] - at), e = sign * (next[axis] - at);
        if (d <= 0.0 && to.count < POINTS_MOST) {
            for (int a = 0; a < 3; a++) {
                to.point[to.count][a] = from[a];
            }
            to.count++;
        }
        if (((d < 0.0 && e > 0.0) || (d > 0.0 && e < 0.0)) && to.count < POINTS_MOST) {
            for (int a = 0; a < 3; a++) {
                to.point[to.count][a] = from[a] + (next[a] - from[a]) * (d / (d - e));
            }
            to.point[to.count++][axis] = at;
        }
    }
    *p = to;
}

/* The box of what the triangle has within `wide` of the cell, widened by as much; 0: nothing. */
static int clip_triangle(const kd_scene *s, uint32_t triangle, double wide, const float lo[3],
                         const float hi[3], kd_reference *to) {
    polygon p = {.count = 3};
    corners_of(s, triangle, p.point);
    for (int a = 0; a < 3 && p.count > 0; a++) {
        cut(&p, a, -1.0, (double)lo[a] - wide);
        cut(&p, a, 1.0, (double)hi[a] + wide);
    }
    if (p.count == 0) {
        return 0;
    }
    for (int a = 0; a < 3; a++) {
        double least = p.point[0][a], most = least;
        for (int i = 1; i < p.count; i++) {
            least = fmin(least, p.point[i][a]);
            most = fmax(most, p.point[i][a]);
        }
        to->lo[a] = (float)(least - wide);
        to->hi[a] = (float)(most + wide);
    }
    return 1;
}

static int cut_to(kd_reference *r, const float lo[3], const float hi[3]) {
    int is_there = 1;
    for (int a = 0; a < 3; a++) {
        r->lo[a] = fmaxf(r->lo[a], lo[a]);
        r->hi[a] = fminf(r->hi[a], hi[a]);
        is_there &= r->lo[a] <= r->hi[a];
    }
    return is_there;
}

int kd_clip(const kd_scene *s, kd_reference *r, const float lo[3], const float hi[3]) {
    if (!cut_to(r, lo, hi)) {
        return 0;
    }
    if (s->plane == NULL || s->plane[r->triangle].off < 0.0f) {
        return 1;
    }
    const double wide = 16.0 * (double)s->plane[r->triangle].off + (double)s->margin;
    kd_reference inside = {.triangle = r->triangle};
    return clip_triangle(s, r->triangle, wide, lo, hi, &inside) && cut_to(r, inside.lo, inside.hi);
}

int kd_is_stray(const kd_scene *s, uint32_t triangle, const float lo[3], const float hi[3]) {
    const kd_plane *p = &s->plane[triangle];
    kd_reference r = kd_whole(s, triangle);
    if (p->off < 0.0f || !cut_to(&r, lo, hi)) {
        return 0;
    }
    double corner[3][3], apart = 0.0, wide = (double)p->off;
    corners_of(s, triangle, corner);
    for (int a = 0; a < 3; a++) {
        const double n = (double)p->normal[a];
        apart += n * (0.5 * ((double)lo[a] + (double)hi[a]) - corner[0][a]);
        wide += fabs(n) * (0.5 * ((double)hi[a] - (double)lo[a]) + (double)s->margin);
    }
    return fabs(apart) <= wide;
}
