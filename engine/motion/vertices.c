/* vertices - see vertices.h
 *
 * Records lie in the order of the tree, so that triangles and vertices are looked up in no order.
 * The topology stays packed: it is a quarter to a half of what whole words would be, and more of
 * it is in a cache.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/vertices.h"

#include "engine/motion/words.h"
#include "engine/tree/record_put.h"

/* Triangles whose vertices have been asked for before their turn; and how much earlier than that
 * their topology was. */
enum { WAITING = 8, AHEAD = 8 };

/* The three of triangle `id`. */
static inline void indices_of(const plt_vertices *v, uint32_t id, uint32_t index[3]) {
    const uint32_t width = v->index_bits;
    const uint64_t at = (uint64_t)id * 3 * width;
    const unsigned char *bits = v->topology + (size_t)(at >> 3);
    const uint32_t first = (uint32_t)(at & 7);
#if UINTPTR_MAX > 0xFFFFFFFFu
    if (3 * width <= PLT_BITS_LONG) {
        const uint64_t all = plt_bits_long(bits, first), mask = plt_low_bits(width);
        index[0] = (uint32_t)(all & mask);
        index[1] = (uint32_t)(all >> width & mask);
        index[2] = (uint32_t)(all >> 2 * width & mask);
        return;
    }
#endif
    for (uint32_t k = 0; k < 3; k++) {
        index[k] = plt_bits_get(bits, first + k * width, width);
    }
}

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
    indices_of(v, id_of(&records[i]), index);
    for (unsigned k = 0; k < 3; k++) {
        to->at[k] = &v->vertex[index[k]];
        plt_prefetch(to->at[k]);
    }
}

/* Canonical order on the lattice is that of its coordinates. */
static inline int is_below(const plt_frame_vertex *a, const plt_frame_vertex *b, int is_float) {
    if (is_float) {
        return plt_corner_below((const float *)(const void *)a->word,
                                (const float *)(const void *)b->word);
    }
    const int y =
        (a->word[1] < b->word[1]) | ((a->word[1] == b->word[1]) & (a->word[2] < b->word[2]));
    return (a->word[0] < b->word[0]) | ((a->word[0] == b->word[0]) & y);
}

/* Index of the least corner: mostly, x alone decides. */
static inline uint32_t first_of(const plt_frame_vertex *a, const plt_frame_vertex *b,
                                const plt_frame_vertex *c, int is_float) {
    float x[3];
    for (unsigned k = 0; k < 3; k++) {
        const uint32_t word = (k == 0 ? a : k == 1 ? b : c)->word[0];
        if (is_float) {
            memcpy(&x[k], &word, sizeof word);
        } else {
            x[k] = (float)(int32_t)word;
        }
    }
    if ((x[0] == x[1]) | (x[0] == x[2]) | (x[1] == x[2])) {
        return plt_canonical_first(is_below(b, a, is_float), is_below(c, a, is_float),
                                   is_below(c, b, is_float));
    }
    return plt_canonical_first(x[1] < x[0], x[2] < x[0], x[2] < x[1]);
}

static inline f4 position(const plt_frame_vertex *vertex, int is_float, f4 origin, f4 step) {
    return is_float ? f4_load((const float *)(const void *)vertex->word)
                    : f4_add(origin, f4_mul(step, f4_of_u4(u4_load(vertex->word))));
}

/* Each corner's fourth lane is covered by what is written next. */
static inline void put_record(plt_record *r, const corner_places *places, int is_float, f4 origin,
                              f4 step) {
    static const uint8_t turned[3][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}};
    const plt_frame_vertex *const *at = places->at;
    const uint32_t first = first_of(at[0], at[1], at[2], is_float);
    const uint32_t word = plt_get_u32(&r->word[9]) & ~(3u << PLT_PRIMITIVE_ROTATION_SHIFT);
    for (unsigned k = 0; k < 3; k++) {
        plt_words_store(&r->word[3 * k], position(at[turned[first][k]], is_float, origin, step));
    }
    plt_put_u32(&r->word[9], word | plt_canonical_rotation(first) << PLT_PRIMITIVE_ROTATION_SHIFT);
}

static inline void put_all(plt_record *records, uint32_t count, const plt_vertices *v,
                           int is_float) {
    const f4 origin = f4_load(v->lattice.origin), step = f4_all(v->lattice.step);
    corner_places places[WAITING];
    for (uint32_t i = 0; i < count && i < WAITING; i++) {
        look_up(&places[i], records, i, count, v);
    }
    for (uint32_t i = 0; i < count; i++) {
        corner_places *here = &places[i % WAITING];
        put_record(&records[i], here, is_float, origin, step);
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
