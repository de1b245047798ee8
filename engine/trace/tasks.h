/* tasks - packets that wait at treelets
 *
 * Where many packets are alive at once, a packet that comes to an edge waits there, and all that
 * wait at a treelet are worked off together, so that it is fetched once for all of them. A task is
 * a packet at an edge: an entry of its stack that would have crossed the edge. Entries begin
 * with the place, which is the same for all of a treelet and is kept once, in its queue;
 * what follows is the packet's own. Queues and tasks lie in pools of fixed size. When one is
 * full, a packet goes on alone, in the order of its stack.
 *
 * A treelet of a tree is behind one edge. When all that wait at it are worked off, no packet comes
 * to it again.
 *
 * Source: Karrenberg 2007, section 4.3: the global stack of edges, from which tasks, a treelet
 * and a packet each, are handed out. There is one packet to a task there.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_TASKS_H
#define PLT_TRACE_TASKS_H

#include "engine/trace/traversal.h"

#define PLT_TASK_NONE 0xFFFFu

/* Bytes of a place, and of what may follow it in an entry, at most (traverse_format.h). */
enum { PLT_TASK_PLACE_BYTES = 48, PLT_TASK_REST_BYTES = PLT_WITH_HULLS ? 32 : 12 };

typedef struct plt_task {
    uint16_t next; /* of the same treelet; or of those that are unused */
    uint16_t packet;
    unsigned char rest[PLT_TASK_REST_BYTES];
} plt_task;

/* All tasks of a treelet. */
typedef struct plt_task_queue {
    uint32_t treelet; /* as its edges name it */
    uint32_t scope;   /* the format's: what else is the same of all who meet there */
    float nearest;    /* the least distance of all there */
    uint16_t task;    /* the first */
    uint16_t after;   /* the next queue; or of those that are unused */
    uint32_t is_far;  /* the schedule's: it was seen not to be at hand; 0 at first */
    unsigned char place[PLT_TASK_PLACE_BYTES];
} plt_task_queue;

typedef struct plt_tasks {
    plt_task_queue *queue;                     /* [queues_most] */
    plt_task *task;                            /* [most] */
    uint32_t most, count, queues_most, queues; /* most: below PLT_TASK_NONE */
    size_t place_bytes;                        /* of the format */
    uint16_t unused, unused_queue;
    uint16_t first;  /* queue, the newest */
    uint16_t before; /* the newest when `here` was begun: those in front of it are below it */
    uint16_t here;   /* the queue that is worked off: its edge is crossed */
    uint16_t packet; /* that is being traced */
} plt_tasks;

/* Bytes of so many tasks and queues. */
static inline size_t plt_tasks_bytes(uint32_t tasks, uint32_t queues) {
    return tasks * sizeof(plt_task) + queues * sizeof(plt_task_queue);
}

/* Lays them out in `memory`, plt_tasks_bytes of it, aligned to 8. */
void plt_tasks_init(plt_tasks *tasks, void *memory, uint32_t most, uint32_t queues);

/* No packet waits. */
void plt_tasks_clear(plt_tasks *tasks);

/* tasks->packet waits at `treelet` of that scope, `distance` away, with an entry of `bytes` that
 * begins with a place of `place_bytes`. 0: it has to go on, as the treelet is the one that is
 * worked off, or there is no room. */
int plt_tasks_wait(plt_tasks *tasks, uint32_t treelet, uint32_t scope, float distance,
                   const void *entry, size_t bytes, size_t place_bytes);

/* The queue whose index stands at `at`, which is `first` or the `after` of a queue, is worked off
 * from now on. The last one is. */
void plt_tasks_begin(plt_tasks *tasks, uint16_t *at);

/* The next packet of that queue: sets tasks->packet and puts its entry on its stack. 0: the
 * queue is worked off, or none was begun. */
int plt_tasks_next(plt_tasks *tasks, plt_traversal *traversal);

/* Between pools: the queue whose index stands at `from_at` goes to `to`, with all its tasks, in
 * front of the one whose index stands at `at`. 0: `to` has no room, and nothing has changed. */
int plt_tasks_move(plt_tasks *to, uint16_t *at, plt_tasks *from, uint16_t *from_at);

/* The queue whose index stands at `at` is dropped, with all its tasks. */
void plt_tasks_drop(plt_tasks *tasks, uint16_t *at);

/* How many tasks a queue has. */
uint32_t plt_tasks_of(const plt_tasks *tasks, uint16_t queue);

#if PLT_WITH_PREFETCH
/* The first packet that waits in a queue: sets tasks->packet, and puts its entry on its stack,
 * where nothing is. It goes on waiting. */
void plt_tasks_peek(plt_tasks *tasks, const plt_task_queue *queue, plt_traversal *traversal);

/* The first packet of the queue whose index stands at `at`, which has not been begun, waits no
 * longer. If it was the last, the next queue stands there. */
void plt_tasks_drop_one(plt_tasks *tasks, uint16_t *at);
#endif

#endif
