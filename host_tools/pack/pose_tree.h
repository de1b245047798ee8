/* pose_tree - a tree that is split by the boxes of all poses (pose_split.h)
 *
 * SPDX-License-Identifier: MIT */
#ifndef POSE_TREE_H
#define POSE_TREE_H
#include "host_tools/base/progress.h"
#include "host_tools/pack/list_tree.h"

/* Builds it, in lists of at most K, for t->poses; `t->node` and `t->posed` have room for two nodes
 * per record less one, and `ordered` for all of the job's records, of which the lists are. `bar`
 * shows how many are in lists. PLT_OK; PLT_ERR_ARENA: out of memory; PLT_MORE: it was not done by
 * clock_seconds() of `end`, above 0. */
int pose_tree_build(list_tree *t, const plt_build_job *job, plt_record *ordered, double end,
                    progress *bar);

#endif
