/* vertex_lists - see vertex_lists.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/vertex_lists.h"

#include "engine/planelet_config.h"

#if PLT_WITH_VERTICES

/* Words, and vertices that are asked for. */
static inline uint32_t look_up(const plt_vertex_lists *from, plt_lists_ahead *ahead,
                               plt_listed to[PLT_LISTED_MOST]) {
    uint32_t count = 0;
    while (ahead->lists > 0 && count < PLT_LISTED_MOST) {
        plt_listed *l = &to[count++];
        plt_vertex_lists_next(from, ahead, l);
        for (unsigned k = 0; k < 3; k++) {
            plt_prefetch(&from->vertices.vertex[l->index[k]]);
        }
    }
    return count;
}

PLT_INLINED void make(const plt_vertices *v, const plt_listed *from, uint32_t count, plt_record *to,
                      int is_float) {
    const plt_placing placing = plt_placing_of(v);
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t *index = from[i].index;
        const plt_frame_vertex *const at[3] = {&v->vertex[index[0]], &v->vertex[index[1]],
                                               &v->vertex[index[2]]};
        plt_vertices_record(&to[i], from[i].word, at, is_float, &placing);
    }
}

uint32_t plt_vertex_lists_make(const plt_vertex_lists *from, plt_lists_ahead *ahead,
                               plt_record record[PLT_LISTED_MOST], uint32_t *lists) {
    plt_listed all[PLT_LISTED_MOST];
    const uint32_t had = ahead->lists, count = look_up(from, ahead, all);
    const uint32_t is_cut = 1 - (all[count - 1].word >> 31);
    if (from->vertices.lattice.bits == 0) {
        make(&from->vertices, all, count, record, 1);
    } else {
        make(&from->vertices, all, count, record, 0);
    }
    plt_record_set_last(&record[count - 1], 1);
    *lists = had - ahead->lists + is_cut;
    return count;
}

void plt_vertex_lists_record(const plt_vertex_lists *from, const plt_listed *listed,
                             plt_record *record) {
    if (from->vertices.lattice.bits == 0) {
        make(&from->vertices, listed, 1, record, 1);
    } else {
        make(&from->vertices, listed, 1, record, 0);
    }
}

#endif
