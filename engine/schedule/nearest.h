/* nearest - which of the treelets that packets wait at comes next
 *
 * With prefetch, the one that would come next is asked for while packets are worked off at the one
 * before it. From then on it is at hand, so it is not put off for others that are met meanwhile;
 * and no other is asked for until it is begun. Packets that hits have hidden it from are let go,
 * and it is not fetched for nobody.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCHEDULE_NEAREST_H
#define PLT_SCHEDULE_NEAREST_H

#include "engine/trace/tasks.h"

/* Begins the next queue: a treelet that is at hand before one that has to be fetched, of those the
 * nearest; when a pool is nearly full, the one that was met last, which leaves the fewest
 * behind. The last queue is worked off. 0: nobody waits. */
int plt_nearest_begin(plt_tasks *tasks, const plt_traversal *traversal);

#if PLT_WITH_PREFETCH
/* When a queue has been begun, and nothing is on the stack yet: asks for the treelet of the next,
 * if it has to be fetched. `packets`: those that tasks->packet is one of. */
void plt_nearest_expect(plt_tasks *tasks, const plt_packet *packets, plt_traversal *traversal);
#else
static inline void plt_nearest_expect(const plt_tasks *tasks, const plt_packet *packets,
                                      const plt_traversal *traversal) {
    (void)tasks;
    (void)packets;
    (void)traversal;
}
#endif

#endif
