/* format_thesis - thesis nodes and float records; the operations of format.h
 *
 * Source: Karrenberg 2007, sections 3.1 to 3.5 and 4.1.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_FORMAT_THESIS_H
#define PLT_TRACE_FORMAT_THESIS_H

#include "engine/trace/format.h"
#include "engine/trace/leaf_records.h"
#include "engine/trace/thesis_place.h"
#include "engine/trace/treelet_entry.h"

enum { FORMAT_TIGHTENS = 0, FORMAT_LEAVES_WAIT = 1 };

typedef plt_treelet_state format_state;

/* Three lines of a leaf hold its triangles, mostly; of a node one does. Addresses are chosen by
 * arithmetic, as what a child is, is hard to foresee. */
PLT_INLINED void prefetch_child(const plt_tree *tree, uint32_t link) {
    const uintptr_t leaf = 0u - (uintptr_t)plt_link_is_leaf(link), index = plt_link_index(link);
    const uintptr_t node = (uintptr_t)tree->nodes + index * sizeof(plt_node);
    const uintptr_t record = (uintptr_t)tree->records + index * sizeof(plt_record);
    const uintptr_t at = (record & leaf) | (node & ~leaf);
    plt_prefetch((const void *)at);
    plt_prefetch((const void *)(at + (leaf & 64)));
    plt_prefetch((const void *)(at + (leaf & 128)));
}

#define FORMAT_PREFETCH_CHILD(t, link) prefetch_child(&(t)->scene->thesis, link)
#include "engine/trace/thesis_nodes.h"

static inline int format_leaf(plt_traversal *t, plt_packet *p, const format_place *place,
                              plt_mask groups) {
    const plt_record *record = &t->scene->thesis.records[plt_link_index(place->link)];
    const uint64_t tested = plt_mask_count(groups);
    const float longest = place_longest_side(place);
    t->stats.triangle_tests +=
        tested * plt_records_groups(p, record, plt_link_lists(place->link), longest, groups);
    return PLT_OK;
}

static inline uint32_t format_count(const plt_traversal *t, const format_place *place) {
    const plt_record *first = &t->scene->thesis.records[plt_link_index(place->link)];
    const plt_record *at = first;
    for (uint32_t lists = plt_link_lists(place->link); lists > 0; at++) {
        lists -= (uint32_t)plt_record_is_last(at);
    }
    return (uint32_t)(at - first);
}

static inline void format_triangle(const plt_traversal *t, const format_place *place,
                                   uint32_t index, plt_triangle *to) {
    const plt_record *record = &t->scene->thesis.records[plt_link_index(place->link) + index];
    plt_record_corners(record, to->corner);
    to->word = plt_get_u32(&record->word[9]);
    to->ids = NULL;
}

#endif
