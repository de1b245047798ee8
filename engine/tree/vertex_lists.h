/* vertex_lists - lists of triangles whose records are made when they are needed
 *
 * Of each triangle the arena has its vertices, which it shares with others, and at most the id word
 * of its record (record.h): where the image is mapped, words stay in its records, which nobody
 * reads but for them. Lists end where words say.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_VERTEX_LISTS_H
#define PLT_TREE_VERTEX_LISTS_H

#include "engine/tree/vertices.h"

typedef struct plt_vertex_lists {
    plt_vertices vertices; /* as they are shown */
    const uint32_t *words; /* id word of the first triangle */
    uint32_t stride;       /* from one to the next */
} plt_vertex_lists;

/* Records that are made at once, at most: two lists of four. */
enum { PLT_LISTED_MOST = 8 };

/* What a record is made of. */
typedef struct plt_listed {
    uint32_t word, index[3]; /* its id word, and vertices */
} plt_listed;

/* Triangles of a leaf that are still to be made. */
typedef struct plt_lists_ahead {
    uint32_t at, lists;
} plt_lists_ahead;

static inline uint32_t plt_vertex_lists_word(const plt_vertex_lists *from, uint32_t i) {
    return plt_get_u32(&from->words[(size_t)i * from->stride]);
}

/* The next triangle of a leaf, one at least being ahead. */
static inline void plt_vertex_lists_next(const plt_vertex_lists *from, plt_lists_ahead *ahead,
                                         plt_listed *to) {
    to->word = plt_vertex_lists_word(from, ahead->at++);
    plt_vertices_of(&from->vertices, plt_primitive_id(to->word), to->index);
    ahead->lists -= to->word >> 31; /* PLT_RECORD_LAST */
}

/* Its record. */
void plt_vertex_lists_record(const plt_vertex_lists *from, const plt_listed *listed,
                             plt_record *record);

/* Makes records of the next triangles of a leaf; goes on behind them. Returns how many; the last of
 * them ends a list in any case, and `lists` of them do. */
uint32_t plt_vertex_lists_make(const plt_vertex_lists *from, plt_lists_ahead *ahead,
                               plt_record record[PLT_LISTED_MOST], uint32_t *lists);

#endif
