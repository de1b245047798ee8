/* tasks - see tasks.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/tasks.h"

#include <string.h>

void plt_tasks_init(plt_tasks *tasks, void *memory, uint32_t most, uint32_t queues) {
    tasks->queue = memory;
    tasks->task = (plt_task *)(void *)(tasks->queue + queues);
    tasks->most = most < PLT_TASK_NONE ? most : PLT_TASK_NONE - 1;
    tasks->queues_most = queues < PLT_TASK_NONE ? queues : PLT_TASK_NONE - 1;
    tasks->packet = 0;
    plt_tasks_clear(tasks);
}

void plt_tasks_clear(plt_tasks *tasks) {
    for (uint32_t i = 0; i < tasks->most; i++) {
        tasks->task[i].next = (uint16_t)(i + 1 < tasks->most ? i + 1 : PLT_TASK_NONE);
    }
    for (uint32_t i = 0; i < tasks->queues_most; i++) {
        tasks->queue[i].after = (uint16_t)(i + 1 < tasks->queues_most ? i + 1 : PLT_TASK_NONE);
    }
    tasks->unused = tasks->unused_queue = 0;
    tasks->first = tasks->before = tasks->here = PLT_TASK_NONE;
    tasks->count = tasks->queues = 0;
}

/* PLT_TASK_NONE: nobody waits there. Only treelets that were met since `here` was begun can be
 * the same. */
static uint16_t find_queue(const plt_tasks *tasks, uint32_t treelet, uint32_t scope) {
    uint16_t i = tasks->first;
    while (i != tasks->before && i != PLT_TASK_NONE &&
           (tasks->queue[i].treelet != treelet || tasks->queue[i].scope != scope)) {
        i = tasks->queue[i].after;
    }
    return i != tasks->before ? i : PLT_TASK_NONE;
}

/* PLT_TASK_NONE: there is no room. */
static uint16_t add_queue(plt_tasks *tasks, uint32_t treelet, uint32_t scope, const void *place) {
    const uint16_t i = tasks->unused_queue;
    if (i == PLT_TASK_NONE) {
        return i;
    }
    plt_task_queue *q = &tasks->queue[i];
    tasks->unused_queue = q->after;
    tasks->queues++;
    q->treelet = treelet;
    q->scope = scope;
    q->is_far = 0;
    q->nearest = 0x1p127f;
    q->task = PLT_TASK_NONE;
    q->after = tasks->first;
    tasks->first = i;
    memcpy(q->place, place, tasks->place_bytes);
    return i;
}

static void add_task(plt_tasks *tasks, plt_task_queue *q, const void *rest, size_t bytes) {
    const uint16_t i = tasks->unused;
    plt_task *task = &tasks->task[i];
    tasks->unused = task->next;
    tasks->count++;
    task->packet = tasks->packet;
    memcpy(task->rest, rest, bytes);
    task->next = q->task;
    q->task = i;
}

int plt_tasks_wait(plt_tasks *tasks, uint32_t treelet, uint32_t scope, float distance,
                   const void *entry, size_t bytes, size_t place_bytes) {
    const int is_here =
        tasks->here != PLT_TASK_NONE && tasks->queue[tasks->here].treelet == treelet;
    if (is_here || tasks->unused == PLT_TASK_NONE) {
        return 0;
    }
    tasks->place_bytes = place_bytes;
    uint16_t i = find_queue(tasks, treelet, scope);
    if (i == PLT_TASK_NONE) {
        i = add_queue(tasks, treelet, scope, entry);
    }
    if (i == PLT_TASK_NONE) {
        return 0;
    }
    plt_task_queue *q = &tasks->queue[i];
    q->nearest = distance < q->nearest ? distance : q->nearest;
    add_task(tasks, q, (const unsigned char *)entry + place_bytes, bytes - place_bytes);
    return 1;
}

void plt_tasks_begin(plt_tasks *tasks, uint16_t *at) {
    tasks->here = *at;
    *at = tasks->queue[tasks->here].after;
    tasks->before = tasks->first;
}

