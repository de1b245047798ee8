/* lattice_around - vertices by position, and the triangles around each
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOST_LATTICE_AROUND_H
#define HOST_LATTICE_AROUND_H
#include "host_tools/pack/snapped.h"

/* Of vertices and triangles that count (extent.h); the others' entries have no meaning. */
typedef struct lattice_around {
    uint32_t *first;    /* of each vertex: the first vertex with the same position */
    uint32_t *begin;    /* of first vertex v: triangle[begin[v] .. begin[v + 1] - 1] */
    uint32_t *triangle; /* one stands there once for each of its corners at v */
} lattice_around;

/* `moved` says which vertices count (snapped.h). 0, or -1 when memory is out; what it
 * allocates lattice_around_free frees in either case. */
int lattice_around_find(lattice_around *r, const snapped *s, const mesh *m,
                        const lattice_position *moved);
void lattice_around_free(lattice_around *r);

static inline uint32_t lattice_around_count(const lattice_around *r, uint32_t first) {
    return r->begin[first + 1] - r->begin[first];
}

#endif
