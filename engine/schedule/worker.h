/* worker - works a task off: a treelet, and a packet that waits there
 *
 * A worker has a traversal, with a store, and no packets. The edges out of its task go into its
 * own small pool, from which they are given back. The nearest of them is its next task without a
 * message, if it is the one that it would be given: nobody else has the packet, so no other edge of
 * it can become nearer meanwhile. All that it has to know of its task is told when it gets it, so
 * that it reads nothing that others write.
 *
 * Source: Karrenberg 2007, section 4.3 (an SPE traverses a given treelet with a given packet,
 * and returns the outgoing edges).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCHEDULE_WORKER_H
#define PLT_SCHEDULE_WORKER_H

#include "engine/trace/tasks.h"
#include "engine/trace/traversal.h"

typedef struct plt_worker {
    plt_tasks edges;    /* `here`: the treelet of its task; the others are given back */
    plt_packet *packet; /* the dispatcher's */
    uint32_t slot;      /* its slot */
    uint32_t item[2];   /* what it is of */
    uint32_t round;     /* the dispatcher's, when it got it */
    uint32_t run, end;  /* numbers of the packets that it is to begin next, if they are new then */
    float others;       /* distance of the nearest edge of its packet that the dispatcher has */
    uint8_t has;        /* a task */
    uint8_t is_new;     /* its packet is not set up */
    uint8_t has_others; /* there is such an edge */
    uint8_t is_done;    /* it can give back */
    int8_t status;      /* of its task: PLT_OK, or what a fetch failed with */
} plt_worker;

/* Tasks and treelets of a worker. Where there are more, a packet goes on alone; half of each is
 * for those behind the edges of one treelet, so a worker that has more gives all of them back. */
enum { PLT_WORKER_TASKS = 96, PLT_WORKER_QUEUES = 64 };

static inline size_t plt_worker_bytes(void) {
    return plt_tasks_bytes(PLT_WORKER_TASKS, PLT_WORKER_QUEUES);
}

/* `memory`: plt_worker_bytes of it, aligned to 8. */
void plt_worker_init(plt_worker *w, void *memory);

/* It has no task. */
void plt_worker_clear(plt_worker *w);

/* Where the nearest of its edges stands in their list. There is one. */
uint16_t *plt_worker_nearest(plt_tasks *edges);

/* Begins its packet, which is set up and has `rays` rays, at the root. */
void plt_worker_begin(plt_worker *w, plt_traversal *t, uint32_t rays);

/* Goes on with its task, for about `visits` node visits. PLT_MORE, or PLT_OK: it is done, and
 * w->status says how. */
int plt_worker_run(plt_worker *w, plt_traversal *t, uint32_t visits);

#endif
