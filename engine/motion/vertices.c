/* vertices - see vertices.h
 *
 * Records lie in the order of the tree, so that triangles and vertices are looked up in no order.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/vertices.h"

/* Triangles whose vertices have been asked for before their turn; and how much earlier than that
 * their topology was. */
enum { WAITING = 8, AHEAD = 8 };

static inline uint32_t id_of(const plt_record *r) {
    return plt_primitive_id(plt_get_u32(&r->word[9]));
}

/* Where the corners of a triangle lie. */
typedef struct corner_places {
    const plt_frame_vertex *at[3];
} corner_places;

/* Looks the vertices of record `i` up, and asks for them. */
static inline void look_up(corner_places *to, const plt_record *records, uint32_t i, uint32_t count,
                           const plt_vertices *v) {
    const plt_record *ahead = &records[i + AHEAD < count ? i + AHEAD : i];
    plt_prefetch(v->topology + (size_t)((uint64_t)id_of(ahead) * 3 * v->index_bits >> 3));
    uint32_t index[3];
    plt_vertices_of(v, id_of(&records[i]), index);
    for (unsigned k = 0; k < 3; k++) {
        to->at[k] = &v->vertex[index[k]];
        plt_prefetch(to->at[k]);
    }
}

static inline void put_all(plt_record *records, uint32_t count, const plt_vertices *v,
                           int is_float) {
    const plt_placing placing = plt_placing_of(v);
    corner_places places[WAITING];
    for (uint32_t i = 0; i < count && i < WAITING; i++) {
        look_up(&places[i], records, i, count, v);
    }
    for (uint32_t i = 0; i < count; i++) {
        corner_places *here = &places[i % WAITING];
        plt_vertices_record(&records[i], plt_get_u32(&records[i].word[9]), here->at, is_float,
                            &placing);
        if (i + WAITING < count) {
            look_up(here, records, i + WAITING, count, v);
        }
    }
}

void plt_vertices_put(plt_record *records, uint32_t count, const plt_vertices *v) {
    if (v->lattice.bits == 0) {
        put_all(records, count, v, 1);
    } else {
        put_all(records, count, v, 0);
    }
}
