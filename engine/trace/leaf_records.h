/* leaf_records - a packet against float records
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_LEAF_RECORDS_H
#define PLT_TRACE_LEAF_RECORDS_H

#include "engine/trace/packet.h"
#include "engine/trace/triangle.h"
#include "engine/tree/record.h"

/* Tests one record for those of `groups` that still seek a hit. `longest`: at least the
 * longest side of its box. */
static inline void plt_record_groups(plt_packet *p, const plt_record *record, float longest,
                                     plt_mask groups) {
    plt_triangle t;
    t.longest = longest;
    t.word = plt_get_u32(&record->word[9]);
    t.ids = NULL;
    plt_record_corners(record, t.corner);
    plt_triangle_groups(p, &t, p->any ? groups & p->active : groups);
}

#endif
