/* beam_references - pixels that the triangles of a grid's cells may cover
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/footprint_record.h"

#if PLT_WITH_GRID

/* How many references come before one that has not been met, or is a crowded cell's. */
static inline uint32_t skip_met(const uint32_t *reference, uint32_t from, uint32_t count,
                                const plt_beam_marks *marks) {
    while (from < count && (reference[from] & PLT_GRID_CROWDED) == 0 &&
           marks->mailbox[reference[from]] == marks->stamp) {
        from++;
    }
    return from;
}

uint32_t plt_beam_references(plt_beam *b, const uint32_t *reference, uint32_t count,
                             plt_beam_marks *marks) {
    uint32_t i = skip_met(reference, 0, count, marks);
    projector k;
    if (i == count) {
        return i;
    }
    set_projector(&k, b);
    while (i < count && (reference[i] & PLT_GRID_CROWDED) == 0) {
        const plt_record *record = &b->records[reference[i]];
        marks->mailbox[reference[i]] = marks->stamp;
        marks->met++;
        if (b->margins.project) {
            test_record(b, &k, record, b->margins.all_deep);
        } else {
            plt_beam_test_unprojected(b, record);
        }
        i = skip_met(reference, i + 1, count, marks);
    }
    return i;
}

#endif
