/* beam_lists - pixels that float records may cover
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/footprint_corners.h"

static inline void test_record(plt_beam *b, const projector *k, const plt_record *record,
                               int all_deep) {
    float q[3][3];
    candidate triangle = {record, NULL, 0, 0};
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        q[c][0] = plt_record_float(record, c, 0) - k->org[0];
        q[c][1] = plt_record_float(record, c, 1) - k->org[1];
        q[c][2] = plt_record_float(record, c, 2) - k->org[2];
    }
    test_corners(b, k, (const float(*)[3])q, &triangle, all_deep);
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
