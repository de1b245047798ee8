/* block - a compact treelet: up to 64 nodes in a few hundred bytes
 *
 * A block is self-contained: its bounds (the exact box of its root on the lattice,
 * the scene's quantisation grid), the kinds of all children as masks, five owner bits
 * and six plane bytes per node, links to the blocks behind its edges, then the
 * geometry part. What a child is and where it lies follows from ranks: counting ones
 * in the masks. SPEC.md, section 4, has every bit.
 *
 * Slot s = 2 * node + child. A child is inner (a node of this block), an edge
 * (the root of another block) or a leaf: one list of 1 .. K triangles, or a pair of
 * lists, K + 1 .. 2 K triangles (the thesis's intermediate node).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_COMPACT_BLOCK_H
#define PLT_TREE_COMPACT_BLOCK_H

#include <stdint.h>

#include "engine/base/bits.h"
#include "engine/base/lattice.h"
#include "engine/image/items.h"

#define PLT_BLOCK_GEOMETRY_MOST 8184 /* bytes */
#define PLT_BLOCK_HEADER_BYTES 4

/* A link: block address / 8 in bits 0 .. 23, bytes of its nodes part / 4 above. */
static inline uint32_t plt_block_link(uint32_t address, uint32_t node_bytes) {
    return address / 8 | node_bytes / 4 << 24;
}

static inline uint32_t plt_block_address(uint32_t link) {
    return (link & 0xFFFFFFu) * 8;
}

static inline uint32_t plt_block_node_bytes(uint32_t link) {
    return (link >> 24) * 4;
}

enum plt_slot_kind { PLT_SLOT_INNER, PLT_SLOT_EDGE, PLT_SLOT_LEAF };

/* An open block: where its parts are, and the masks with the ones before each
 * word; words behind the last slot are not set. What is neither inner nor an edge
 * is a leaf. */
typedef struct plt_block {
    const unsigned char *bytes; /* of the block */
    const unsigned char *owners, *planes, *links, *geometry;
    uint32_t nodes, node_bytes, geometry_bytes, edges, leaves, pairs;
    uint32_t mask[2][4];  /* PLT_SLOT_INNER, PLT_SLOT_EDGE */
    uint32_t pair[4];     /* leaves that are pairs */
    uint8_t before[2][4]; /* ones of mask[k] in the words before */
    uint8_t pairs_before[4];
} plt_block;

/* Bounds are six coordinates of so many bits. */
static inline uint32_t plt_block_bounds_width(uint32_t bits) {
    return bits <= 16 ? 16 : 21;
}

static inline uint32_t plt_block_bounds_bytes(uint32_t bits) {
    return bits <= 16 ? 12 : 16;
}

/* Blocks and geometry parts begin and end at multiples of 8 bytes. */
static inline uint32_t plt_block_pad(uint32_t bytes) {
    return (bytes + 7u) & ~7u;
}

/* Bytes of the nodes part, with `edges` links, before padding. */
static inline uint32_t plt_block_parts_bytes(uint32_t nodes, uint32_t edges, uint32_t bits) {
    return PLT_BLOCK_HEADER_BYTES + plt_block_bounds_bytes(bits) + 2 * ((2 * nodes + 7) / 8) +
           (5 * nodes + 7) / 8 + 6 * nodes + 4 * edges;
}

/* And as it lies in the block, a multiple of 4. */
static inline uint32_t plt_block_nodes_bytes(uint32_t nodes, uint32_t edges, uint32_t bits) {
    return (plt_block_parts_bytes(nodes, edges, bits) + 3u) & ~3u;
}

/* Bytes from a block to the next. */
static inline uint32_t plt_block_bytes(const plt_block *b) {
    return plt_block_pad(b->node_bytes + b->geometry_bytes);
}

void plt_block_open(plt_block *block, const unsigned char *bytes, uint32_t bits);

/* The exact box of the root of the block that lies there. */
void plt_block_bounds_at(const unsigned char *bytes, uint32_t bits, plt_lattice_box *bounds);

static inline void plt_block_bounds(const plt_block *block, uint32_t bits,
                                    plt_lattice_box *bounds) {
    plt_block_bounds_at(block->bytes, bits, bounds);
}

/* What slot `slot` is, and its index among those of its kind (an inner child is the
 * node of that index plus 1). */
static inline enum plt_slot_kind plt_block_kind(const plt_block *b, uint32_t slot) {
    const uint32_t bit = 1u << (slot & 31);
    return b->mask[PLT_SLOT_INNER][slot >> 5] & bit
               ? PLT_SLOT_INNER
               : (b->mask[PLT_SLOT_EDGE][slot >> 5] & bit ? PLT_SLOT_EDGE : PLT_SLOT_LEAF);
}

static inline uint32_t plt_block_rank(const plt_block *b, enum plt_slot_kind kind, uint32_t slot) {
    const uint32_t word = slot >> 5, below = plt_low_bits(slot & 31);
    uint32_t rank[2];
    for (int k = 0; k < 2; k++) {
        rank[k] = b->before[k][word] + plt_count_bits(b->mask[k][word] & below);
    }
    return kind == PLT_SLOT_LEAF ? slot - rank[0] - rank[1] : rank[kind];
}

static inline uint32_t plt_block_edge(const plt_block *b, uint32_t rank) {
    return plt_get_u32(b->links + 4 * rank);
}

/* Both children's boxes from their parent's: six plane bytes, xmin ymin zmin xmax
 * ymax zmax, and six owner bits in that order (1: the right child's). */
void plt_block_apply(const plt_lattice_box *box, const unsigned char plane[6], uint32_t owners,
                     plt_lattice_box child[2]);

/* Width of a plane's step on an axis of this extent; 1 for the extents below 0
 * that only a hostile block decodes to. */
static inline uint32_t plt_block_step(uint32_t extent) {
    return (int32_t)extent <= 255 ? 1 : (extent + 254) / 255;
}

/* The 16-bit check of a part, its own two bytes at `check_at` counting as 0. */
uint16_t plt_block_check(const unsigned char *part, uint32_t bytes, uint32_t check_at);

/* That of the primitive ids of its triangles, of whole bytes. Where it lies: at the end of the
 * geometry part. */
#define PLT_IDS_CHECK_BYTES 2
uint16_t plt_block_ids_check(const unsigned char *ids, uint32_t bytes);

#endif
