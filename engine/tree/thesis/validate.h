/* validate - one walk over a whole tree: is it a tree, and what does it need?
 *
 * Serves the builder (to fill in the counts) and opening (to believe them).
 * Needs one frame a level and no recursion; bytes of a hostile image are
 * safe to survey, and a tree that passed is safe to traverse (SPEC.md, I1
 * to I4; the stacks it needs, I8).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_THESIS_VALIDATE_H
#define PLT_TREE_THESIS_VALIDATE_H

#include <stddef.h>
#include <stdint.h>

#include "engine/planelet.h"
#include "engine/tree/record.h"
#include "engine/tree/thesis/node.h"

/* A scene as the traversal sees it. */
typedef struct plt_tree {
    const plt_node *nodes;
    const plt_record *records;
    uint32_t node_slots, records_count;
    uint32_t treelet_nodes; /* slots a block, 1 or more */
    uint32_t root;          /* link, or PLT_LINK_NONE */
    plt_box box;            /* of all records; empty when there are none */
} plt_tree;

/* Needs of a subtree, from the bottom up. */
typedef struct plt_need {
    uint32_t local;  /* local stack inside the treelet, the node in hand */
    uint32_t locals; /* largest local need of a treelet behind an edge below */
    uint32_t edges;  /* edges that leave the treelet below the node */
    uint32_t beyond; /* largest global need of a treelet behind such an edge */
    uint32_t depth;  /* depth-first stack, the node in hand */
} plt_need;

typedef struct plt_validate_level {
    uint32_t node;
    uint32_t next_child;
    plt_need need[2];
} plt_validate_level;

/* In plt_fault.offset: the root link is at fault. Else the survey gives the
 * number of a node (rules 1, 2) or a record (3, 4). */
#define PLT_AT_ROOT_LINK 0xFFFFFFFFu

#define PLT_VALIDATE_LEVELS (PLT_DEPTH_MAX + 1)

/* Fills the counts and stack needs of `info` (nodes, leaf_lists,
 * intermediate_lists, treelets, the longest list into leaf_triangles, the
 * three stack needs). `frames` is scratch of PLT_VALIDATE_LEVELS. Returns
 * PLT_OK, PLT_ERR_LIMIT (deeper than PLT_DEPTH_MAX) or PLT_ERR_IMAGE with
 * the rule in fault. Cost: one visit a node, one read a record. */
int plt_tree_validate(const plt_tree *tree, plt_validate_level *frames, plt_info *info,
                      plt_fault *fault);

#endif
