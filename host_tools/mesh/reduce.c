/* reduce - see reduce.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/reduce.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/mesh/extent.h"

#define NOWHERE UINT32_MAX

/* Grids: cells along the longest side, below 2^21, which is a key's share of an axis. */
static const double CELLS_MOST = 1048576.0;

typedef struct clustering {
    const mesh *m;
    plt_box box;       /* of the triangles that count (extent.h) */
    double longest;    /* its longest side */
    uint32_t *vertex;  /* the vertices that those triangles use, ascending */
    uint64_t *cell;    /* key of each cluster */
    uint32_t *hash;    /* clusters by key */
    uint32_t *cluster; /* of each vertex; NOWHERE when no triangle that counts uses it */
    size_t used, hash_size, clusters;
} clustering;

static void find_used(clustering *c) {
    c->box = mesh_area_box(c->m);
    for (int a = 0; a < 3; a++) {
        c->longest = fmax(c->longest, (double)c->box.hi[a] - (double)c->box.lo[a]);
    }
    memset(c->cluster, 0xFF, c->m->vertices * sizeof *c->cluster); /* NOWHERE */
    for (size_t i = 0; i < c->m->triangles; i++) {
        for (size_t k = 0; k < 3 && (k > 0 || mesh_counts(c->m, &c->box, i)); k++) {
            c->cluster[c->m->triangle[3 * i + k]] = 0;
        }
    }
    for (size_t i = 0; i < c->m->vertices; i++) {
        if (c->cluster[i] != NOWHERE) {
            c->vertex[c->used++] = (uint32_t)i;
        }
    }
    c->hash_size = 2 * c->used + 1;
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

/* Gives every vertex that is used its cluster in a grid of `cells` along the longest side. A
 * vertex on the far border belongs to the last cell. */
static void assign(clustering *c, double cells) {
    const double scale = c->longest > 0.0 ? cells / c->longest : 0.0;
    const double last = ceil(cells) - 1.0;
    c->clusters = 0;
    memset(c->hash, 0xFF, c->hash_size * sizeof *c->hash);
    for (size_t i = 0; i < c->used; i++) {
        const float *p = c->m->vertex + 3 * (size_t)c->vertex[i];
        uint64_t key = 0;
        for (int a = 0; a < 3; a++) {
            const double x = ((double)p[a] - (double)c->box.lo[a]) * scale;
            key = key << 21 | (uint64_t)fmin(x, last);
        }
        c->cluster[c->vertex[i]] = cluster_of(c, key);
    }
}

/* A triangle that does not count has a corner NOWHERE, or two at one position. */
static int survives(const clustering *c, size_t triangle) {
    const uint32_t *t = &c->m->triangle[3 * triangle];
    const uint32_t p = c->cluster[t[0]], q = c->cluster[t[1]], r = c->cluster[t[2]];
    return p != q && q != r && p != r && p != NOWHERE && q != NOWHERE && r != NOWHERE;
}

static size_t count_left(clustering *c, double cells) {
    size_t left = 0;
    assign(c, cells);
    for (size_t i = 0; i < c->m->triangles; i++) {
        left += (size_t)survives(c, i);
    }
    return left;
}

/* The finest grid that leaves at most `most`; one cell always does. Their
 * number along a side need not be whole: few triangles leave few whole numbers. */
static double finest_grid(clustering *c, size_t most) {
    double good = 1.0, bad = CELLS_MOST;
    for (int i = 0; i < 40 && bad > good * (1.0 + 1e-6); i++) {
        const double middle = sqrt(good * bad);
        if (count_left(c, middle) <= most) {
            good = middle;
        } else {
            bad = middle;
        }
    }
    return good;
}

/* Of the coarse grids that leave something, the one that leaves the most of at most `most`,
 * 0 when there is none; *least is the least that any of them leaves. Counts do not rise
 * steadily from grid to grid, so the finest grid may leave nothing and a coarser one
 * something. The grids are the same for any `most`: asking for *least succeeds. */
static double coarse_grid(clustering *c, size_t most, size_t *least) {
    double grid = 0.0;
    size_t best = 0;
    int finer = 32; /* grids after the first that leaves something: to four times as fine */
    for (double cells = 1.0; cells < CELLS_MOST && finer > 0; cells *= 1.0442737824274138) {
        const size_t left = count_left(c, cells);
        finer -= left > 0 || finer < 32;
        *least = left > 0 && left < *least ? left : *least;
        if (left <= most && left > best) {
            best = left;
            grid = cells;
        }
    }
    return grid;
}

static int rebuild(const clustering *c, mesh *to, fail *f) {
    double *sum = heap_get_zeroed((uint64_t)c->clusters * 4 * sizeof *sum);
    int status = sum == NULL ? -1 : 0;
    for (size_t i = 0; i < c->used && status == 0; i++) {
        const float *p = c->m->vertex + 3 * (size_t)c->vertex[i];
        double *s = &sum[4 * (size_t)c->cluster[c->vertex[i]]];
        for (int a = 0; a < 3; a++) {
            s[a] += (double)p[a];
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
    heap_drop(sum);
    return status;
}

/* Clusters that leave 1 to `most` triangles. */
static int find_clusters(clustering *c, size_t most, const char *name, fail *f) {
    size_t least = c->m->triangles;
    if (c->used == 0) {
        return fail_set(f, name, "none of its %zu triangles has an area; leave out --reduce",
                        c->m->triangles);
    }
    if (count_left(c, finest_grid(c, most)) > 0) {
        return 0;
    }
    const double grid = coarse_grid(c, most, &least);
    if (grid > 0.0) {
        assign(c, grid);
        return 0;
    }
    for (int i = 0; i < 16 && least > most + 1; i++, least--) { /* fewer may do in a fine grid */
        if (count_left(c, finest_grid(c, least - 1)) == 0) {
            break;
        }
    }
    return fail_set(f, name,
                    "--reduce %zu leaves none of its %zu triangles: their corners fall together; "
                    "use --reduce %zu or more",
                    most, c->m->triangles, least);
}

static int reduce(clustering *c, mesh *to, size_t most, const char *name, fail *f) {
    c->vertex = heap_get((uint64_t)c->m->vertices * sizeof *c->vertex);
    c->cell = heap_get((uint64_t)c->m->vertices * sizeof *c->cell);
    c->hash = heap_get((2 * (uint64_t)c->m->vertices + 1) * sizeof *c->hash);
    c->cluster = heap_get((uint64_t)c->m->vertices * sizeof *c->cluster);
    if (c->vertex != NULL && c->cell != NULL && c->hash != NULL && c->cluster != NULL) {
        find_used(c);
        if (find_clusters(c, most, name, f) != 0) {
            return -1;
        }
        if (rebuild(c, to, f) == 0) {
            return 0;
        }
    }
    return fail_set(f, name, "out of memory while reducing; use a larger machine");
}

/* Beside the mesh: four lists by vertex, the sums of clusters, and the reduced mesh, whose arrays
 * grow by half. */
uint64_t mesh_reduce_bytes(uint64_t vertices, uint64_t most) {
    return 24 * vertices + 32 * vertices + 18 * (vertices + most) + 4096;
}

int mesh_reduce(mesh *m, size_t most, const char *name, fail *f) {
    clustering c = {.m = m};
    mesh reduced = {0};
    if (m->triangles <= most) {
        return 0;
    }
    const int status = reduce(&c, &reduced, most, name, f);
    if (status == 0) {
        mesh_free(m);
        *m = reduced;
    } else {
        mesh_free(&reduced);
    }
    heap_drop(c.vertex);
    heap_drop(c.cell);
    heap_drop(c.hash);
    heap_drop(c.cluster);
    return status;
}
