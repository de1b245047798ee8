/* vertices - triangles as three numbers of shared vertices, and the records made of them
 *
 * A record that is made has the corners of its triangle in canonical order, and their rotation
 * (record.h): the same bits whenever it is made, and wherever.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_VERTICES_H
#define PLT_TREE_VERTICES_H

#include "engine/base/bits.h"
#include "engine/base/lattice.h"
#include "engine/lanes/lanes.h"
#include "engine/tree/record_put.h"
#include "engine/tree/words.h"

/* Coordinates of a vertex: on the lattice, or the bits of floats. */
typedef struct plt_frame_vertex {
    uint32_t word[3];
} plt_frame_vertex;

typedef struct plt_vertices {
    const plt_frame_vertex *vertex; /* four bytes more can be read behind the last one */
    const unsigned char *topology;  /* SPEC.md, section 4.15 */
    uint32_t index_bits;            /* of a vertex's number there */
    plt_lattice lattice;            /* bits 0: vertices are floats */
} plt_vertices;

/* Whether the three numbers of a triangle are in one word from the byte that they begin in. */
static inline int plt_vertices_are_near(const plt_vertices *v) {
    return UINTPTR_MAX > 0xFFFFFFFFu && 3 * v->index_bits <= PLT_BITS_LONG;
}

/* Of triangle `id`, where they are. */
static inline void plt_vertices_of_near(const plt_vertices *v, uint32_t id, uint32_t index[3]) {
    const uint32_t width = v->index_bits;
    const uint64_t at = (uint64_t)id * (3 * width), mask = plt_low_bits(width);
    const uint64_t all = plt_bits_long(v->topology + (size_t)(at >> 3), (uint32_t)(at & 7));
    index[0] = (uint32_t)(all & mask);
    index[1] = (uint32_t)(all >> width & mask);
    index[2] = (uint32_t)(all >> 2 * width & mask);
}

/* The vertices of triangle `id`. The topology stays packed: it is a quarter to a half of what whole
 * words would be, and more of it is in a cache. */
static inline void plt_vertices_of(const plt_vertices *v, uint32_t id, uint32_t index[3]) {
    const uint32_t width = v->index_bits;
    const uint64_t at = (uint64_t)id * 3 * width;
    const unsigned char *bits = v->topology + (size_t)(at >> 3);
    const uint32_t first = (uint32_t)(at & 7);
#if UINTPTR_MAX > 0xFFFFFFFFu
    if (plt_vertices_are_near(v)) {
        plt_vertices_of_near(v, id, index);
        return;
    }
#else
    if (width <= PLT_BITS_SHORT) {
        for (uint32_t k = 0; k < 3; k++) {
            index[k] = plt_bits_short(bits, first + k * width, width);
        }
        return;
    }
#endif
    for (uint32_t k = 0; k < 3; k++) {
        index[k] = plt_bits_get(bits, first + k * width, width);
    }
}

/* Canonical order on the lattice is that of its coordinates. */
static inline int plt_vertex_below(const plt_frame_vertex *a, const plt_frame_vertex *b,
                                   int is_float) {
    if (is_float) {
        return plt_corner_below((const float *)(const void *)a->word,
                                (const float *)(const void *)b->word);
    }
    const int y =
        (a->word[1] < b->word[1]) | ((a->word[1] == b->word[1]) & (a->word[2] < b->word[2]));
    return (a->word[0] < b->word[0]) | ((a->word[0] == b->word[0]) & y);
}

/* Index of the least corner: mostly, x alone decides. */
static inline uint32_t plt_vertices_first(const plt_frame_vertex *a, const plt_frame_vertex *b,
                                          const plt_frame_vertex *c, int is_float) {
    const uint32_t x[3] = {a->word[0], b->word[0], c->word[0]};
    float f[3];
    memcpy(f, x, sizeof f);
    if (is_float ? (f[0] == f[1]) | (f[0] == f[2]) | (f[1] == f[2])
                 : (x[0] == x[1]) | (x[0] == x[2]) | (x[1] == x[2])) {
        return plt_canonical_first(plt_vertex_below(b, a, is_float),
                                   plt_vertex_below(c, a, is_float),
                                   plt_vertex_below(c, b, is_float));
    }
    return is_float ? plt_canonical_first(f[1] < f[0], f[2] < f[0], f[2] < f[1])
                    : plt_canonical_first(x[1] < x[0], x[2] < x[0], x[2] < x[1]);
}

/* How coordinates become positions. */
#if PLT_LANES_REGISTERS
typedef struct plt_placing {
    f4 origin, step;
} plt_placing;

static inline plt_placing plt_placing_of(const plt_vertices *v) {
    const plt_placing p = {f4_load(v->lattice.origin), f4_all(v->lattice.step)};
    return p;
}

static inline f4 plt_vertex_position(const plt_frame_vertex *vertex, int is_float,
                                     const plt_placing *p) {
    return is_float ? f4_load((const float *)(const void *)vertex->word)
                    : f4_add(p->origin, f4_mul(p->step, f4_of_u4(u4_load(vertex->word))));
}

/* The fourth lane of a corner is covered by what is written next. */
static inline void plt_vertex_put(uint32_t to[3], const plt_frame_vertex *vertex, int is_float,
                                  const plt_placing *p) {
    plt_words_store(to, plt_vertex_position(vertex, is_float, p));
}
#else
typedef struct plt_placing {
    float origin[3], step;
} plt_placing;

static inline plt_placing plt_placing_of(const plt_vertices *v) {
    const plt_lattice *l = &v->lattice;
    const plt_placing p = {{l->origin[0], l->origin[1], l->origin[2]}, l->step};
    return p;
}

/* As plt_lattice_float. */
static inline float plt_vertex_coordinate(const plt_frame_vertex *vertex, int axis, int is_float,
                                          const plt_placing *p) {
    const uint32_t word = vertex->word[axis];
    float x;
    memcpy(&x, &word, sizeof x);
    return is_float ? x : p->origin[axis] + p->step * (float)(int32_t)word;
}

static inline void plt_vertex_put(uint32_t to[3], const plt_frame_vertex *vertex, int is_float,
                                  const plt_placing *p) {
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        plt_put_float(&to[a], plt_vertex_coordinate(vertex, a, is_float, p));
    }
}
#endif

/* `at`: its three vertices. `word`: the record's, whose rotation is not looked at. */
static inline void plt_vertices_record(plt_record *r, uint32_t word,
                                       const plt_frame_vertex *const at[3], int is_float,
                                       const plt_placing *p) {
    static const uint8_t turned[3][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}};
    const uint32_t first = plt_vertices_first(at[0], at[1], at[2], is_float);
    const uint32_t rest = word & ~(3u << PLT_PRIMITIVE_ROTATION_SHIFT);
    for (unsigned k = 0; k < 3; k++) {
        plt_vertex_put(&r->word[3 * k], at[turned[first][k]], is_float, p);
    }
    plt_put_u32(&r->word[9], rest | plt_canonical_rotation(first) << PLT_PRIMITIVE_ROTATION_SHIFT);
}

#endif
