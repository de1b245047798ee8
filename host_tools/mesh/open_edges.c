/* open_edges - see open_edges.h
 *
 * Two tables with open addressing, at most half full: positions, then edges.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/open_edges.h"

#include <stdlib.h>
#include <string.h>

#include "host_tools/mesh/position.h"

#define FREE UINT64_MAX

typedef struct search {
    const mesh *m;
    size_t first, end;   /* triangles */
    uint32_t *same;      /* by slot: a vertex with that position, + 1 */
    uint64_t *edge;      /* by slot: two vertices, the smaller in the upper half; FREE */
    unsigned char *uses; /* of the edge in that slot: 1, 2 for more */
    size_t slots;        /* of both, a power of 2 */
    uint64_t open;
} search;

static size_t fold(uint64_t h, uint64_t bits) {
    h = (h ^ bits) * 0xd6e8feb86659fd93u;
    return (size_t)(h ^ h >> 32);
}

/* The first vertex met at the position of `vertex`. */
static uint32_t representative(search *s, uint32_t vertex) {
    const float *p = s->m->vertex + 3 * (size_t)vertex;
    size_t at = 0x9e3779b9;
    for (int axis = 0; axis < 3; axis++) {
        const float x = p[axis] + 0.0f; /* -0 is 0 */
        uint32_t bits;
        memcpy(&bits, &x, sizeof bits);
        at = fold(at, bits);
    }
    for (at &= s->slots - 1; s->same[at]; at = (at + 1) & (s->slots - 1)) {
        if (positions_are_equal(s->m->vertex + 3 * (size_t)(s->same[at] - 1), p)) {
            return s->same[at] - 1;
        }
    }
    s->same[at] = vertex + 1;
    return vertex;
}

static void use_edge(search *s, uint32_t a, uint32_t b) {
    const uint64_t key = a < b ? (uint64_t)a << 32 | b : (uint64_t)b << 32 | a;
    size_t at = fold(0x9e3779b97f4a7c15u, key) & (s->slots - 1);
    while (s->edge[at] != FREE && s->edge[at] != key) {
        at = (at + 1) & (s->slots - 1);
    }
    s->edge[at] = key;
    s->open += s->uses[at] == 0;
    s->open -= s->uses[at] == 1;
    s->uses[at] = s->uses[at] ? 2 : 1;
}

static void use_triangles(search *s) {
    for (size_t i = s->first; i < s->end; i++) {
        uint32_t v[3];
        for (size_t k = 0; k < 3; k++) {
            v[k] = representative(s, s->m->triangle[3 * i + k]);
        }
        if (v[0] != v[1] && v[1] != v[2] && v[2] != v[0]) {
            use_edge(s, v[0], v[1]);
            use_edge(s, v[1], v[2]);
            use_edge(s, v[2], v[0]);
        }
    }
}

static int collect(const search *s, open_edges *o) {
    o->vertex = malloc(2 * (size_t)s->open * sizeof *o->vertex + 1);
    if (o->vertex == NULL) {
        return -1;
    }
    for (size_t at = 0; at < s->slots; at++) {
        if (s->uses[at] == 1) {
            o->vertex[2 * o->count] = (uint32_t)(s->edge[at] >> 32);
            o->vertex[2 * o->count + 1] = (uint32_t)s->edge[at];
            o->count++;
        }
    }
    return 0;
}

int open_edges_find(open_edges *o, const mesh *m, size_t first, size_t end) {
    search s = {.m = m, .first = first, .end = end, .slots = 64};
    *o = (open_edges){0, NULL};
    while (s.slots < 6 * (end - first)) {
        s.slots *= 2;
    }
    s.same = calloc(s.slots, sizeof *s.same);
    s.edge = malloc(s.slots * sizeof *s.edge);
    s.uses = calloc(s.slots, 1);
    int status = s.same == NULL || s.edge == NULL || s.uses == NULL ? -1 : 0;
    if (status == 0) {
        memset(s.edge, 0xff, s.slots * sizeof *s.edge);
        use_triangles(&s);
        status = collect(&s, o);
    }
    free(s.same);
    free(s.edge);
    free(s.uses);
    return status;
}

void open_edges_free(open_edges *o) {
    free(o->vertex);
    *o = (open_edges){0, NULL};
}
