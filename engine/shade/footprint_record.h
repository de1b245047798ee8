/* footprint_record - pixels that a float record may cover
 *
 * Inline for those who go through records: beam_lists.c through lists, beam_references.c through
 * what cells refer to. Each calls it once, which is faster by a fifth than a call is.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_FOOTPRINT_RECORD_H
#define PLT_SHADE_FOOTPRINT_RECORD_H

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

#endif