/* It is in no list. */
static inline void free_queue(plt_tasks *tasks, uint16_t queue) {
    tasks->queue[queue].after = tasks->unused_queue;
    tasks->unused_queue = queue;
    tasks->queues--;
}

/* Puts the first entry of the queue on the packet's stack. */
static inline void put_first(plt_tasks *tasks, const plt_task_queue *q, plt_traversal *traversal) {
    const plt_task *task = &tasks->task[q->task];
    unsigned char *entry = traversal->stack;
    tasks->packet = task->packet;
    memcpy(entry, q->place, tasks->place_bytes);
    memcpy(entry + tasks->place_bytes, task->rest, sizeof task->rest);
}

static inline void drop_first(plt_tasks *tasks, plt_task_queue *q) {
    const uint16_t i = q->task;
    q->task = tasks->task[i].next;
    tasks->task[i].next = tasks->unused;
    tasks->unused = i;
    tasks->count--;
}

int plt_tasks_next(plt_tasks *tasks, plt_traversal *traversal) {
    if (tasks->here == PLT_TASK_NONE) {
        return 0;
    }
    plt_task_queue *q = &tasks->queue[tasks->here];
    if (q->task == PLT_TASK_NONE) {
        free_queue(tasks, tasks->here);
        tasks->here = PLT_TASK_NONE;
        return 0;
    }
    put_first(tasks, q, traversal);
    drop_first(tasks, q);
    traversal->waiting = 1;
    return 1;
}

uint32_t plt_tasks_of(const plt_tasks *tasks, uint16_t queue) {
    uint32_t count = 0;
    for (uint16_t i = tasks->queue[queue].task; i != PLT_TASK_NONE; i = tasks->task[i].next) {
        count++;
    }
    return count;
}

void plt_tasks_drop(plt_tasks *tasks, uint16_t *at) {
    const uint16_t i = *at;
    while (tasks->queue[i].task != PLT_TASK_NONE) {
        drop_first(tasks, &tasks->queue[i]);
    }
    *at = tasks->queue[i].after;
    free_queue(tasks, i);
}

/* The first of the unused takes what `task` has. */
static void copy_task(plt_tasks *to, plt_task_queue *q, const plt_task *task) {
    const uint16_t i = to->unused;
    plt_task *copy = &to->task[i];
    to->unused = copy->next;
    to->count++;
    *copy = *task;
    copy->next = q->task;
    q->task = i;
}

int plt_tasks_move(plt_tasks *to, uint16_t *at, plt_tasks *from, uint16_t *from_at) {
    const plt_task_queue *q = &from->queue[*from_at];
    const uint16_t i = to->unused_queue;
    if (i == PLT_TASK_NONE || plt_tasks_of(from, *from_at) > to->most - to->count) {
        return 0;
    }
    plt_task_queue *copy = &to->queue[i];
    to->unused_queue = copy->after;
    to->queues++;
    to->place_bytes = from->place_bytes;
    *copy = *q;
    copy->task = PLT_TASK_NONE;
    for (uint16_t k = q->task; k != PLT_TASK_NONE; k = from->task[k].next) {
        copy_task(to, copy, &from->task[k]);
    }
    copy->after = *at;
    *at = i;
    plt_tasks_drop(from, from_at);
    return 1;
}

#if PLT_WITH_PREFETCH
void plt_tasks_peek(plt_tasks *tasks, const plt_task_queue *queue, plt_traversal *traversal) {
    put_first(tasks, queue, traversal);
}

void plt_tasks_drop_one(plt_tasks *tasks, uint16_t *at) {
    const uint16_t i = *at;
    plt_task_queue *q = &tasks->queue[i];
    drop_first(tasks, q);
    if (q->task == PLT_TASK_NONE) {
        *at = q->after;
        tasks->before = tasks->before == i ? q->after : tasks->before;
        free_queue(tasks, i);
    }
}
#endif
