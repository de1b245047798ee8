/* strips - few strips over the triangles of a leaf
 *
 * Every triangle in each of its three rotations is tried as the first; a strip goes
 * on with the first triangle that shares the right edge in the right direction,
 * and a new one starts where none does. With at most 8 triangles that is
 * close to the best. Trying ends when no start less is possible.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/builder/blocks_state.h"

enum { EDGES = 3 * PLT_LEAF_TRIANGLES_MOST };

static uint32_t lowest_bit(uint32_t x) {
    return (uint32_t)__builtin_ctz(x);
}

typedef struct strip_try {
    plt_strip_step step[PLT_LEAF_TRIANGLES_MOST];
    uint32_t starts;
} strip_try;

/* Edge 3 t + r runs from corner r of triangle t to the next one. */
typedef struct strip_edges {
    uint32_t back[EDGES]; /* of each edge: the edges that run the other way, as bits */
    uint32_t count;       /* triangles */
} strip_edges;

/* The three edges of a triangle. */
static uint32_t edges_of(uint32_t triangle) {
    return 7u << 3 * triangle;
}

static int is_same(const uint32_t a[3], const uint32_t b[3]) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/* Of edges as bits, of each the one before it in its triangle. */
static uint32_t edges_before(uint32_t edges) {
    const uint32_t first = 0x249249u; /* edges 3 t */
    return (edges & first) << 2 | (edges & ~first) >> 1;
}

/* What runs the other way round begins where the edge ends, and ends where it begins. The
 * corners of all triangles in a row are numbered by the first in the same position. */
static void find_back_edges(const uint32_t corner[][3], uint32_t count, strip_edges *e) {
    uint8_t number[EDGES];
    uint32_t from[EDGES]; /* edges from the corner of a number, as bits */
    for (uint32_t i = 0; i < 3 * count; i++) {
        uint32_t first = 0;
        while (!is_same(corner[first], corner[i])) {
            first++;
        }
        number[i] = (uint8_t)first;
        from[i] = 0;
        from[first] |= 1u << i;
    }
    for (uint32_t i = 0; i < 3 * count; i++) {
        const uint32_t next = i % 3 == 2 ? i - 2 : i + 1;
        e->back[i] = from[number[next]] & edges_before(from[number[i]]);
    }
    e->count = count;
}

/* Goes on over edge `over` (0 .. 2, counted from the rotation) of the last triangle. */
static int go_over(const strip_edges *e, uint32_t left, const plt_strip_step *last, uint32_t over,
                   plt_strip_step *next) {
    const uint32_t r = last->rotation + over;
    const uint32_t found = e->back[3u * last->triangle + (r < 3 ? r : r - 3)] & left;
    if (found == 0) {
        return 0;
    }
    const uint32_t edge = lowest_bit(found);
    next->triangle = (uint8_t)(edge / 3);
    next->rotation = (uint8_t)(edge % 3);
    next->start = 0;
    next->swap = over == 2;
    return 1;
}

/* `left`: edges of triangles that are not used yet. */
static int go_on(const strip_edges *e, uint32_t left, const plt_strip_step *last,
                 plt_strip_step *next) {
    return go_over(e, left, last, 1, next) || go_over(e, left, last, 2, next);
}

/* The first triangle left, rotated so that a strip can go on from it. */
static void start_anew(const strip_edges *e, uint32_t left, plt_strip_step *next) {
    const uint32_t t = lowest_bit(left) / 3;
    for (uint32_t r = 0; r < 3; r++) {
        plt_strip_step ahead;
        const plt_strip_step step = {(uint8_t)t, (uint8_t)r, 1, 0};
        *next = step;
        if (go_on(e, left & ~edges_of(t), next, &ahead)) {
            return;
        }
    }
}

static void try_from(const strip_edges *e, uint32_t triangle, uint32_t rotation, strip_try *now) {
    const plt_strip_step first = {(uint8_t)triangle, (uint8_t)rotation, 1, 0};
    uint32_t left = ((1u << 3 * e->count) - 1) & ~edges_of(triangle);
    now->step[0] = first;
    now->starts = 1;
    for (uint32_t i = 1; i < e->count; i++) {
        if (!go_on(e, left, &now->step[i - 1], &now->step[i])) {
            start_anew(e, left, &now->step[i]);
            now->starts++;
        }
        left &= ~edges_of(now->step[i].triangle);
    }
}

/* A strip goes on over such edges only: there are at least as many strips as groups of
 * triangles without one between them. */
static uint32_t least_starts(const strip_edges *e) {
    uint32_t left = (1u << 3 * e->count) - 1, groups = 0;
    for (; left != 0; groups++) {
        uint32_t group = edges_of(lowest_bit(left) / 3), before = 0;
        while (group != before) {
            before = group;
            for (uint32_t t = 0; t < e->count; t++) {
                const uint32_t *back = &e->back[3 * t];
                group |= (back[0] | back[1] | back[2]) & group ? edges_of(t) : 0;
            }
        }
        left &= ~group;
    }
    return groups;
}

void plt_strips_find(const uint32_t corner[][3][3], uint32_t count, plt_strip_step *step) {
    strip_try best = {{{0, 0, 0, 0}}, PLT_LEAF_TRIANGLES_MOST + 1}, now;
    strip_edges edges;
    find_back_edges(corner[0], count, &edges);
    const uint32_t least = least_starts(&edges);
    for (uint32_t i = 0; i < 3 * count && best.starts > least; i++) {
        try_from(&edges, i / 3, i % 3, &now);
        if (now.starts < best.starts) {
            best = now;
        }
    }
    for (uint32_t i = 0; i < count; i++) {
        step[i] = best.step[i];
    }
}
