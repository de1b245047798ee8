/* lattice_around - see lattice_around.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/lattice_around.h"

#include <stdlib.h>
#include <string.h>

#include "host_tools/mesh/extent.h"

typedef struct vertex_at {
    float p[3];
    uint32_t vertex;
} vertex_at;

static int compare_positions(const void *a, const void *b) {
    const vertex_at *x = a, *y = b;
    const int order = memcmp(x->p, y->p, sizeof x->p);
    return order != 0 ? order : (x->vertex > y->vertex) - (x->vertex < y->vertex);
}

static int find_first(lattice_around *r, const mesh *m, const lattice_position *moved) {
    vertex_at *v = malloc(m->vertices * sizeof *v + 1);
    if (v == NULL) {
        return -1;
    }
    size_t used = 0;
    for (size_t i = 0; i < m->vertices; i++) {
        if (moved[i].q[0] != LATTICE_UNUSED) {
            for (size_t a = 0; a < 3; a++) {
                v[used].p[a] = m->vertex[3 * i + a] + 0.0f; /* -0 is 0 */
            }
            v[used++].vertex = (uint32_t)i;
        }
    }
    qsort(v, used, sizeof *v, compare_positions);
    for (size_t i = 0; i < used; i++) {
        const int same = i > 0 && memcmp(v[i].p, v[i - 1].p, sizeof v[i].p) == 0;
        r->first[v[i].vertex] = same ? r->first[v[i - 1].vertex] : v[i].vertex;
    }
    free(v);
    return 0;
}

static void find_triangles(lattice_around *r, const snapped *s, const mesh *m) {
    memset(r->begin, 0, (m->vertices + 1) * sizeof *r->begin);
    for (size_t i = 0; i < m->triangles; i++) {
        for (size_t k = 0; k < 3 && (k > 0 || mesh_counts(m, &s->mesh_box, i)); k++) {
            r->begin[r->first[m->triangle[3 * i + k]] + 1]++;
        }
    }
    for (size_t i = 0; i < m->vertices; i++) {
        r->begin[i + 1] += r->begin[i];
    }
    const uint32_t all = r->begin[m->vertices];
    for (size_t i = m->triangles; i-- > 0;) { /* begin[v + 1] counts down to its own start */
        for (size_t k = 0; k < 3 && (k > 0 || mesh_counts(m, &s->mesh_box, i)); k++) {
            r->triangle[--r->begin[r->first[m->triangle[3 * i + k]] + 1]] = (uint32_t)i;
        }
    }
    memmove(r->begin, r->begin + 1, m->vertices * sizeof *r->begin);
    r->begin[m->vertices] = all;
}

int lattice_around_find(lattice_around *r, const snapped *s, const mesh *m,
                        const lattice_position *moved) {
    r->first = malloc(m->vertices * sizeof *r->first + 1);
    r->begin = malloc((m->vertices + 1) * sizeof *r->begin);
    r->triangle = malloc(3 * m->triangles * sizeof *r->triangle + 1);
    if (r->first == NULL || r->begin == NULL || r->triangle == NULL ||
        find_first(r, m, moved) != 0) {
        return -1;
    }
    find_triangles(r, s, m);
    return 0;
}

void lattice_around_free(lattice_around *r) {
    free(r->first);
    free(r->begin);
    free(r->triangle);
}
