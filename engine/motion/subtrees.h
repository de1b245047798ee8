/* subtrees - the parts of a tree that are rebuilt one by one, in their own slots
 *
 * The largest subtrees of at most so many triangles, but for those of less than a quarter of that,
 * or of more nodes than there is room for. So there are few, they do not overlap, and as nodes
 * above them stay what they are, they are the same as long as the scene is open. Lists lie in the
 * order of a left-first traversal: a subtree is a range of records.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_SUBTREES_H
#define PLT_MOTION_SUBTREES_H

#include "engine/motion/refit.h"
#include "engine/planelet.h"
#include "engine/tree/thesis/tree.h"

#if PLT_WITH_SUBTREES

#define PLT_SUBTREE_NONE 0xFFFFFFFFu

typedef struct plt_subtree {
    uint64_t ratios, sum;             /* plt_areas of its nodes as they are ... */
    uint64_t ratios_built, sum_built; /* ... and as they were when it was built */
    uint64_t excess;                  /* work since then that a new one would have saved */
    uint32_t first, count;            /* records */
    uint32_t root;                    /* node */
    uint32_t parent;                  /* 2 x the node above, + 1: it is the right child; or none */
    uint32_t slots;                   /* of nodes, its own and free ones */
    uint32_t free;  /* the first of these, each having the next in its first word; or none */
    uint32_t depth; /* nodes above the root */
    float tried;    /* degradation when a new one was given up since then; or 0 */
} plt_subtree;

typedef struct plt_subtrees {
    plt_subtree *at; /* in the order of their records */
    uint32_t count;  /* 0: the tree is rebuilt as a whole, or not at all */
} plt_subtrees;

/* Most triangles of a subtree, where plt_options.rebuild_most are asked for. */
static inline uint32_t plt_subtree_triangles(uint32_t triangles, uint32_t most) {
    return triangles < most ? triangles : most;
}

/* Most subtrees of so many triangles at most. */
static inline uint32_t plt_subtrees_most(uint32_t triangles, uint32_t most) {
    const uint32_t least = plt_subtree_triangles(triangles, most) / 4;
    return least > 0 ? triangles / least : triangles;
}

/* Nodes that there is room for, in a tree of `nodes`: a quarter more per triangle than in all. */
uint32_t plt_subtree_room(uint32_t triangles, uint32_t nodes, uint32_t most);

/* Bytes of scratch that finding them takes. */
size_t plt_subtrees_scratch_bytes(void);

/* Those of a tree that is valid, of K triangles per list, of `room` nodes at most each. */
void plt_subtrees_find(plt_subtrees *s, const plt_tree *tree, uint32_t most,
                       uint32_t leaf_triangles, uint32_t room, void *scratch);

/* plt_refit, with the areas of each. */
void plt_subtrees_refit(plt_subtrees *s, plt_refit_job *job);

/* They are as they were built. */
void plt_subtrees_are_new(plt_subtrees *s);

/* The one in which a node at `depth` above record `record` is; NULL: it is above all. */
plt_subtree *plt_subtrees_of(const plt_subtrees *s, uint32_t record, uint32_t depth);

#endif
#endif
