/* refit_vertices - new boxes for a tree over vertices, from the vertices alone
 *
 * No record is made. On the lattice, coordinates are compared, and the least and the most of a list
 * become floats: rounding is monotone (base/lattice.h), so the box is that of the records.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/planelet_config.h"

#if PLT_WITH_VERTICES

#include "engine/base/between.h"
#include "engine/motion/node_box.h"
#include "engine/motion/refit.h"

#if PLT_LANES_REGISTERS

/* Of a vertex: a float's lanes, or whole numbers as floats. */
PLT_INLINED f4 lanes_of(const plt_frame_vertex *vertex, int is_float) {
    return is_float ? f4_load((const float *)(const void *)vertex->word)
                    : f4_of_u4(u4_load(vertex->word));
}

PLT_INLINED void add_triangle(plt_box4 *box, const plt_vertices *v, uint32_t id, int is_float) {
    uint32_t index[3];
    plt_vertices_of(v, id, index);
    const f4 p = lanes_of(&v->vertex[index[0]], is_float),
             q = lanes_of(&v->vertex[index[1]], is_float),
             s = lanes_of(&v->vertex[index[2]], is_float);
    box->lo = f4_min(box->lo, f4_min(f4_min(p, q), s));
    box->hi = f4_max(box->hi, f4_max(f4_max(p, q), s));
}

PLT_INLINED plt_box4 lists_box(const plt_vertex_lists *from, uint32_t link, int is_float) {
    const plt_vertices *v = &from->vertices;
    plt_box4 box = {f4_all(3.0e38f), f4_all(-3.0e38f)};
    uint32_t at = plt_link_index(link);
    for (uint32_t lists = plt_link_lists(link); lists > 0;) {
        const uint32_t word = plt_vertex_lists_word(from, at++);
        add_triangle(&box, v, plt_primitive_id(word), is_float);
        lists -= word >> 31; /* PLT_RECORD_LAST */
    }
    if (!is_float) {
        const f4 origin = f4_load(v->lattice.origin), step = f4_all(v->lattice.step);
        box.lo = f4_add(origin, f4_mul(step, box.lo));
        box.hi = f4_add(origin, f4_mul(step, box.hi));
    }
    return box;
}

#else

/* Floats as integers in their order (base/between.h), of zeros the positive one above. */
PLT_INLINED uint32_t key_of(uint32_t word, int is_float) {
    return is_float ? plt_float_order(word) ^ 0x80000000u : word;
}

PLT_INLINED void add_vertex(uint32_t lo[3], uint32_t hi[3], const plt_frame_vertex *vertex,
                            int is_float) {
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const uint32_t key = key_of(vertex->word[a], is_float);
        lo[a] = key < lo[a] ? key : lo[a];
        hi[a] = key > hi[a] ? key : hi[a];
    }
}

PLT_INLINED float float_of(const plt_lattice *l, int a, uint32_t key, int is_float) {
    if (is_float) {
        const uint32_t word = plt_float_order(key ^ 0x80000000u);
        float x;
        memcpy(&x, &word, sizeof x);
        return x;
    }
    return plt_lattice_float(l, a, key);
}

PLT_INLINED plt_box4 lists_box(const plt_vertex_lists *from, uint32_t link, int is_float) {
    const plt_vertices *v = &from->vertices;
    uint32_t lo[3] = {~0u, ~0u, ~0u}, hi[3] = {0, 0, 0}, at = plt_link_index(link);
    for (uint32_t lists = plt_link_lists(link); lists > 0;) {
        const uint32_t word = plt_vertex_lists_word(from, at++);
        uint32_t index[3];
        plt_vertices_of(v, plt_primitive_id(word), index);
        for (int k = 0; k < 3; k++) {
            add_vertex(lo, hi, &v->vertex[index[k]], is_float);
        }
        lists -= word >> 31; /* PLT_RECORD_LAST */
    }
    float low[4] = {0.0f}, high[4] = {0.0f};
    for (int a = 0; a < 3; a++) {
        low[a] = float_of(&v->lattice, a, lo[a], is_float);
        high[a] = float_of(&v->lattice, a, hi[a], is_float);
    }
    const plt_box4 box = {f4_load(low), f4_load(high)};
    return box;
}

#endif

PLT_INLINED plt_box4 box_of(const plt_vertex_lists *from, uint32_t link) {
    return from->vertices.lattice.bits == 0 ? lists_box(from, link, 1) : lists_box(from, link, 0);
}

#define REFIT_LISTS(job, link) box_of((job)->vertices, link)
#include "engine/motion/refit_nodes.h"

int plt_refit_vertices_step(plt_refit_job *job, uint32_t lists) {
    return step(job, lists, 0);
}

#endif
