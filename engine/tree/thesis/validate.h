/* validate - is a tree of thesis nodes a tree, and what does it need?
 *
 * One traversal over the whole tree, for the builder (to fill in the counts) and
 * for opening (to rely on them). It needs one level of scratch per level of the
 * tree and no recursion. Bytes of a hostile image are safe to validate, and a tree
 * that is valid is safe to traverse; nothing behind it checks again (SPEC.md,
 * section 5: I1 to I4, I6; the stacks it needs, I8).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_THESIS_VALIDATE_H
#define PLT_TREE_THESIS_VALIDATE_H

#include <stddef.h>
#include <stdint.h>

#include "engine/image/header.h"
#include "engine/tree/thesis/tree.h"

/* Needs of a subtree, from the bottom up. */
typedef struct plt_need {
    uint32_t local;  /* local stack inside the treelet, the node in hand */
    uint32_t locals; /* largest local need of a treelet behind an edge below */
    uint32_t edges;  /* edges that leave the treelet below the node */
    uint32_t beyond; /* largest global need of a treelet behind such an edge */
    uint32_t depth;  /* depth-first stack, the node in hand */
} plt_need;

/* A node on the path from the root. */
typedef struct plt_validate_level {
    uint32_t node;
    uint32_t next_child;
    plt_need need[2];
} plt_validate_level;

#define PLT_VALIDATE_LEVELS (PLT_DEPTH_MAX + 1)

/* In plt_fault.offset: the root link is at fault. Else plt_tree_validate gives the
 * index of a node (rules 1, 2) or a record (3, 4). */
#define PLT_AT_ROOT_LINK 0xFFFFFFFFu

/* Fills the counts and stack needs of `info` (nodes, leaf_lists,
 * intermediate_lists, treelets, the longest list into leaf_triangles, the
 * three stack needs). `levels` is scratch of PLT_VALIDATE_LEVELS. Returns
 * PLT_OK, PLT_ERR_LIMIT (deeper than PLT_DEPTH_MAX) or PLT_ERR_IMAGE with
 * the rule in fault. Cost: one visit per node,
 * one read per record. */
int plt_tree_validate(const plt_tree *tree, plt_validate_level *levels, plt_info *info,
                      plt_fault *fault);

#if PLT_WITH_REBUILD
typedef struct plt_counting {
    plt_validate_level *levels; /* scratch, as above */
    uint32_t depth, seen;       /* level in hand; records behind it */
} plt_counting;

/* The same in steps, of a tree with a node that was built here, `triangles` records at a time:
 * PLT_MORE, or PLT_OK, then the needs are known. PLT_ERR_LIMIT: as above. */
void plt_tree_count_begin(plt_counting *c, const plt_tree *tree, plt_info *info);
int plt_tree_count(plt_counting *c, const plt_tree *tree, uint32_t triangles, plt_info *info);
#endif

/* I6: planes inside the scene's box, for every slot of a node in use or not. */
int plt_planes_validate(const plt_header *header, const plt_node *nodes, plt_fault *fault);

#endif
