/* beam_lists - pixels that the float records of lists may cover
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/footprint_corners.h"

/* Triangles that are still to be looked at. */
typedef struct rest {
    const plt_record *record;
    uint32_t lists, single;
} rest;

/* The next one that is projected. NULL: there is none. */
PLT_INLINED const plt_record *find_projected(plt_beam *b, const projector *k, rest *of,
                                             int all_deep, projected *p) {
    while (of->lists > 0) {
        const plt_record *record = of->record++;
        float q[3][3];
        PLT_UNROLLED for (int c = 0; c < 3; c++) {
            q[c][0] = plt_record_float(record, c, 0) - k->org[0];
            q[c][1] = plt_record_float(record, c, 1) - k->org[1];
            q[c][2] = plt_record_float(record, c, 2) - k->org[2];
        }
        of->lists -= (uint32_t)plt_record_is_last(record) | of->single;
        const enum projection how = project(b, k, (const float(*)[3])q, all_deep, p);
        if (how == PROJECTED) {
            return record;
        }
        if (how == NOT_PROJECTED) {
            plt_beam_test_unprojected(b, record);
        }
    }
    return NULL;
}

/* Of a field that is too wide or too narrow to project anything. */
PLT_RARELY uint32_t test_unprojected(plt_beam *b, const plt_record *begin, uint32_t lists,
                                     uint32_t single) {
    const plt_record *record = begin;
    for (; lists > 0; record++) {
        plt_beam_test_unprojected(b, record);
        lists -= (uint32_t)plt_record_is_last(record) | single;
    }
    return (uint32_t)(record - begin);
}

/* Twice, as to ask each triangle whether it is deep takes up to 6 % more; but not where
 * records under compact blocks are all there is, or code is to be small. */
static inline const plt_record *next_projected(plt_beam *b, const projector *k, rest *of,
                                               projected *p) {
#if PLT_WITH_THESIS && !PLT_SMALL_CODE
    if (b->margins.all_deep) {
        return find_projected(b, k, of, 1, p);
    }
    return find_projected(b, k, of, 0, p);
#else
    return find_projected(b, k, of, b->margins.all_deep, p);
#endif
}

uint32_t plt_beam_lists(plt_beam *b, uint32_t first, uint32_t lists, uint32_t single) {
    const plt_record *begin = &b->records[first], *record;
    rest of = {begin, lists, single};
    projector k;
    projected p;
    if (!b->margins.project) {
        return test_unprojected(b, begin, lists, single);
    }
    set_projector(&k, b);
    while ((record = next_projected(b, &k, &of, &p)) != NULL) {
        candidate triangle = {record, NULL, 0, 0};
        test_footprint(b, &triangle, &p, PLT_WITH_THESIS && !PLT_SMALL_CODE);
    }
    return (uint32_t)(of.record - begin);
}
