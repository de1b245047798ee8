/* beam_strips - pixels that the triangles of a compact block's leaf may cover
 *
 * Neighbouring triangles share corners: each is read, and projected, once.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/footprint.h"

/* Corners of a leaf, projected. */
typedef struct corners {
    float depth[PLT_LEAF_VERTICES_MOST], over[PLT_LEAF_VERTICES_MOST];
    float x[PLT_LEAF_VERTICES_MOST], y[PLT_LEAF_VERTICES_MOST];
} corners;

static inline void project_corners(const plt_beam *b, const projector *k, const plt_leaf *leaf,
                                   corners *to) {
    const plt_lattice *l = &b->tree->lattice;
    for (uint32_t i = 0; i < leaf->vertices; i++) {
        float q[3];
        PLT_UNROLLED for (int a = 0; a < 3; a++) {
            q[a] = plt_lattice_float(l, a, leaf->vertex[i].number[a]) - k->org[a];
        }
        to->depth[i] = plt_along(q, k->row_w);
        to->over[i] = 1.0f / to->depth[i];
        to->x[i] = plt_along(q, k->row_x) * to->over[i];
        to->y[i] = plt_along(q, b->row_y) * to->over[i];
    }
}

/* As in footprint_corners.h, but for what is the corners'. */
static inline enum projection project(const plt_beam *b, const corners *from,
                                      const uint32_t index[3], projected *p) {
    const plt_margins *m = &b->margins;
    const float depth[3] = {from->depth[index[0]], from->depth[index[1]], from->depth[index[2]]};
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

static inline void test_triangle(plt_beam *b, const corners *from, candidate *c) {
    const uint32_t corner = c->leaf->corner[c->triangle];
    const uint32_t index[3] = {corner & 0xFFu, corner >> 8 & 0xFFu, corner >> 16};
    projected p;
    switch (b->margins.project ? project(b, from, index, &p) : NOT_PROJECTED) {
    case PROJECTED:
        test_footprint(b, c, &p, 1);
        break;
    case NOT_PROJECTED:
        plt_beam_test_unprojected(b, record_of(b, c));
        break;
    case OUTSIDE:
        break;
    }
}

void plt_beam_strips(plt_beam *b, const plt_geometry *g, uint32_t first, uint32_t count) {
    plt_leaf leaf;
    corners all;
    projector k;
    set_projector(&k, b);
    plt_leaf_read(g, first, count, &leaf);
    project_corners(b, &k, &leaf, &all);
    for (uint32_t i = 0; i < count; i++) {
        candidate c = {NULL, &leaf, i, g->first_triangle + first + i};
        test_triangle(b, &all, &c);
    }
}
