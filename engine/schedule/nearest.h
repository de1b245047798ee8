/* nearest - which of the treelets that packets wait at comes next
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCHEDULE_NEAREST_H
#define PLT_SCHEDULE_NEAREST_H

#include "engine/trace/tasks.h"

/* Begins the next queue: a treelet that is at hand before one that has to be fetched, of those the
 * nearest; when a pool is nearly full, the one that was met last, which leaves the fewest
 * behind. The last queue is worked off. 0: nobody waits. */
int plt_nearest_begin(plt_tasks *tasks, const plt_traversal *traversal);

#endif
