/* full - which nodes one treelet takes so that few treelets stay incomplete
 *
 * cost(v, k) is what the subtree of v costs at least when the treelet that reaches it from above
 * takes k of its nodes (a knapsack over a tree):
 *
 *     cost(v, k) = min over i + j = k - 1 of cost(left, i) + cost(right, j),  k > 0
 *     cost(v, 0) = cost(v, N), of less than N nodes 0, + the price of a treelet that begins at v
 *
 * An incomplete treelet costs 1, and more the larger it is: what is complete then is most, and
 * what is not fits into free slots. A complete one costs as much as a random line that meets the
 * root's box is likely to enter it. All costs of a node matter up to a constant only, so single
 * precision is enough. Time: nodes times N at most; memory: 4 bytes times the sum of
 * min(N, nodes below) + 1, which is about nodes times (2 + log2 N).
 *
 * Source: Karrenberg 2007, section 8.2.2: "counts the remaining inner nodes of all branches before
 * deciding what node to add".
 *
 * SPDX-License-Identifier: MIT */
#ifndef TREELETS_FULL_H
#define TREELETS_FULL_H

#include "host_tools/treelets/treelet_tree.h"

typedef struct treelet_prices {
    float per_size;   /* of an incomplete treelet, times its nodes over N */
    float above_half; /* if it has more than N / 2 */
    float visits;     /* of any one, times its box's area over the root's, and nodes over N */
} treelet_prices;

typedef struct treelet_costs {
    const treelet_tree *tree;
    treelet_prices prices;
    uint32_t size;
    uint32_t *below; /* nodes of each subtree */
    size_t *at;      /* of each node: where its costs are, from k = 0 on */
    float *cost;
} treelet_costs;

/* -1: no memory. `order`: the nodes, every one after its parent. */
int treelet_costs_make(treelet_costs *c, const treelet_tree *tree, uint32_t size,
                       const uint32_t *order, const treelet_prices *prices);
void treelet_costs_free(treelet_costs *c);

/* Of `take` nodes of the subtree of `node`, itself included: how many the left child gives. */
uint32_t treelet_costs_left(const treelet_costs *c, uint32_t node, uint32_t take);

#endif
