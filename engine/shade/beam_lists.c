/* beam_lists - pixels that the float records of lists may cover
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/footprint_record.h"

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
