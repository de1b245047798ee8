/* bih_tree - bounding interval hierarchies: across one axis, the upper plane of the lower child and
 * the lower plane of the upper one
 *
 * In words of 4 bytes: an inner node has three, a leaf one, and the second child stands right
 * behind the first. So a tree of n leaves has 16 n - 12 bytes, the 12 per node and 16 per primitive
 * of the thesis (section 2.2). Leaves have one triangle and more, the last of which says so
 * (tree/record.h).
 *
 * Source: Waechter, Keller, "Instant ray tracing: the bounding interval hierarchy", 2006.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_BIH_TREE_H
#define BASELINES_BIH_TREE_H

#include <string.h>

#include "host_tools/baselines/base/binary_tree.h"
#include "host_tools/baselines/planes/planes_view.h"

/* Inner: axis | place of the first child << 2, then both planes as floats. Leaf: 3 | place of its
 * first record << 2. A link is the place of a node's first word. */
typedef struct bih_tree {
    uint32_t *word; /* the root is at 0 */
    uint32_t words;
    uint32_t inner, leaves;
} bih_tree;

enum { BIH_INNER_WORDS = 3, BIH_LEAF_WORDS = 1, BIH_LEAF = 3 };

/* Of any binary tree of some nodes; its boxes are lost. -1: no memory, and there is no
 * tree. */
int bih_tree_make(bih_tree *b, binary_tree *t);
void bih_tree_free(bih_tree *b); /* one that is all zero is allowed */
uint64_t bih_tree_bytes(const bih_tree *b);

static inline int bih_is_leaf(const bih_tree *b, uint32_t link) {
    return (b->word[link] & 3u) == BIH_LEAF;
}

static inline uint32_t bih_leaf_record(const bih_tree *b, uint32_t link) {
    return b->word[link] >> 2;
}

static inline planes_view bih_view(const bih_tree *b, uint32_t link) {
    const uint32_t *word = b->word + link;
    planes_view v = {.axis = word[0] & 3u, .lo[0] = -PLT_BOX_FAR, .hi[1] = PLT_BOX_FAR};
    v.link[0] = word[0] >> 2;
    v.link[1] = v.link[0] + (bih_is_leaf(b, v.link[0]) ? BIH_LEAF_WORDS : BIH_INNER_WORDS);
    memcpy(&v.hi[0], &word[1], sizeof v.hi[0]);
    memcpy(&v.lo[1], &word[2], sizeof v.lo[1]);
    return v;
}

#endif
