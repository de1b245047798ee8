/* reduce - see reduce.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/reduce.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define NOWHERE UINT32_MAX

typedef struct clustering {
    const mesh *m;
    double lo[3], longest;
    uint64_t *cell;    /* key of each cluster */
    uint32_t *hash;    /* clusters by key */
    uint32_t *cluster; /* of each vertex */
    size_t hash_size, clusters;
} clustering;

static void bounds(clustering *c) {
    double hi[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int a = 0; a < 3; a++) {
        c->lo[a] = INFINITY;
    }
    for (size_t i = 0; i < 3 * c->m->vertices; i++) {
        c->lo[i % 3] = fmin(c->lo[i % 3], (double)c->m->vertex[i]);
        hi[i % 3] = fmax(hi[i % 3], (double)c->m->vertex[i]);
    }
    c->longest = 0.0;
    for (int a = 0; a < 3; a++) {
        c->longest = fmax(c->longest, hi[a] - c->lo[a]);
    }
}

static uint32_t cluster_of(clustering *c, uint64_t key) {
    size_t at = (size_t)(key * 0x9E3779B97F4A7C15u >> 20) % c->hash_size;
    while (c->hash[at] != NOWHERE && c->cell[c->hash[at]] != key) {
        at = (at + 1) % c->hash_size;
    }
    if (c->hash[at] == NOWHERE) {
        c->cell[c->clusters] = key;
        c->hash[at] = (uint32_t)c->clusters++;
    }
    return c->hash[at];
}

/* Gives every vertex its cluster in a grid of `cells` along the longest side. A vertex
 * on the far border belongs to the last cell. */
static void assign(clustering *c, double cells) {
    const double scale = c->longest > 0.0 ? cells / c->longest : 0.0;
    const double last = ceil(cells) - 1.0;
    c->clusters = 0;
    memset(c->hash, 0xFF, c->hash_size * sizeof *c->hash);
    for (size_t i = 0; i < c->m->vertices; i++) {
        uint64_t key = 0;
        for (size_t a = 0; a < 3; a++) {
            const double x = ((double)c->m->vertex[3 * i + a] - c->lo[a]) * scale;
            key = key << 21 | (uint64_t)fmin(x, last);
        }
        c->cluster[i] = cluster_of(c, key);
    }
}

static int survives(const clustering *c, size_t triangle) {
    const uint32_t *t = &c->m->triangle[3 * triangle];
    const uint32_t p = c->cluster[t[0]], q = c->cluster[t[1]], r = c->cluster[t[2]];
    return p != q && q != r && p != r;
}

static size_t count_left(const clustering *c) {
    size_t left = 0;
    for (size_t i = 0; i < c->m->triangles; i++) {
        left += (size_t)survives(c, i);
    }
    return left;
}

/* The finest grid that leaves at most `most`; one cell always does. Their
 * number along a side need not be whole: few triangles leave few whole numbers. */
static double finest_grid(clustering *c, size_t most) {
    double good = 1.0, bad = 1048576.0;
    for (int i = 0; i < 40 && bad > good * (1.0 + 1e-6); i++) {
        const double middle = sqrt(good * bad);
        assign(c, middle);
        if (count_left(c) <= most) {
            good = middle;
        } else {
            bad = middle;
        }
    }
    return good;
}

static int rebuild(const clustering *c, mesh *to, fail *f) {
    double *sum = calloc(c->clusters * 4 + 1, sizeof *sum);
    int status = sum == NULL ? -1 : 0;
    for (size_t i = 0; i < c->m->vertices && status == 0; i++) {
        double *s = &sum[4 * (size_t)c->cluster[i]];
        for (size_t a = 0; a < 3; a++) {
            s[a] += (double)c->m->vertex[3 * i + a];
        }
        s[3] += 1.0;
    }
    for (size_t i = 0; i < c->clusters && status == 0; i++) {
        const double *s = &sum[4 * i];
        status = mesh_add_vertex(to, (float)(s[0] / s[3]), (float)(s[1] / s[3]),
                                 (float)(s[2] / s[3]), f);
    }
    for (size_t i = 0; i < c->m->triangles && status == 0; i++) {
        const uint32_t *t = &c->m->triangle[3 * i];
        if (survives(c, i)) {
            status = mesh_add_triangle(to, c->cluster[t[0]], c->cluster[t[1]], c->cluster[t[2]], f);
        }
    }
    free(sum);
    return status;
}

int mesh_reduce(mesh *m, size_t most, const char *name, fail *f) {
    clustering c = {.m = m};
    mesh reduced = {0};
    if (m->triangles <= most) {
        return 0;
    }
    c.hash_size = 2 * m->vertices + 1;
    c.cell = malloc(m->vertices * sizeof *c.cell + 1);
    c.hash = malloc(c.hash_size * sizeof *c.hash);
    c.cluster = malloc(m->vertices * sizeof *c.cluster + 1);
    int status = -1;
    if (c.cell != NULL && c.hash != NULL && c.cluster != NULL) {
        bounds(&c);
        assign(&c, finest_grid(&c, most));
        status = rebuild(&c, &reduced, f);
    }
    if (status != 0) {
        fail_set(f, name, "out of memory while reducing; use a larger machine");
        mesh_free(&reduced);
    } else {
        mesh_free(m);
        *m = reduced;
    }
    free(c.cell);
    free(c.hash);
    free(c.cluster);
    return status;
}
