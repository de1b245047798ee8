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

/* Tests records from `first` on, `lists` lists of them, for those of `groups` that still seek a
 * hit. Returns how many there were. `longest`: at least the longest side of any's box. */
#if PLT_WITH_HULLS
uint32_t plt_records_groups(plt_packet *packet, const plt_record *first, uint32_t lists,
                            float longest, plt_mask groups); /* triangle_lanes.c */
#else
static inline uint32_t plt_records_groups(plt_packet *p, const plt_record *first, uint32_t lists,
                                          float longest, plt_mask groups) {
    const plt_record *at = first;
    for (; lists > 0; at++) {
        plt_record_groups(p, at, longest, groups);
        lists -= (uint32_t)plt_record_is_last(at);
    }
    return (uint32_t)(at - first);
}
#endif

#endif
