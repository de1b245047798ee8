/* nearest - see nearest.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/schedule/nearest.h"

static int is_nearly_full(const plt_tasks *tasks) {
    return tasks->count > tasks->most / 4 * 3 || tasks->queues > tasks->queues_most / 4 * 3;
}

/* A treelet comes into the store when it is worked off, or asked for; one that is not there need
 * not be looked for again. */
static int is_at_hand(plt_task_queue *q, const plt_traversal *traversal) {
    q->is_far = q->is_far || !plt_treelet_at_hand(traversal, q->treelet);
    return !q->is_far;
}

/* Where the index of the queue stands. */
static uint16_t *choose(plt_tasks *tasks, const plt_traversal *traversal) {
    uint16_t *best = &tasks->first;
    int best_at_hand = 0;
    if (is_nearly_full(tasks)) {
        return best;
    }
    for (uint16_t *i = best; *i != PLT_TASK_NONE; i = &tasks->queue[*i].after) {
        plt_task_queue *q = &tasks->queue[*i];
        const int at_hand = is_at_hand(q, traversal);
        if (at_hand > best_at_hand ||
            (at_hand == best_at_hand && q->nearest < tasks->queue[*best].nearest)) {
            best = i;
            best_at_hand = at_hand;
        }
    }
    return best;
}

int plt_nearest_begin(plt_tasks *tasks, const plt_traversal *traversal) {
    uint16_t *at = choose(tasks, traversal);
    if (*at == PLT_TASK_NONE) {
        return 0;
    }
    plt_tasks_begin(tasks, at);
    return 1;
}

#if PLT_WITH_PREFETCH
/* Packets that are looked at, at most, until one is found that is met. */
enum { LOOKS_MOST = 16 };

/* Where the index of the queue stands that choose would find, if its treelet has to be fetched; or
 * NULL. As soon as one is at hand no other matters. */
static uint16_t *choose_far(plt_tasks *tasks, const plt_traversal *traversal) {
    const int is_full = is_nearly_full(tasks);
    uint16_t *best = NULL;
    float nearest = 0x1p127f;
    for (uint16_t *i = &tasks->first; *i != PLT_TASK_NONE; i = &tasks->queue[*i].after) {
        plt_task_queue *q = &tasks->queue[*i];
        if (is_at_hand(q, traversal)) {
            return NULL;
        }
        if (best == NULL || q->nearest < nearest) {
            best = i;
            nearest = q->nearest;
        }
        if (is_full) {
            break;
        }
    }
    return best;
}

void plt_nearest_expect(plt_tasks *tasks, const plt_packet *packets, plt_traversal *t) {
    for (unsigned looks = 0; t->prefetch > 0 && looks < LOOKS_MOST; looks++) {
        uint16_t *at = choose_far(tasks, t);
        if (at == NULL) {
            return;
        }
        plt_task_queue *q = &tasks->queue[*at];
        plt_tasks_peek(tasks, q, t);
        if (plt_edge_is_open(t, &packets[tasks->packet])) {
            q->is_far = 0;
            plt_treelet_expect(t, q->treelet, q->scope);
            return;
        }
        plt_tasks_drop_one(tasks, at);
    }
}
#endif
