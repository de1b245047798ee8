/* smooth - see smooth.h
 *
 * Where more triangles than FEW meet, those that point alike are taken as one first, so that time
 * stays linear: a fan of a million triangles has a tip like any other.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/smooth.h"

#include <math.h>
#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/mesh/position_table.h"

enum { FEW = 64, ALIKE_BITS = 5, ALIKE = 1 << 2 * ALIKE_BITS };

static const double DEGREE = 0.017453292519943295;

/* What meets in a position: a triangle's direction, and its angle there times that. */
typedef struct facet {
    double normal[3], weighted[3];
} facet;

typedef struct smoothing {
    const mesh *m;
    mesh_corners *to;
    double least;     /* cosine of the crease */
    uint32_t *first;  /* corners by position: where its own begin, in `corner` */
    uint32_t *corner; /* 3 * triangle + corner */
    facet *facet;     /* of a position */
    size_t room;
    double (*alike)[6]; /* ALIKE of them: sums of normals and weights that point alike */
} smoothing;

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static int normalise(double v[3]) {
    const double length = sqrt(dot(v, v));
    for (int a = 0; a < 3 && length > 0; a++) {
        v[a] /= length;
    }
    return length > 0 && isfinite(length);
}

static void edge_of(const mesh *m, size_t triangle, unsigned from, unsigned to, double e[3]) {
    const uint32_t *t = m->triangle + 3 * triangle;
    for (int a = 0; a < 3; a++) {
        e[a] = mesh_wide(m, t[to], a) - mesh_wide(m, t[from], a);
    }
}

/* 0: the triangle has no area. */
static int read_facet(const mesh *m, uint32_t corner, facet *f) {
    const size_t triangle = corner / 3;
    const unsigned c = corner % 3;
    double e[3], g[3];
    memset(f, 0, sizeof *f);
    edge_of(m, triangle, c, (c + 1) % 3, e);
    edge_of(m, triangle, c, (c + 2) % 3, g);
    if (!normalise(e) || !normalise(g)) {
        return 0;
    }
    const double n[3] = {e[1] * g[2] - e[2] * g[1], e[2] * g[0] - e[0] * g[2],
                         e[0] * g[1] - e[1] * g[0]};
    memcpy(f->normal, n, sizeof n);
    if (!normalise(f->normal)) {
        return 0;
    }
    const double cosine = dot(e, g);
    const double angle = acos(cosine > 1 ? 1 : cosine < -1 ? -1 : cosine);
    for (int a = 0; a < 3; a++) {
        f->weighted[a] = angle * f->normal[a];
    }
    return 1;
}

/* ---- corners by position --------------------------------------------------------------- */

static int sort_corners(smoothing *s) {
    const mesh *m = s->m;
    const size_t corners = 3 * m->triangles;
    position_table t;
    uint32_t *of = heap_get(4 * (uint64_t)(m->vertices + 1));
    s->first = heap_get_zeroed(4 * (uint64_t)(m->vertices + 2));
    s->corner = heap_get(4 * (uint64_t)(corners + 1));
    if (of == NULL || s->first == NULL || s->corner == NULL ||
        position_table_begin(&t, m->vertex, m->vertices) != 0) {
        heap_drop(of);
        return -1;
    }
    for (size_t v = 0; v < m->vertices; v++) {
        of[v] = position_table_first(&t, (uint32_t)v);
    }
    for (size_t i = 0; i < corners; i++) {
        s->first[of[m->triangle[i]] + 2]++;
    }
    for (size_t v = 0; v < m->vertices; v++) {
        s->first[v + 1] += s->first[v];
    }
    for (size_t i = 0; i < corners; i++) {
        s->corner[s->first[of[m->triangle[i]] + 1]++] = (uint32_t)i;
    }
    position_table_free(&t);
    heap_drop(of);
    return 0;
}

/* ---- one position ---------------------------------------------------------------------- */

static int make_room(smoothing *s, size_t facets) {
    if (facets <= s->room) {
        return 0;
    }
    const size_t room = facets + facets / 2;
    facet *f = heap_resize(s->facet, (uint64_t)room * sizeof *f);
    if (f == NULL) {
        return -1;
    }
    s->facet = f;
    s->room = room;
    return 0;
}

static unsigned alike_of(const double normal[3]) {
    const uint32_t n = corner_normal(normal);
    const unsigned x = ((n & 0xFFFFu) ^ 0x8000u) >> (16 - ALIKE_BITS);
    const unsigned y = (n >> 16 ^ 0x8000u) >> (16 - ALIKE_BITS);
    return y << ALIKE_BITS | x;
}

/* The facets of a position, behind those of its corners; how many. */
static size_t gather_alike(smoothing *s, size_t count) {
    facet *to = s->facet + count;
    size_t kept = 0;
    memset(s->alike, 0, ALIKE * sizeof *s->alike);
    for (size_t i = 0; i < count; i++) {
        const facet *f = &s->facet[i];
        double *sum = s->alike[dot(f->normal, f->normal) > 0 ? alike_of(f->normal) : 0];
        for (int a = 0; a < 3; a++) {
            sum[a] += f->normal[a];
            sum[3 + a] += f->weighted[a];
        }
    }
    for (size_t i = 0; i < ALIKE; i++) {
        memcpy(to[kept].normal, s->alike[i], sizeof to[kept].normal);
        memcpy(to[kept].weighted, s->alike[i] + 3, sizeof to[kept].weighted);
        kept += (size_t)normalise(to[kept].normal);
    }
    return kept;
}

static void smooth_corner(const smoothing *s, uint32_t corner, const facet *own, const facet *all,
                          size_t count) {
    double sum[3] = {0, 0, 0};
    if (dot(own->normal, own->normal) == 0) {
        return;
    }
    for (size_t i = 0; i < count; i++) {
        if (dot(all[i].normal, own->normal) >= s->least) {
            for (int a = 0; a < 3; a++) {
                sum[a] += all[i].weighted[a];
            }
        }
    }
    const double length = sqrt(dot(sum, sum));
    s->to->normal[corner] = corner_normal(length > 1e-6 ? sum : own->normal);
}

static int smooth_position(smoothing *s, uint32_t begin, uint32_t end) {
    const size_t count = end - begin;
    const int many = count > FEW;
    if (make_room(s, count + (many ? ALIKE + 1 : 0)) != 0) {
        return -1;
    }
    for (size_t i = 0; i < count; i++) {
        read_facet(s->m, s->corner[begin + i], &s->facet[i]);
    }
    const size_t all = many ? gather_alike(s, count) : count;
    for (size_t i = 0; i < count; i++) {
        smooth_corner(s, s->corner[begin + i], &s->facet[i], s->facet + (many ? count : 0), all);
    }
    return 0;
}

int mesh_smooth(const mesh *m, double degrees, mesh_corners *c) {
    smoothing s = {.m = m, .to = c, .least = cos(degrees * DEGREE) - 1e-9};
    int status = corners_want_normals(c, m->triangles);
    s.alike = heap_get(ALIKE * sizeof *s.alike);
    status =
        status == 0 && s.alike != NULL && m->triangles <= UINT32_MAX / 3 ? sort_corners(&s) : -1;
    for (size_t v = 0; v < m->vertices && status == 0; v++) {
        status = smooth_position(&s, s.first[v], s.first[v + 1]);
    }
    heap_drop(s.first);
    heap_drop(s.corner);
    heap_drop(s.facet);
    heap_drop(s.alike);
    return status;
}
