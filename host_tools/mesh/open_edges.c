/* open_edges - see open_edges.h
 *
 * Vertices become the first ones at their positions; each edge is kept with its lower vertex, as
 * the number of the higher one. The edges of a vertex are then counted against a byte per vertex.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/open_edges.h"

#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/mesh/position_table.h"

static const uint32_t NOT_YET = UINT32_MAX; /* never a vertex */

/* Vertices count from the first that the triangles use. */
typedef struct search {
    const mesh *m;
    size_t first, end;   /* triangles */
    vertex_range range;  /* that they use */
    uint32_t *same;      /* by vertex: the first at its position */
    size_t *begin;       /* by vertex v: higher[begin[v] .. begin[v + 1] - 1] */
    uint32_t *higher;    /* the other vertex of each use of an edge */
    unsigned char *uses; /* by vertex: of its edge to the one in hand; 2 for more */
    unsigned char *ends; /* by vertex: an open edge ends there */
} search;

static int find_same(search *s) {
    position_table t;
    int status = position_table_begin(&t, s->m->vertex + 3 * s->range.first, s->range.count);
    s->same = heap_get((uint64_t)s->range.count * sizeof *s->same);
    if (status == 0 && s->same != NULL) {
        memset(s->same, 0xff, s->range.count * sizeof *s->same);
        for (size_t i = 3 * s->first; i < 3 * s->end; i++) {
            const uint32_t v = (uint32_t)(s->m->triangle[i] - s->range.first);
            s->same[v] = s->same[v] == NOT_YET ? position_table_first(&t, v) : s->same[v];
        }
    } else {
        status = -1;
    }
    position_table_free(&t);
    return status;
}

/* The corners of a triangle; 0 when two are equal. */
static int corners_of(const search *s, size_t triangle, uint32_t v[4]) {
    for (size_t k = 0; k < 3; k++) {
        v[k] = s->same[s->m->triangle[3 * triangle + k] - s->range.first];
    }
    v[3] = v[0];
    return v[0] != v[1] && v[1] != v[2] && v[2] != v[0];
}

static void count_edges(search *s) {
    for (size_t i = s->first; i < s->end; i++) {
        uint32_t v[4];
        for (int k = 0, good = corners_of(s, i, v); k < 3 && good; k++) {
            s->begin[(v[k] < v[k + 1] ? v[k] : v[k + 1]) + 1]++;
        }
    }
    for (size_t v = 0; v < s->range.count; v++) {
        s->begin[v + 1] += s->begin[v];
    }
}

/* begin[v + 1] counts down to where the edges of v begin. */
static void place_edges(search *s) {
    for (size_t i = s->first; i < s->end; i++) {
        uint32_t v[4];
        for (int k = 0, good = corners_of(s, i, v); k < 3 && good; k++) {
            const int is_up = v[k] < v[k + 1];
            s->higher[--s->begin[v[k + !is_up] + 1]] = v[k + is_up];
        }
    }
}

/* Of the edges of `v`, which end before `end`, counts and marks those that are open. */
static uint64_t open_from(const search *s, size_t v, size_t end) {
    uint64_t open = 0;
    for (size_t i = s->begin[v + 1]; i < end; i++) {
        unsigned char *uses = &s->uses[s->higher[i]];
        *uses = *uses ? 2 : 1;
    }
    for (size_t i = s->begin[v + 1]; i < end; i++) {
        if (s->uses[s->higher[i]] == 1) {
            s->ends[v] = s->ends[s->higher[i]] = 1;
            open++;
        }
    }
    for (size_t i = s->begin[v + 1]; i < end; i++) {
        s->uses[s->higher[i]] = 0;
    }
    return open;
}

static int find_open(search *s, uint64_t *open) {
    s->begin = heap_get_zeroed(((uint64_t)s->range.count + 1) * sizeof *s->begin);
    if (s->begin == NULL) {
        return -1;
    }
    count_edges(s);
    const size_t edges = s->begin[s->range.count];
    s->higher = heap_get((uint64_t)edges * sizeof *s->higher);
    s->uses = heap_get_zeroed(s->range.count);
    s->ends = heap_get_zeroed(s->range.count);
    if (s->higher == NULL || s->uses == NULL || s->ends == NULL) {
        return -1;
    }
    place_edges(s);
    for (size_t v = 0; v < s->range.count; v++) {
        const size_t end = v + 1 < s->range.count ? s->begin[v + 2] : edges;
        *open += open_from(s, v, end);
    }
    return 0;
}

static int list_ends(const search *s, open_edges *o) {
    size_t count = 0;
    for (size_t v = 0; v < s->range.count; v++) {
        count += s->ends[v];
    }
    o->end = heap_get((uint64_t)count * sizeof *o->end);
    for (size_t v = 0; v < s->range.count && o->end != NULL; v++) {
        if (s->ends[v]) {
            o->end[o->ends++] = (uint32_t)(v + s->range.first);
        }
    }
    return o->end == NULL ? -1 : 0;
}

static void free_lists(search *s) {
    heap_drop(s->same);
    heap_drop(s->begin);
    heap_drop(s->higher);
    heap_drop(s->uses);
    s->same = NULL;
    s->begin = NULL;
    s->higher = NULL;
    s->uses = NULL;
}

uint64_t open_edges_bytes(uint64_t vertices, uint64_t triangles) {
    const uint64_t lists = 14 * vertices + 12 * triangles + 8 + 5 * heap_cost(0);
    const uint64_t table = 4 * vertices + position_table_bytes(vertices) + heap_cost(0);
    return lists > table ? lists : table;
}

int open_edges_find(open_edges *o, const mesh *m, size_t first, size_t end) {
    search s = {.m = m, .first = first, .end = end, .range = mesh_vertices_of(m, first, end)};
    *o = (open_edges){0, NULL, 0};
    int status = find_same(&s) == 0 && find_open(&s, &o->count) == 0 ? 0 : -1;
    free_lists(&s);
    if (status == 0) {
        status = list_ends(&s, o);
    }
    heap_drop(s.ends);
    return status;
}

void open_edges_free(open_edges *o) {
    heap_drop(o->end);
    *o = (open_edges){0, NULL, 0};
}
