/* node - the thesis node: both children's boxes in six planes, 32 bytes
 *
 * Invariant: decoding what was encoded gives both children's boxes exactly,
 * given the parent's box, which is their union.
 *
 * Source: Karrenberg 2007, sections 3.1 and 3.3, figures 3.5 and 3.6.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_THESIS_NODE_H
#define PLT_TREE_THESIS_NODE_H

#include <stdint.h>

#include "engine/base/box.h"
#include "engine/base/bytes.h"
#include "engine/tree/thesis/link.h"

/* As it lies in the image: planes_min[3], planes_max[3], left, right. */
typedef struct plt_node {
    uint32_t word[8];
} plt_node;

_Static_assert(sizeof(plt_node) == PLT_NODE_BYTES, "a thesis node has 32 bytes");

static inline uint32_t plt_node_link(const plt_node *node, int child) {
    return plt_get_u32(&node->word[6 + child]);
}

static inline void plt_node_set_link(plt_node *node, int child, uint32_t link) {
    plt_put_u32(&node->word[6 + child], link);
}

/* Replaces index and kind of a link, the owner bits stay. */
static inline void plt_node_relink(plt_node *node, int child, uint32_t link) {
    const uint32_t owners = plt_node_link(node, child) & PLT_LINK_OWNERS;
    plt_node_set_link(node, child, (link & ~PLT_LINK_OWNERS) | owners);
}

/* Owner bit of an axis within a link: x is bit 4, z bit 2. */
static inline uint32_t plt_owner_bit(int axis) {
    return 0x10u >> axis;
}

/* Planes and owner bits from the children's boxes; the links' index and kind
 * become 0. A plane that both children share with the parent is stored for
 * the left child, as in figure 3.6. */
static inline void plt_node_encode(plt_node *node, const plt_box *parent, const plt_box child[2]) {
    uint32_t owners_min = 0, owners_max = 0;
    for (int a = 0; a < 3; a++) {
        const int right_min = child[1].lo[a] != parent->lo[a];
        const int right_max = child[1].hi[a] != parent->hi[a];
        plt_put_float(&node->word[a], child[right_min].lo[a]);
        plt_put_float(&node->word[3 + a], child[right_max].hi[a]);
        owners_min |= right_min ? plt_owner_bit(a) : 0;
        owners_max |= right_max ? plt_owner_bit(a) : 0;
    }
    plt_node_set_link(node, 0, owners_min);
    plt_node_set_link(node, 1, owners_max);
}

/* A child's box is its parent's with the owned planes put in. */
static inline void plt_node_decode(const plt_node *node, const plt_box *parent, plt_box child[2]) {
    const uint32_t owners_min = plt_node_link(node, 0);
    const uint32_t owners_max = plt_node_link(node, 1);
    for (int a = 0; a < 3; a++) {
        const float lo = plt_get_float(&node->word[a]);
        const float hi = plt_get_float(&node->word[3 + a]);
        const int right_min = (owners_min & plt_owner_bit(a)) != 0;
        const int right_max = (owners_max & plt_owner_bit(a)) != 0;
        child[0].lo[a] = right_min ? parent->lo[a] : lo;
        child[1].lo[a] = right_min ? lo : parent->lo[a];
        child[0].hi[a] = right_max ? parent->hi[a] : hi;
        child[1].hi[a] = right_max ? hi : parent->hi[a];
    }
}

#endif
