/* block_record - see block_record.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/compact/block_record.h"

#if PLT_WITH_SURFACE && PLT_WITH_COMPACT

#include "engine/tree/canonical.h"

uint32_t plt_block_triangles(const plt_block_tree *tree, uint32_t address, uint32_t *first,
                             uint32_t *count) {
    plt_block block;
    plt_block_open(&block, tree->bytes + address, tree->lattice.bits);
    *first = *count = 0;
    if (block.geometry_bytes > 0) {
        plt_geometry g;
        plt_geometry_open_counts(&g, &block, tree->leaf_triangles);
        *first = g.first_triangle;
        *count = g.triangles;
    }
    return address + plt_block_bytes(&block);
}

/* The strip that a triangle is of, up to it: every leaf begins one, so it is not long. */
static uint32_t read_strip(const plt_geometry *g, uint32_t triangle, plt_leaf *leaf) {
    uint32_t begin = triangle;
    while (begin > 0 && !plt_bits_short(g->bytes, g->starts + begin, 1)) {
        begin--;
    }
    plt_leaf_read(g, begin, triangle - begin + 1, leaf);
    return triangle - begin;
}

void plt_leaf_record(const plt_lattice *lattice, const plt_leaf *leaf, uint32_t triangle,
                     plt_record *record) {
    const uint32_t *position[3];
    uint64_t key[3];
    for (unsigned c = 0; c < 3; c++) {
        position[c] = leaf->vertex[plt_leaf_corner(leaf, triangle, c)].number;
        key[c] = plt_lattice_key(position[c]);
    }
    uint32_t from = plt_canonical_first(key[1] < key[0], key[2] < key[0], key[2] < key[1]);
    for (unsigned c = 0; c < 3; c++) {
        for (int a = 0; a < 3; a++) {
            plt_put_float(&record->word[3 * c + (unsigned)a],
                          plt_lattice_float(lattice, a, position[from][a]));
        }
        from = from < 2 ? from + 1 : 0;
    }
}

void plt_block_record(const plt_block_tree *tree, uint32_t address, uint32_t triangle,
                      plt_record *record) {
    plt_block block;
    plt_lattice_box bounds;
    plt_geometry g;
    plt_leaf leaf;
    plt_block_open(&block, tree->bytes + address, tree->lattice.bits);
    plt_block_bounds(&block, tree->lattice.bits, &bounds);
    if (tree->leaf_kind == PLT_LEAF_RECORDS) {
        plt_geometry_open_counts(&g, &block, tree->leaf_triangles);
        *record = tree->records[g.first_triangle + triangle];
        return;
    }
    plt_geometry_open(&g, &block, &bounds, tree->leaf_triangles);
    plt_leaf_record(&tree->lattice, &leaf, read_strip(&g, triangle, &leaf), record);
    plt_put_u32(&record->word[9],
                plt_primitive_word_find(tree->ids.bytes != NULL ? &tree->ids : NULL,
                                        g.first_triangle + triangle));
}

#endif
