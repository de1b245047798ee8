/* wave_leaf_compact - see wave_leaf_compact.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/wave_leaf_compact.h"

#include "engine/planelet_config.h"

#if PLT_WITH_WAVE_COMPACT

#include "engine/trace/leaf_block.h"
#include "engine/trace/leaf_compact.h"
#include "engine/tree/compact/raw_block.h"

/* Of a block what opening its geometry part asks for, and the leaf's rank in it. */
static plt_leaf_rank count_masks(const unsigned char *bytes, uint32_t bits,
                                 const plt_wave_leaf *leaf, plt_block *b) {
    const uint32_t slot = leaf->slot, slots = 2 * leaf->nodes;
    const unsigned char *at = bytes + plt_raw_masks_at(bits);
    const plt_raw_masks masks = plt_raw_masks_get(at, leaf->nodes);
    const uint32_t pairs = plt_raw_rank(masks.pair, slot);
    const plt_leaf_rank rank = {slot - plt_raw_rank(masks.no_leaf, slot), pairs,
                                (int)(plt_raw_rank(masks.pair, slot + 1) - pairs)};
    b->geometry = bytes + plt_block_node_bytes(leaf->link);
    b->geometry_bytes = (plt_get_u32(bytes) >> 6 & 0x3FFu) * 8;
    b->leaves = slots - plt_raw_rank(masks.no_leaf, slots);
    b->pairs = plt_raw_rank(masks.pair, slots);
    return rank;
}

/* Triangles first .. first + count - 1 of a leaf; lanes behind them are the first one again. */
static void set_strips(const plt_leaf *leaf, uint32_t first, uint32_t count, plt_bvh4_block *to) {
    f4 row[3][4];
    PLT_UNROLLED for (unsigned lane = 0; lane < 4; lane++) {
        const uint32_t triangle = first + (lane < count ? lane : 0);
        PLT_UNROLLED for (unsigned c = 0; c < 3; c++) {
            row[c][lane] = f4_load(leaf->vertex[plt_leaf_corner(leaf, triangle, c)].scene);
        }
    }
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        f4_transpose(&row[c][0], &row[c][1], &row[c][2], &row[c][3]);
        PLT_UNROLLED for (int a = 0; a < 3; a++) {
            f4_store(to->corner[c][a], row[c][a]);
        }
    }
    plt_block_count(to, count);
}

static void set_records(const plt_record *first, uint32_t count, plt_bvh4_block *to) {
    const plt_record *at[4];
    PLT_UNROLLED for (unsigned lane = 0; lane < 4; lane++) {
        at[lane] = lane < count ? first + lane : first;
    }
    plt_block_of_records(to, at, count);
}

static uint32_t of_block(uint32_t count, uint32_t block) {
    const uint32_t left = count - 4 * block;
    return left < 4 ? left : 4;
}

static plt_wave_leaf_run load_strips(const plt_block_tree *tree, const plt_wave_leaf *leaf,
                                     const unsigned char *bytes, plt_bvh4_block *to) {
    plt_block b;
    plt_lattice_box bounds;
    plt_geometry g;
    plt_leaf_place at;
    plt_leaf strips;
    const plt_leaf_rank rank = count_masks(bytes, tree->lattice.bits, leaf, &b);
    plt_block_bounds_at(bytes, tree->lattice.bits, &bounds);
    plt_block_tree_frame(tree, &bounds);
    plt_geometry_open_leaf(&g, &b, &bounds, tree->leaf_triangles, &rank, &at);
    plt_leaf_read_at(&g, &at, &strips);
    plt_leaf_place_corners(&strips, at.count, &tree->lattice);
    for (uint32_t i = 0; 4 * i < at.count; i++) {
        set_strips(&strips, 4 * i, of_block(at.count, i), &to[i]);
    }
    const plt_wave_leaf_run run = {g.first_triangle + at.first, at.count};
    return run;
}

static plt_wave_leaf_run load_records(const plt_block_tree *tree, const plt_wave_leaf *leaf,
                                      const unsigned char *bytes, plt_bvh4_block *to) {
    plt_block b;
    plt_geometry g;
    plt_wave_leaf_run run;
    const plt_leaf_rank rank = count_masks(bytes, tree->lattice.bits, leaf, &b);
    plt_geometry_open_counts(&g, &b, tree->leaf_triangles);
    run.first = g.first_triangle;
    run.first += plt_leaf_find(&g, rank.leaf, rank.pairs, rank.pair, &run.count);
    for (uint32_t i = 0; 4 * i < run.count; i++) {
        set_records(&tree->records[run.first + 4 * i], of_block(run.count, i), &to[i]);
    }
    return run;
}

plt_wave_leaf_run plt_wave_leaf_load(const plt_block_tree *tree, const plt_wave_leaf *leaf,
                                     plt_bvh4_block to[PLT_WAVE_LEAF_BLOCKS_MOST]) {
    const unsigned char *bytes = tree->bytes + plt_block_address(leaf->link);
    return tree->leaf_kind == PLT_LEAF_STRIPS ? load_strips(tree, leaf, bytes, to)
                                              : load_records(tree, leaf, bytes, to);
}

void plt_wave_leaf_words(const plt_block_tree *tree, const plt_wave_leaf_run *run, uint32_t number,
                         plt_bvh4_block *block) {
    const plt_primitive_ids *ids = tree->ids.bytes == NULL ? NULL : &tree->ids;
    const uint32_t count = of_block(run->count, number);
    if (tree->leaf_kind != PLT_LEAF_STRIPS) {
        return; /* records have their own */
    }
    for (uint32_t lane = 0; lane < count; lane++) {
        block->word[lane] = plt_primitive_word_find(ids, run->first + 4 * number + lane);
    }
}

#endif
