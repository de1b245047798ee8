/* worker - see worker.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/schedule/worker.h"

#include "engine/schedule/counted.h"

void plt_worker_init(plt_worker *w, void *memory) {
    plt_tasks_init(&w->edges, memory, PLT_WORKER_TASKS, PLT_WORKER_QUEUES);
    w->has = 0;
    w->run = w->end = 0;
}

void plt_worker_clear(plt_worker *w) {
    plt_tasks_clear(&w->edges);
    w->has = 0;
    w->run = w->end = 0;
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

uint16_t *plt_worker_nearest(plt_tasks *edges) {
    uint16_t *nearest = &edges->first;
    for (uint16_t *i = nearest; *i != PLT_TASK_NONE; i = &edges->queue[*i].after) {
        if (edges->queue[*i].nearest < edges->queue[*nearest].nearest) {
            nearest = i;
        }
    }
    return nearest;
}

static int has_half_left(const plt_tasks *edges) {
    return edges->queues <= PLT_WORKER_QUEUES / 2 && edges->count <= PLT_WORKER_TASKS / 2;
}

/* Begins the nearest of its edges, if it would be given that. */
static int begin_next(plt_worker *w) {
    plt_tasks *edges = &w->edges;
    if (w->packet->active == 0 || edges->first == PLT_TASK_NONE) {
        return 0;
    }
    uint16_t *nearest = plt_worker_nearest(edges);
    if (!has_half_left(edges) || w->others < edges->queue[*nearest].nearest) {
        return 0;
    }
    plt_tasks_begin(edges, nearest);
    return 1;
}

/* Its next entry, if it has rays left. */
static int resume_next(plt_worker *w, plt_traversal *t) {
    do {
        while (plt_tasks_next(&w->edges, t)) {
            if (w->packet->active != 0) {
                return 1;
            }
            t->waiting = 0;
        }
    } while (begin_next(w));
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
