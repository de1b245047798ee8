/* beside - see beside.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/beside.h"

#if PLT_WITH_VERTICES

#include <string.h>

void plt_beside_set(plt_beside *b, plt_node *nodes, const plt_tree *tree, plt_refit_level *levels) {
    b->nodes = nodes;
    b->phase = PLT_BESIDE_IDLE;
    b->refit.levels = levels;
    if (nodes != NULL) { /* links, which are the same in all frames */
        memcpy(nodes, tree->nodes, (size_t)tree->node_slots * sizeof *nodes);
    }
}

static void begin(plt_beside *b, const plt_sequence *s, const plt_tree *tree, plt_node *nodes,
                  const plt_vertex_lists *shown) {
    b->coming = *shown;
    b->coming.vertices.vertex = s->vertex;
    b->refit.nodes = nodes;
    b->refit.vertices = &b->coming;
    b->refit.root = tree->root;
    plt_refit_begin(&b->refit);
    b->phase = PLT_BESIDE_REFITS;
}

int plt_beside_step(plt_beside *b, const plt_sequence *s, const plt_tree *tree,
                    const plt_vertex_lists *shown, uint32_t lists) {
    if (b->nodes == NULL || b->phase == PLT_BESIDE_READY || plt_beside_is_shown(s)) {
        return PLT_OK;
    }
    if (b->phase == PLT_BESIDE_IDLE) {
        begin(b, s, tree, b->nodes, shown);
    }
    if (plt_refit_vertices_step(&b->refit, lists) == PLT_MORE) {
        return PLT_MORE;
    }
    b->phase = PLT_BESIDE_READY;
    return PLT_OK;
}

static void swap(plt_beside *b, plt_sequence *s, plt_tree *tree, plt_vertex_lists *shown) {
    const plt_frame_vertex *old = shown->vertices.vertex;
    shown->vertices.vertex = s->vertex;
    s->base = s->vertex;
    s->vertex = (plt_frame_vertex *)(uintptr_t)old;
    s->vertices.vertex = old;
    if (b->nodes != NULL) {
        plt_node *nodes = (plt_node *)(uintptr_t)tree->nodes;
        tree->nodes = b->nodes;
        b->nodes = nodes;
    }
}

plt_box plt_beside_show(plt_beside *b, plt_sequence *s, plt_tree *tree, plt_vertex_lists *shown) {
    if (plt_beside_is_shown(s)) {
        return b->refit.box;
    }
    (void)plt_beside_step(b, s, tree, shown, UINT32_MAX);
    if (b->nodes == NULL) {
        begin(b, s, tree, (plt_node *)(uintptr_t)tree->nodes, shown);
        (void)plt_refit_vertices_step(&b->refit, UINT32_MAX);
    }
    swap(b, s, tree, shown);
    b->phase = PLT_BESIDE_IDLE;
    return b->refit.box;
}

#endif
