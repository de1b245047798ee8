/* lattice_around - see lattice_around.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/lattice_around.h"

#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/mesh/extent.h"
#include "host_tools/mesh/position_table.h"

static int find_first(lattice_around *r, const mesh *m, const lattice_position *moved) {
    position_table t;
    if (position_table_begin(&t, m->vertex, m->vertices) != 0) {
        return -1;
    }
    for (uint32_t i = 0; i < m->vertices; i++) {
        if (moved[i].q[0] != LATTICE_UNUSED) {
            r->first[i] = position_table_first(&t, i);
        }
    }
    position_table_free(&t);
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
    r->first = heap_get((uint64_t)m->vertices * sizeof *r->first);
    if (r->first == NULL || find_first(r, m, moved) != 0) {
        return -1;
    }
    r->begin = heap_get(((uint64_t)m->vertices + 1) * sizeof *r->begin);
    r->triangle = heap_get(3 * (uint64_t)m->triangles * sizeof *r->triangle);
    if (r->begin == NULL || r->triangle == NULL) {
        return -1;
    }
    find_triangles(r, s, m);
    return 0;
}

void lattice_around_free(lattice_around *r) {
    heap_drop(r->first);
    heap_drop(r->begin);
    heap_drop(r->triangle);
}
