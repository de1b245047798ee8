/* vertices - see vertices.h
 *
 * Records lie in the order of the tree, so that triangles and vertices are looked up in no order.
 * The topology stays packed: it is a quarter to a half of what whole words would be, and more of
 * it is in a cache.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/vertices.h"

#include "engine/lanes/lanes.h"
#include "engine/tree/record_put.h"

/* Triangles whose topology, and half as many whose vertices are asked for before their turn. */
enum { AHEAD = 16 };

/* Word `i` of a string of them. */
static inline uint32_t index_at(const unsigned char *bits, uint64_t i, uint32_t width) {
    const uint64_t at = i * width;
    return plt_bits_get(bits + (size_t)(at >> 3), (uint32_t)(at & 7), width);
}

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

uint32_t plt_topology_refused(const unsigned char *topology, uint32_t count, uint32_t vertices) {
    const uint32_t width = plt_index_bits(vertices);
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t k = 0; k < 3; k++) {
            if (index_at(topology, 3 * (uint64_t)i + k, width) >= vertices) {
                return i;
            }
        }
    }
    return count;
}

static inline uint32_t id_of(const plt_record *r) {
    return plt_primitive_id(plt_get_u32(&r->word[9]));
}

static inline void prefetch_topology(const plt_vertices *v, const plt_record *r) {
    plt_prefetch(v->topology + (size_t)((uint64_t)id_of(r) * 3 * v->index_bits >> 3));
}

static inline void prefetch_vertices(const plt_vertices *v, const plt_record *r) {
    uint32_t index[3];
    indices_of(v, id_of(r), index);
    for (unsigned k = 0; k < 3; k++) {
        plt_prefetch(&v->vertex[index[k]]);
    }
}

static inline f4 position(const plt_vertices *v, uint32_t index, int is_float, f4 origin, f4 step) {
    const uint32_t *word = v->vertex[index].word;
    return is_float ? f4_load((const float *)(const void *)word)
                    : f4_add(origin, f4_mul(step, f4_of_u4(u4_load(word))));
}

static inline void put_all(plt_record *records, uint32_t count, const plt_vertices *v,
                           int is_float) {
    const f4 origin = f4_load(v->lattice.origin), step = f4_all(v->lattice.step);
    for (uint32_t i = 0; i < count; i++) {
        uint32_t index[3];
        float corner[12]; /* each store leaves junk that the next one covers */
        prefetch_topology(v, &records[i + AHEAD < count ? i + AHEAD : i]);
        prefetch_vertices(v, &records[i + AHEAD / 2 < count ? i + AHEAD / 2 : i]);
        indices_of(v, id_of(&records[i]), index);
        f4_store(corner, position(v, index[0], is_float, origin, step));
        f4_store(corner + 3, position(v, index[1], is_float, origin, step));
        f4_store(corner + 6, position(v, index[2], is_float, origin, step));
        plt_record_put(&records[i], corner);
    }
}

void plt_vertices_put(plt_record *records, uint32_t count, const plt_vertices *v) {
    if (v->lattice.bits == 0) {
        put_all(records, count, v, 1);
    } else {
        put_all(records, count, v, 0);
    }
}
