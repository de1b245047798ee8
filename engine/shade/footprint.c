/* footprint - pixels that float records may cover
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/footprint.h"

/* Not projected: a corner is not in front, or too far beside. A deep triangle without a column
 * or without a row is outside wherever its corners are; `all_deep`: every one is deep. */
static inline enum projection project(const plt_margins *m, const projector *k, const float q[3][3],
                                      int all_deep, projected *p) {
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
    const float left = x.least - k->margin, right = x.most + k->margin;
    const int columns = has_pixel(left, right, k->end_x);
    if (!columns && deep) {
        return OUTSIDE;
    }
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        p->y[c] = plt_along(q[c], k->row_y) * p->over[c];
    }
    const range y = range_of(p->y);
    const float top = y.least - k->margin, bottom = y.most + k->margin;
    const int rows = has_pixel(top, bottom, k->end_y);
    if (!rows && deep) {
        return OUTSIDE;
    }
    return set_rectangle(m, k, x, y, columns && rows, p);
}

static inline void test_record(plt_beam *b, const projector *k, const plt_record *record,
                               int all_deep) {
    float q[3][3];
    projected p;
    candidate triangle = {record, NULL, 0, 0};
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        q[c][0] = plt_record_float(record, c, 0) - k->org[0];
        q[c][1] = plt_record_float(record, c, 1) - k->org[1];
        q[c][2] = plt_record_float(record, c, 2) - k->org[2];
    }
    const enum projection how = project(&b->margins, k, (const float(*)[3])q, all_deep, &p);
    if (how != PROJECTED) {
        if (how == NOT_PROJECTED) {
            plt_beam_test_planes(b, record);
        }
        return;
    }
    test_footprint(b, &triangle, &p);
}

/* Of a field that is too wide or too narrow to project anything. */
PLT_RARELY uint32_t test_unprojected(plt_beam *b, const plt_record *begin, uint32_t lists,
                                     uint32_t single) {
    const plt_record *record = begin;
    for (; lists > 0; record++) {
        plt_beam_test_planes(b, record);
        lists -= (uint32_t)plt_record_is_last(record) | single;
    }
    return (uint32_t)(record - begin);
}

uint32_t plt_beam_lists(plt_beam *b, uint32_t first, uint32_t lists, uint32_t single) {
    const plt_record *begin = &b->records[first], *record = begin;
    const int all_deep = b->margins.all_deep;
    projector k;
    if (!b->margins.project) {
        return test_unprojected(b, begin, lists, single);
    }
    set_projector(&k, b);
    for (; lists > 0; record++) {
        test_record(b, &k, record, all_deep);
        lists -= (uint32_t)plt_record_is_last(record) | single;
    }
    return (uint32_t)(record - begin);
}

#if PLT_WITH_GRID
uint32_t plt_beam_references(plt_beam *b, const uint32_t *reference, uint32_t count,
                             plt_beam_marks *marks) {
    const int all_deep = b->margins.all_deep;
    projector k;
    set_projector(&k, b);
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t index = reference[i];
        if ((index & PLT_GRID_CROWDED) != 0) {
            return i;
        }
        if (marks->mailbox[index] == marks->stamp) {
            continue;
        }
        marks->mailbox[index] = marks->stamp;
        marks->met++;
        if (b->margins.project) {
            test_record(b, &k, &b->records[index], all_deep);
        } else {
            plt_beam_test_planes(b, &b->records[index]);
        }
    }
    return count;
}
#endif
