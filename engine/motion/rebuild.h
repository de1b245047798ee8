/* rebuild - a new tree beside the old one, in bounded steps
 *
 * The old tree goes on being refitted and traced. Its records are copied, each with its index in
 * place of its id; the copies are split into a new tree, wherever triangles go meanwhile; then
 * corners and ids as they are now come over by those indices, and the new tree is refitted. A
 * swap makes it the scene's, and what the old one lay in is free for the next.
 *
 * Keeps: the old tree is whole until the swap, and nothing of a new one is seen before. How often
 * triangles move between which steps, and how long the steps are, changes when the swap comes, and
 * no hit (DESIGN.md, 7.3); a tree that is built while nothing moves is that of any other steps.
 *
 * A subtree is rebuilt likewise, beside the old one, and then copied into its own slots: its box
 * is that of its triangles whatever is below it, so no node above it changes.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_REBUILD_H
#define PLT_MOTION_REBUILD_H

#include "engine/builder/build.h"
#include "engine/motion/refit.h"
#include "engine/motion/subtrees.h"
#include "engine/planelet.h"
#include "engine/tree/thesis/tree.h"
#include "engine/tree/thesis/validate.h"

enum plt_rebuild_phase {
    PLT_REBUILD_IDLE,
    PLT_REBUILD_COPIES,   /* records of the old tree */
    PLT_REBUILD_SPLITS,   /* ranges into nodes */
    PLT_REBUILD_TREELETS, /* of the nodes; of a subtree: its slots */
    PLT_REBUILD_COUNTS,   /* what the tree needs */
    PLT_REBUILD_COLLECTS, /* corners and ids, as they are now */
    PLT_REBUILD_REFITS,
    PLT_REBUILD_READY /* to be swapped */
};

typedef struct plt_rebuild {
    plt_record *records; /* as many as the scene has: of the new tree, or of none */
    plt_node *nodes;
    uint32_t room;     /* nodes there */
    uint32_t old_room; /* where the scene's are */
    uint32_t at;       /* record that copying or collecting goes on with */
    uint32_t *places;  /* of each id: its record; NULL: nobody asks (dirty.h) */
    uint8_t phase;     /* enum plt_rebuild_phase */
    plt_build_job build;
    plt_counting counting;
    plt_refit_job refit;
    plt_info info; /* with counts and needs of the new tree */
#if PLT_WITH_SUBTREES
    plt_subtree *part; /* that is rebuilt, into its own slots; NULL: the whole tree */
    float scale;       /* of its areas */
#endif
} plt_rebuild;

/* Begins to rebuild `tree`, of `info`; scratch and its bytes are in r->build, levels in r->refit.
 * Gives up one that was begun. */
void plt_rebuild_start(plt_rebuild *r, const plt_info *info);

#if PLT_WITH_SUBTREES
/* Begins to rebuild a part of it; areas of its nodes are to be times `scale`. */
void plt_rebuild_start_part(plt_rebuild *r, const plt_info *info, plt_subtree *part, float scale);

/* It is the scene's. r->info has the counts; stack needs are those of any tree that deep. */
void plt_rebuild_swap_part(plt_rebuild *r, plt_tree *tree);
#endif

/* About `triangles` records, at least one range of them. PLT_MORE: go on; PLT_OK: it is ready.
 * PLT_ERR_ARENA, PLT_ERR_LIMIT: there is no room for such a tree; it is given up, the old one is
 * as it was. `tree`: the scene's. */
int plt_rebuild_work(plt_rebuild *r, const plt_tree *tree, uint32_t triangles);

/* 1: corners are being collected, or have been, so the tree has to be ended and swapped before any
 * of them changes. Until then splitting goes on, wherever they are. */
int plt_rebuild_must_end(const plt_rebuild *r);

/* Ends it at once. `refits` 0: the new tree will be refitted anyway, and is not yet. */
void plt_rebuild_end(plt_rebuild *r, const plt_tree *tree, int refits);

/* The new tree is the scene's; the old one's place is free. */
void plt_rebuild_swap(plt_rebuild *r, plt_tree *tree);

#endif
