/* link - the 32-bit reference of a node to a child
 *
 *     31                               5   4   3   2     1       0
 *    +----------------------------------+---+---+---+---------+------+
 *    | index: node or triangle record    | x | y | z | two/out | leaf |
 *    +----------------------------------+---+---+---+---------+------+
 *
 * leaf 0: the child is a node; bit 1 says that it is in another treelet.
 * leaf 1: the child is triangles; bit 1 says that it is an intermediate node,
 * two adjacent lists instead of one. x y z: the planes that belong to the
 * right child (min planes in the left link, max planes in the right one).
 *
 * Source: Karrenberg 2007, section 3.3 and figure 3.5. Bit 1 tells an edge
 * that leaves the treelet directly, not by parity as in section 4.1: it takes
 * the same bit and needs no context (DESIGN.md, section 4).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_THESIS_LINK_H
#define PLT_TREE_THESIS_LINK_H

#include <stdint.h>

#include "engine/image/items.h"

#define PLT_LINK_LEAF 1u
#define PLT_LINK_TWO 2u /* with PLT_LINK_LEAF: intermediate node */
#define PLT_LINK_OUT 2u /* without it: an edge that leaves the treelet */
#define PLT_LINK_KIND 3u
#define PLT_LINK_OWNERS 0x1Cu
#define PLT_LINK_SHIFT 5

static inline uint32_t plt_link_make(uint32_t index, uint32_t kind) {
    return index << PLT_LINK_SHIFT | kind;
}

static inline uint32_t plt_link_index(uint32_t link) {
    return link >> PLT_LINK_SHIFT;
}

static inline int plt_link_is_leaf(uint32_t link) {
    return (int)(link & PLT_LINK_LEAF);
}

/* Lists of a leaf link: 1, or 2 for an intermediate node. */
static inline uint32_t plt_link_lists(uint32_t link) {
    return 1u + (link >> 1 & 1u);
}

/* A node that is reached without leaving the treelet. */
static inline int plt_link_is_inner(uint32_t link) {
    return (link & PLT_LINK_KIND) == 0;
}

#endif
