/* beam_strips - pixels that the triangles of a compact block's leaf may cover
 *
 * Neighbouring triangles share corners: each is read, and projected, once.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/small_stack.h"
#include "engine/shade/footprint.h"

/* Corners of a leaf, projected. */
typedef struct corners {
    plt_leaf leaf; /* the fourth word of a vertex is its depth */
    float over[PLT_LEAF_VERTICES_MOST], x[PLT_LEAF_VERTICES_MOST], y[PLT_LEAF_VERTICES_MOST];
} corners;

static inline void project_corners(const plt_beam *b, corners *to) {
    const plt_lattice *l = &b->tree->lattice;
    projector k;
    set_projector(&k, b);
    for (uint32_t i = 0; i < to->leaf.vertices; i++) {
        plt_vertex *v = &to->leaf.vertex[i];
        float q[3];
        PLT_UNROLLED for (int a = 0; a < 3; a++) {
            q[a] = plt_lattice_float(l, a, v->number[a]) - k.org[a];
        }
        v->scene[3] = plt_along(q, k.row_w);
        to->over[i] = 1.0f / v->scene[3];
        to->x[i] = plt_along(q, k.row_x) * to->over[i];
        to->y[i] = plt_along(q, b->row_y) * to->over[i];
    }
}

/* As in footprint_corners.h, but for what is the corners'. */
static inline enum projection project(const plt_beam *b, const corners *from,
                                      const uint32_t index[3], projected *p) {
    const plt_margins *m = &b->margins;
    const plt_vertex *vertex = from->leaf.vertex;
    const float depth[3] = {vertex[index[0]].scene[3], vertex[index[1]].scene[3],
                            vertex[index[2]].scene[3]};
    const int deep = m->all_deep || all_at_least(depth, m->depth);
    if (!deep && !all_at_least(depth, PLT_DEPTH_LEAST)) {
        return NOT_PROJECTED;
    }
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        p->x[c] = from->x[index[c]];
        p->y[c] = from->y[index[c]];
    }
    const range x = range_of(p->x);
    p->columns = plt_lines_between(x.least, x.most, m->lines);
    const int columns = plt_lines_any(p->columns, b->end_x);
    if (!columns && deep) {
        return OUTSIDE;
    }
    const range y = range_of(p->y);
    p->rows = plt_lines_between(y.least, y.most, m->lines);
    const int rows = plt_lines_any(p->rows, b->end_y);
    if (!rows && deep) {
        return OUTSIDE;
    }
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        p->over[c] = from->over[index[c]];
    }
    return projection_of(m, x, y, columns && rows, p);
}

/* 0: it cannot be projected, or covers whole pixels of samples. */
static inline int test_triangle(plt_beam *b, const corners *from, candidate *c) {
    const uint32_t corner = c->leaf->corner[c->triangle];
    const uint32_t index[3] = {corner & 0xFFu, corner >> 8 & 0xFFu, corner >> 16};
    projected p;
    switch (b->margins.project ? project(b, from, index, &p) : NOT_PROJECTED) {
    case PROJECTED:
        break;
    case NOT_PROJECTED:
        return 0;
    case OUTSIDE:
        return 1;
    }
    if (is_single(&p)) {
        test_single(b, c, &p);
    } else if (is_large(b, &p)) {
        return 0;
    } else {
        const rectangle r = rectangle_of(b, &p);
        test_rectangle(b, c, &p, &r);
    }
    return 1;
}

/* Returns a bit for each triangle that is left. */
PLT_APART_ON_SMALL_STACKS static unsigned test_most(plt_beam *b, const plt_geometry *g,
                                                    uint32_t first, uint32_t count) {
    corners all;
    unsigned left = 0;
    plt_leaf_read(g, first, count, &all.leaf);
    project_corners(b, &all);
    for (uint32_t i = 0; i < count; i++) {
        candidate c = {NULL, &all.leaf, i, g->first_triangle + first + i};
        left |= (unsigned)!test_triangle(b, &all, &c) << i;
    }
    return left;
}

/* A triangle of the leaf, which is read again, among the store's records. */
PLT_APART_ON_SMALL_STACKS static uint32_t make_record(plt_beam *b, const plt_geometry *g,
                                                      uint32_t first, uint32_t count, uint32_t i) {
    plt_leaf leaf;
    plt_leaf_read(g, first, count, &leaf);
    return (uint32_t)(plt_beam_store(b, &leaf, i, g->first_triangle + first + i) - b->records);
}

/* What tests of some triangles need of the stack is not below what all others do: those go as float
 * records do, and the leaf is gone by then. */
void plt_beam_strips(plt_beam *b, const plt_geometry *g, uint32_t first, uint32_t count) {
    const unsigned left = test_most(b, g, first, count);
    for (uint32_t i = 0; left >> i != 0; i++) {
        if (left >> i & 1u) {
            plt_beam_lists(b, make_record(b, g, first, count, i), 1, 1);
        }
    }
}
