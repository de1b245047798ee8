/* refit - new boxes for an old tree
 *
 * Nodes and lists stay what they are; each node's planes and owner bits become those of the
 * records as they are now. So hits are those of a tree that is built anew, however far triangles
 * have moved; only how fast they are found may suffer.
 *
 * Source: Karrenberg 2007, section 3.6.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_REFIT_H
#define PLT_MOTION_REFIT_H

#include "engine/motion/node_box.h"
#include "engine/tree/record.h"
#include "engine/tree/thesis/node.h"

/* A node whose left child is done, or not yet. */
typedef struct plt_refit_level {
    float lo[4], hi[4]; /* of the left child, if it is done */
    uint32_t node;
    uint32_t is_done;
} plt_refit_level;

typedef struct plt_refit_job {
    plt_node *nodes;
    const plt_record *records;
    uint32_t root;           /* link, not PLT_LINK_NONE */
    plt_refit_level *levels; /* as many as there are nodes on the longest path */
    plt_refit_level *top;    /* between steps: the path so far ... */
    uint32_t link;           /* ... and where it goes on */
    plt_areas areas;         /* scale, and results: of all nodes */
    plt_box box;             /* result: of all records */
} plt_refit_job;

/* Of a tree that is valid. A plane that has not moved keeps its bytes. */
void plt_refit(plt_refit_job *job);

/* The same in steps of `lists` leaf links, or nodes of two, one at least: PLT_MORE or PLT_OK. Until
 * that the tree is not to be traversed, and its records stay as they are. */
void plt_refit_begin(plt_refit_job *job);
int plt_refit_step(plt_refit_job *job, uint32_t lists);

#if PLT_WITH_SUBTREES
/* The same, with areas, up to node `stop`, which has not been refitted; then job->top is free.
 * What is below it is refitted apart, its box is put there, and the job goes on. */
void plt_refit_to(plt_refit_job *job, uint32_t stop);
void plt_refit_put(plt_refit_job *job, const plt_box *box);
#endif

#endif
