/* vertices - see vertices.h
 *
 * Records lie in the order of the tree, so that triangles and vertices are looked up in no order.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/vertices.h"

#if PLT_LANES_REGISTERS
#include "engine/motion/least_corners.h"
#endif

static inline uint32_t id_of(const plt_record *r) {
    return plt_primitive_id(plt_get_u32(&r->word[9]));
}

/* Where triangle `id` is in the topology. */
static inline const unsigned char *topology_of(const plt_vertices *v, uint32_t id) {
    return v->topology + (size_t)((uint64_t)id * (3 * v->index_bits) >> 3);
}

#if PLT_LANES_REGISTERS

/* Triangles at a time; and those ahead of which their topology is asked for: the processor sees the
 * vertices of four coming by itself. */
enum { FOUR = 4, AHEAD = 20 };

/* Where the corners of a triangle lie, from any of them on. */
typedef struct corner_places {
    const plt_frame_vertex *at[5];
} corner_places;

PLT_INLINED void look_up(corner_places *to, const plt_record *r, const plt_vertices *v,
                         int is_near) {
    uint32_t index[3];
    if (is_near) {
        plt_vertices_of_near(v, id_of(r), index);
    } else {
        plt_vertices_of(v, id_of(r), index);
    }
    to->at[0] = to->at[3] = &v->vertex[index[0]];
    to->at[1] = to->at[4] = &v->vertex[index[1]];
    to->at[2] = &v->vertex[index[2]];
}

/* Lanes that compare as the coordinates do. */
PLT_INLINED f4 lanes_of(const plt_frame_vertex *vertex, int is_float) {
    return is_float ? f4_load((const float *)(const void *)vertex->word)
                    : f4_of_u4(u4_load(vertex->word));
}

PLT_INLINED void find_first(plt_least4 *to, const corner_places places[FOUR], int is_float) {
    plt_corner4 corner[3];
    for (int k = 0; k < 3; k++) {
        corner[k] = plt_corner4_of(
            lanes_of(places[0].at[k], is_float), lanes_of(places[1].at[k], is_float),
            lanes_of(places[2].at[k], is_float), lanes_of(places[3].at[k], is_float));
    }
    plt_least_corners(to, corner);
}

/* Its word is read before corners are written, whose fourth lane covers it for a while. */
PLT_INLINED void put_one(plt_record *r, const corner_places *from, uint32_t first,
                         uint32_t rotation, int is_float, const plt_placing *p) {
    const uint32_t rest = plt_get_u32(&r->word[9]) & ~(3u << PLT_PRIMITIVE_ROTATION_SHIFT);
    const plt_frame_vertex *const *at = from->at + first;
    plt_vertex_put(&r->word[0], at[0], is_float, p);
    plt_vertex_put(&r->word[3], at[1], is_float, p);
    plt_vertex_put(&r->word[6], at[2], is_float, p);
    plt_put_u32(&r->word[9], rest | rotation);
}

PLT_INLINED void put_four(plt_record *r, const plt_vertices *v, const plt_placing *placing,
                          int is_float, int is_near) {
    corner_places places[FOUR];
    plt_least4 least;
    PLT_UNROLLED for (int i = 0; i < FOUR; i++) {
        look_up(&places[i], r + i, v, is_near);
    }
    find_first(&least, places, is_float);
    PLT_UNROLLED for (int i = 0; i < FOUR; i++) {
        put_one(r + i, &places[i], least.first[i], least.rotation[i], is_float, placing);
    }
}

/* The few that are left. */
static void put_last(plt_record *r, uint32_t count, const plt_vertices *v, int is_float) {
    const plt_placing placing = plt_placing_of(v);
    for (uint32_t i = 0; i < count; i++) {
        corner_places places;
        look_up(&places, r + i, v, 0);
        plt_vertices_record(&r[i], plt_get_u32(&r[i].word[9]), places.at, is_float, &placing);
    }
}

PLT_INLINED void put_all(plt_record *records, uint32_t count, const plt_vertices *from,
                         int is_float, int is_near) {
    const plt_vertices v = *from; /* which no record that is written can be part of */
    const plt_placing placing = plt_placing_of(&v);
    uint32_t i = 0;
    for (; i + FOUR <= count; i += FOUR) {
        const plt_record *ahead = &records[i + AHEAD + FOUR <= count ? i + AHEAD : i];
        PLT_UNROLLED for (int k = 0; k < FOUR; k++) {
            plt_prefetch(topology_of(&v, id_of(&ahead[k])));
        }
        put_four(&records[i], &v, &placing, is_float, is_near);
    }
    put_last(&records[i], count - i, &v, is_float);
}

void plt_vertices_put(plt_record *records, uint32_t count, const plt_vertices *v) {
    const int is_float = v->lattice.bits == 0;
    if (plt_vertices_are_near(v)) {
        if (is_float) {
            put_all(records, count, v, 1, 1);
        } else {
            put_all(records, count, v, 0, 1);
        }
    } else if (is_float) {
        put_all(records, count, v, 1, 0);
    } else {
        put_all(records, count, v, 0, 0);
    }
}

#else

/* Triangles whose vertices have been asked for before their turn; and how much earlier than that
 * their topology was. */
enum { WAITING = 8, AHEAD = 8 };

/* Where the corners of a triangle lie. */
typedef struct corner_places {
    const plt_frame_vertex *at[3];
} corner_places;

/* Looks the vertices of record `i` up, and asks for them. */
static inline void look_up(corner_places *to, const plt_record *records, uint32_t i, uint32_t count,
                           const plt_vertices *v) {
    const plt_record *ahead = &records[i + AHEAD < count ? i + AHEAD : i];
    plt_prefetch(topology_of(v, id_of(ahead)));
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

#endif
