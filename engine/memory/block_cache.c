/* block_cache - see block_cache.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/memory/block_cache.h"

void plt_block_cache_clear(plt_opened_block *cache) {
    for (unsigned i = 0; i < PLT_BLOCK_CACHE_SLOTS; i++) {
        cache[i].link = PLT_LINK_NONE;
    }
}

void plt_opened_block_set(plt_opened_block *slot, const unsigned char *bytes,
                          const plt_block_tree *tree, uint32_t link) {
    plt_lattice_box bounds;
    plt_block_open(&slot->block, bytes, tree->lattice.bits);
    plt_block_bounds(&slot->block, tree->lattice.bits, &bounds);
    plt_lattice_spread(&bounds, slot->lo, slot->hi);
    slot->link = link;
    slot->geometry_open = 0;
}

void plt_opened_block_geometry(plt_opened_block *o, const plt_block_tree *tree) {
    plt_lattice_box bounds;
    if (tree->leaf_kind == PLT_LEAF_RECORDS) {
        plt_geometry_open_counts(&o->geometry, &o->block, tree->leaf_triangles);
    } else {
        plt_block_bounds(&o->block, tree->lattice.bits, &bounds);
        plt_block_tree_frame(tree, &bounds);
        plt_geometry_open(&o->geometry, &o->block, &bounds, tree->leaf_triangles);
    }
    o->geometry_open = 1;
}
