/* format_vertices - thesis nodes over triangles whose records are made at each visit of a leaf;
 * the operations of format.h
 *
 * Boxes are those of nodes over records, records the same bits, and so hits are the same.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_FORMAT_VERTICES_H
#define PLT_TRACE_FORMAT_VERTICES_H

#include "engine/trace/format.h"
#include "engine/trace/leaf_records.h"
#include "engine/trace/thesis_place.h"
#include "engine/trace/vertices_entry.h"

enum { FORMAT_TIGHTENS = 0, FORMAT_LEAVES_WAIT = 1 };

typedef plt_vertices_state format_state;

/* A line is enough for a node, and for the words of a leaf. */
PLT_INLINED void prefetch_child(const plt_traversal *t, uint32_t link) {
    const plt_vertex_lists *lists = &t->scene->vertices;
    const uint32_t index = plt_link_index(link);
    plt_prefetch(plt_link_is_leaf(link) ? (const void *)&lists->words[(size_t)index * lists->stride]
                                        : (const void *)&t->scene->thesis.nodes[index]);
}

#define FORMAT_PREFETCH_CHILD(t, link) prefetch_child(t, link)
#include "engine/trace/thesis_nodes.h"

static inline int format_leaf(plt_traversal *t, plt_packet *p, const format_place *place,
                              plt_mask groups) {
    format_state *s = (format_state *)t->state;
    plt_lists_ahead ahead = {plt_link_index(place->link), plt_link_lists(place->link)};
    const uint64_t tested = plt_mask_count(groups);
    const float longest = place_longest_side(place);
    while (ahead.lists > 0) {
        uint32_t lists;
        plt_vertex_lists_make(&t->scene->vertices, &ahead, s->record, &lists);
        t->stats.triangle_tests +=
            tested * plt_records_groups(p, s->record, lists, longest, groups);
    }
    return PLT_OK;
}

#endif
