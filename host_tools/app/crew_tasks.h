/* crew_tasks - a crew whose first worker hands out tasks (schedule `task`)
 *
 * Keeps: what is made does not depend on how many workers there are, nor on who took which task.
 *
 * SPDX-License-Identifier: MIT */
#ifndef CREW_TASKS_H
#define CREW_TASKS_H

#include "host_tools/app/crew.h"

typedef struct crew_tasks {
    /* A tile is there to be fetched; NULL: of rays. Called by one thread at a time. */
    void (*tile)(void *context, const plt_engine *dispatcher);
    void *context;
    progress *bar;   /* shows before + items done so far */
    uint64_t before; /* items of earlier frames or files: tiles, or rays */
    uint64_t items;
} crew_tasks;

/* All of the frame or of the rays that the first worker's engine has begun; adds to `took`. In
 * turns it also simulates: the worker whose clock, node visits and waits, is behind all others'
 * takes the next task. PLT_OK, or what a task failed with: c->first had it. */
int crew_do_tasks(crew *c, const crew_tasks *work, crew_times *took);

#endif
