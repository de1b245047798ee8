/* worker - see worker.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/schedule/worker.h"

#include "engine/schedule/counted.h"

void plt_worker_init(plt_worker *w, void *memory) {
    plt_tasks_init(&w->edges, memory, PLT_WORKER_TASKS, PLT_WORKER_QUEUES);
    w->has = 0;
}

void plt_worker_clear(plt_worker *w) {
    plt_tasks_clear(&w->edges);
    w->has = 0;
}

/* The root is an edge, too: the packet waits there, and is the first that comes. */
void plt_worker_begin(plt_worker *w, plt_traversal *t, uint32_t rays) {
    w->is_new = 0;
    t->tasks = &w->edges;
    plt_traversal_begin(t, w->packet, rays);
    t->tasks = NULL;
    if (w->edges.first != PLT_TASK_NONE) {
        plt_tasks_begin(&w->edges, &w->edges.first);
    }
}

/* Its next entry, if it has rays left. */
static int resume_next(plt_worker *w, plt_traversal *t) {
    while (plt_tasks_next(&w->edges, t)) {
        if (w->packet->active != 0) {
            return 1;
        }
        t->waiting = 0;
    }
    return 0;
}

static int run(plt_worker *w, plt_traversal *t, uint32_t visits) {
    while (t->waiting > 0 || resume_next(w, t)) {
        const int status = plt_traverse_counted(t, w->packet, &visits);
        if (status != PLT_OK) {
            return status;
        }
    }
    return PLT_OK;
}

int plt_worker_run(plt_worker *w, plt_traversal *t, uint32_t visits) {
    t->tasks = &w->edges;
    const int status = run(w, t, visits > 0 ? visits : 1);
    plt_traversal_pause(t);
    t->tasks = NULL;
    if (status == PLT_MORE) {
        return PLT_MORE;
    }
    w->is_done = 1;
    w->status = (int8_t)status;
    return PLT_OK;
}
