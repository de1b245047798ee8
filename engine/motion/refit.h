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

#include "engine/motion/refit_job.h"

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

#if PLT_WITH_VERTICES
/* Of a tree over vertices, as they are there; areas are not counted. The root may be a leaf. */
int plt_refit_vertices_step(plt_refit_job *job, uint32_t lists);
#endif

#endif
