/* format_meets - whether packets of a format can wait at edges, to meet there
 *
 * A format whose treelets are fetched defines FORMAT_MEETS 1 before its orders, and gives
 *
 *   int format_wait(t, place, distance, entry, bytes)     the entry waits at the edge that
 *                   `place` is, if t->tasks (tasks.h) takes it: as plt_tasks_wait
 *
 * Others have edges that cost nothing to cross.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_FORMAT_MEETS_H
#define PLT_TRACE_FORMAT_MEETS_H

#ifndef FORMAT_MEETS
#define FORMAT_MEETS 0
#endif

#endif
