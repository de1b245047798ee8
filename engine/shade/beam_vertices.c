/* beam_vertices - the beam on its way through thesis nodes over vertices
 *
 * Corners of a leaf are projected as they are found; a triangle becomes a record, in the beam's
 * store, when a pixel may have it.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/planelet_config.h"

#if PLT_WITH_VERTICES

#include "engine/tree/vertex_lists.h"

#define FOOTPRINT_OF_VERTICES 1
#include "engine/shade/footprint_corners.h"

/* Seen from the eye; in the order of the mesh. */
PLT_INLINED void find_corner(const plt_frame_vertex *vertex, const projector *k,
                             const plt_placing *p, int is_float, float q[3]) {
#if PLT_LANES_REGISTERS
    float at[4];
    f4_store(at, plt_vertex_position(vertex, is_float, p));
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        q[a] = at[a] - k->org[a];
    }
#else
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        q[a] = plt_vertex_coordinate(vertex, a, is_float, p) - k->org[a];
    }
#endif
}

PLT_INLINED void test_lists(plt_beam *b, const plt_vertex_lists *from, plt_lists_ahead *ahead,
                            int is_float) {
    const plt_frame_vertex *vertex = from->vertices.vertex;
    const plt_placing placing = plt_placing_of(&from->vertices);
    const int all_deep = b->margins.all_deep;
    projector k;
    candidate c = {.lists = from};
    set_projector(&k, b);
    while (ahead->lists > 0) {
        float q[3][3];
        plt_vertex_lists_next(from, ahead, &c.listed);
        c.record = NULL;
        if (!b->margins.project) {
            plt_beam_test_unprojected(b, record_of(b, &c));
            continue;
        }
        PLT_UNROLLED for (int i = 0; i < 3; i++) {
            find_corner(&vertex[c.listed.index[i]], &k, &placing, is_float, q[i]);
        }
        test_corners(b, &k, (const float(*)[3])q, &c, all_deep);
    }
}

static uint32_t test_leaf(plt_beam *b, const plt_vertex_lists *from, uint32_t first,
                          uint32_t lists) {
    plt_lists_ahead ahead = {first, lists};
    if (from->vertices.lattice.bits == 0) {
        test_lists(b, from, &ahead, 1);
    } else {
        test_lists(b, from, &ahead, 0);
    }
    return ahead.at - first;
}

#define BEAM_TRACE plt_beam_trace_vertices
#define BEAM_LEAF(b, t, first, lists) test_leaf(b, &(t)->scene->vertices, first, lists)
#include "engine/shade/beam_nodes.h"

#endif
