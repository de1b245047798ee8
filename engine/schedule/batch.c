/* batch - see batch.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/schedule/batch.h"

#include "engine/schedule/counted.h"
#include "engine/schedule/nearest.h"

void plt_batch_init(plt_batch *b, uint32_t most, unsigned side, void *packets, void *tasks) {
    b->packet = plt_packets_init(most, side, packets);
    b->most = most;
    b->count = 0;
    plt_tasks_init(&b->tasks, tasks, plt_packets_tasks(most, side), plt_batch_queues(most));
}

/* After a batch that was worked off the pools are whole: nothing has to be laid out anew. */
void plt_batch_clear(plt_batch *b) {
    if (b->tasks.count > 0 || b->tasks.queues > 0) {
        plt_tasks_clear(&b->tasks);
    }
    b->count = 0;
}

/* There is a task for every packet, so none goes on before all have come. */
void plt_batch_add(plt_batch *b, plt_traversal *t, uint32_t rays) {
    b->tasks.packet = (uint16_t)b->count;
    t->tasks = &b->tasks;
    plt_traversal_begin(t, &b->packet[b->count++], rays);
    t->tasks = NULL;
}

/* The next packet that has rays left, its entry on the stack. 0: all are done. */
static int resume_next(plt_batch *b, plt_traversal *t) {
    for (;;) {
        while (plt_tasks_next(&b->tasks, t)) {
            if (b->packet[b->tasks.packet].active != 0) {
                return 1;
            }
            t->waiting = 0;
        }
        if (!plt_nearest_begin(&b->tasks, t)) {
            return 0;
        }
        plt_nearest_expect(&b->tasks, b->packet, t);
    }
}

static int trace(plt_batch *b, plt_traversal *t, uint32_t visits) {
    while (t->waiting > 0 || resume_next(b, t)) {
        const int status = plt_traverse_counted(t, &b->packet[b->tasks.packet], &visits);
        if (status != PLT_OK) {
            return status;
        }
    }
    return PLT_OK;
}

int plt_batch_trace(plt_batch *b, plt_traversal *t, uint32_t visits) {
    t->tasks = &b->tasks;
    const int status = trace(b, t, visits);
    plt_traversal_pause(t);
    t->tasks = NULL;
    if (status < 0) {
        plt_batch_clear(b);
    }
    return status;
}
