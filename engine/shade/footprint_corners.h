/* footprint_corners - pixels that a triangle of float corners may cover
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_FOOTPRINT_CORNERS_H
#define PLT_SHADE_FOOTPRINT_CORNERS_H

#include "engine/shade/footprint.h"

/* Not projected: a corner is not in front, or too far beside. A deep triangle without a column
 * or without a row is outside wherever its corners are; `all_deep`: every one is deep. */
PLT_INLINED enum projection project(const plt_beam *b, const projector *k, const float q[3][3],
                                    int all_deep, projected *p) {
    const plt_margins *m = &b->margins;
    float depth[3];
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        depth[c] = plt_along(q[c], k->row_w);
    }
    const int deep = all_deep || all_at_least(depth, m->depth);
    if (!deep && !all_at_least(depth, PLT_DEPTH_LEAST)) {
        return NOT_PROJECTED;
    }
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        p->over[c] = 1.0f / depth[c];
        p->x[c] = plt_along(q[c], k->row_x) * p->over[c];
    }
    const range x = range_of(p->x);
    p->columns = plt_lines_between(x.least, x.most, m->lines);
    const int columns = plt_lines_any(p->columns, b->end_x);
    if (!columns && deep) {
        return OUTSIDE;
    }
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        p->y[c] = plt_along(q[c], b->row_y) * p->over[c];
    }
    const range y = range_of(p->y);
    p->rows = plt_lines_between(y.least, y.most, m->lines);
    const int rows = plt_lines_any(p->rows, b->end_y);
    if (!rows && deep) {
        return OUTSIDE;
    }
    return projection_of(m, x, y, columns && rows, p);
}

/* `q`: the candidate's corners, seen from the eye. */
static inline void test_corners(plt_beam *b, const projector *k, const float q[3][3], candidate *c,
                                int all_deep) {
    projected p;
    const enum projection how = project(b, k, q, all_deep, &p);
    if (how != PROJECTED) {
        if (how == NOT_PROJECTED) {
            plt_beam_test_unprojected(b, record_of(b, c));
        }
        return;
    }
    test_footprint(b, c, &p, 1);
}

#endif
