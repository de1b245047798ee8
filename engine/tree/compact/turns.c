/* turns - see turns.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/compact/turns.h"

#include "engine/planelet_config.h"
#include "engine/tree/canonical.h"

void plt_leaf_read_next(const plt_geometry *g, plt_leaf_place *at, uint32_t number, int pair,
                        plt_leaf *leaf) {
    at->count = 1 + (pair ? g->k : 0);
    for (uint32_t s = 0; s < plt_geometry_count_strings(g->k); s++) {
        at->count += plt_bits_short(g->bytes, g->counts + s * g->leaves + number, 1) << s;
    }
    plt_leaf_read_at(g, at, leaf);
}

/* At bit `bit` of `ids`. */
static void put_rotation(unsigned char *ids, uint64_t bit, uint32_t rotation) {
    unsigned char *byte = ids + (size_t)(bit >> 3);
    const uint32_t shift = (uint32_t)(bit & 7);
    byte[0] = (unsigned char)((byte[0] & ~(3u << shift)) | rotation << shift);
    if (shift == 7) { /* else the next byte may be another part's */
        byte[1] = (unsigned char)((byte[1] & ~1u) | rotation >> 1);
    }
}

static void turn(const plt_geometry *g, const plt_leaf_place *at, const plt_leaf *leaf,
                 unsigned char *ids, uint64_t bit, uint32_t bits) {
    const uint32_t turns = g->positions + g->vertices * g->vertex_bits + 2 * at->first;
    for (uint32_t i = 0; i < at->count; i++, bit += bits) {
        uint64_t key[3];
        for (unsigned c = 0; c < 3; c++) {
            key[c] = plt_lattice_key(leaf->vertex[plt_leaf_corner(leaf, i, c)].number);
        }
        const uint32_t first =
            plt_canonical_first(key[1] < key[0], key[2] < key[0], key[2] < key[1]);
        put_rotation(ids, bit, (plt_bits_short(g->bytes, turns + 2 * i, 2) + 3 - first) % 3);
    }
}

void plt_leaf_turn(const plt_geometry *g, const plt_leaf_place *at, const plt_leaf *leaf,
                   unsigned char *ids, uint32_t bits) {
    turn(g, at, leaf, ids, (uint64_t)(g->first_triangle + at->first) * bits, bits);
}

#if PLT_WITH_STILLS
void plt_block_turn(const plt_block *b, const plt_geometry *g, unsigned char *ids, uint32_t bits) {
    const uint32_t begin = (uint32_t)((uint64_t)g->first_triangle * bits & 7);
    plt_leaf_place at = {0, 0, 0, 0};
    uint32_t number = 0;
    for (uint32_t slot = 0; slot < 2 * b->nodes; slot++) {
        if (plt_block_kind(b, slot) == PLT_SLOT_LEAF) {
            plt_leaf leaf;
            plt_leaf_read_next(g, &at, number++, (int)(b->pair[slot >> 5] >> (slot & 31) & 1u),
                               &leaf);
            turn(g, &at, &leaf, ids, begin + (uint64_t)at.first * bits, bits);
            plt_leaf_pass(g, &at, &leaf);
        }
    }
}
#endif
