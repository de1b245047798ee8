/* bkd_tree - B-KD trees: across one axis, the two planes of each child
 *
 * Two layouts of the same tree. *Small*: a node has 16 bytes, so that a tree of n triangles has
 * 16 (2 n - 1), the thesis's 32 bytes per triangle; planes have 24 bits, sign, exponent and 15 bits
 * of a fraction, rounded outwards, beside a word of 32 that is as the kd-tree's (kd_tree.h); leaves
 * are nodes, too, and have one triangle each. *Exact*: an inner node has four floats and two links,
 * 24 bytes, and there are no leaves: 24 (n - 1) bytes.
 *
 * The second child of a small node stands behind the first. Nodes stand before those below them.
 *
 * Source: Woop, Marmitt, Slusallek, "B-KD trees for hardware accelerated ray tracing of dynamic
 * scenes", 2006 (the tree, and that it is kept while planes are updated from below).
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_BKD_TREE_H
#define BASELINES_BKD_TREE_H

#include <string.h>

#include "host_tools/baselines/base/binary_tree.h"
#include "host_tools/baselines/planes/planes_view.h"

/* Inner: link & 3 is the axis, link >> 2 the first child. Leaf: link & 3 is 3, link >> 2 the
 * place of its record. */
typedef struct bkd_small {
    uint8_t plane[2][2][3]; /* of each child, lo and hi: the upper bytes of a float, lowest first */
    uint32_t link;
} bkd_small;

/* A link's lowest bit says whether it is a leaf's: the place of a record is above its lowest
 * three bits, or else of a node. The axis stands in the two between, of the first link. */
typedef struct bkd_exact {
    float plane[2][2];
    uint32_t link[2];
} bkd_exact;

_Static_assert(sizeof(bkd_small) == 16 && sizeof(bkd_exact) == 24, "the sizes above");

typedef struct bkd_tree {
    bkd_small *small; /* or */
    bkd_exact *exact;
    uint32_t places; /* of them */
    uint32_t inner;
    uint32_t root; /* a link: as an exact node's; a small one's place */
} bkd_tree;

/* Of a tree whose leaves have one record each; its boxes are lost. -1: no memory, and there is no
 * tree. */
int bkd_tree_make(bkd_tree *b, binary_tree *t, int is_exact);
void bkd_tree_free(bkd_tree *b); /* one that is all zero is allowed */
uint64_t bkd_tree_bytes(const bkd_tree *b);

/* All planes anew, from records that have moved. -1: no memory, and planes are as they were. */
int bkd_tree_refit(bkd_tree *b, const plt_record *records);

/* ---- links ------------------------------------------------------------------------ */

static inline int bkd_is_leaf(const bkd_tree *b, uint32_t link) {
    return b->small != NULL ? (b->small[link].link & 3u) == 3u : (link & 1u) != 0;
}

static inline uint32_t bkd_leaf_record(const bkd_tree *b, uint32_t link) {
    return b->small != NULL ? b->small[link].link >> 2 : link >> 3;
}

/* The place of an inner node. */
static inline uint32_t bkd_place(const bkd_tree *b, uint32_t link) {
    return b->small != NULL ? link : link >> 3;
}

static inline float bkd_small_plane(const uint8_t from[3]) {
    const uint32_t bits =
        (uint32_t)from[0] << 8 | (uint32_t)from[1] << 16 | (uint32_t)from[2] << 24;
    float plane;
    memcpy(&plane, &bits, sizeof plane);
    return plane;
}

static inline planes_view bkd_view(const bkd_tree *b, uint32_t link) {
    planes_view v;
    if (b->small != NULL) {
        const bkd_small *n = &b->small[link];
        v.axis = n->link & 3u;
        for (unsigned c = 0; c < 2; c++) {
            v.link[c] = (n->link >> 2) + c;
            v.lo[c] = bkd_small_plane(n->plane[c][0]);
            v.hi[c] = bkd_small_plane(n->plane[c][1]);
        }
        return v;
    }
    const bkd_exact *n = &b->exact[link >> 3];
    v.axis = n->link[0] >> 1 & 3u;
    for (unsigned c = 0; c < 2; c++) {
        v.link[c] = n->link[c];
        v.lo[c] = n->plane[c][0];
        v.hi[c] = n->plane[c][1];
    }
    return v;
}

#endif
