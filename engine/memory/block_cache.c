/* block_cache - see block_cache.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/memory/block_cache.h"

#include "engine/planelet.h"

void plt_block_cache_clear(plt_opened_block *places) {
    for (unsigned i = 0; i < PLT_OPEN_BLOCKS; i++) {
        places[i].link = PLT_MISS;
    }
}

void plt_opened_block_set(plt_opened_block *place, const plt_block_tree *tree, uint32_t link) {
    plt_lattice_box frame;
    plt_block_open(&place->block, tree->bytes + plt_block_address(link), tree->lattice.bits);
    plt_block_bounds(&place->block, tree->lattice.bits, &frame);
    plt_lattice_spread(&frame, place->lo, place->hi);
    place->link = link;
    place->geometry_open = 0;
}

void plt_opened_block_geometry(plt_opened_block *o, const plt_block_tree *tree) {
    plt_lattice_box frame;
    if (tree->records != NULL) {
        plt_geometry_open_counts(&o->geometry, &o->block, tree->leaf_triangles);
    } else {
        plt_block_bounds(&o->block, tree->lattice.bits, &frame);
        plt_geometry_open(&o->geometry, &o->block, &frame, tree->leaf_triangles);
    }
    o->geometry_open = 1;
}
