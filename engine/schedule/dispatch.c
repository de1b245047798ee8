/* dispatch - see dispatch.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/schedule/dispatch.h"

#include <string.h>

/* Of packets that wait, those that came back last are looked at for a treelet that the worker has
 * in its store. */
enum { LOOKED_AT = 16 };

/* New packets that a worker takes one after the other. */
enum { RUN = 8 };

void plt_dispatch_init(plt_dispatch *d, uint32_t most, unsigned side, void *packets, void *edges) {
    memset(d, 0, sizeof *d);
    d->most = most;
    d->packet = plt_packets_init(most, side, packets);
    d->slot = (plt_packet_slot *)(void *)((unsigned char *)packets + plt_packets_bytes(most, side));
    d->packet_bytes = sizeof(plt_packet) + plt_packet_bytes(side);
    plt_tasks_init(&d->edges, edges, plt_packets_tasks(most, side), plt_dispatch_queues(most));
    plt_dispatch_clear(d);
}

void plt_dispatch_clear(plt_dispatch *d) {
    if (d->edges.count > 0 || d->edges.queues > 0) {
        plt_tasks_clear(&d->edges);
    }
    d->first = d->count = d->begun = d->out = 0;
    d->newest = PLT_TASK_NONE;
    d->round++;
}

/* ---- the ring ----------------------------------------------------------------- */

static uint32_t slot_at(const plt_dispatch *d, uint32_t index) {
    const uint32_t at = d->first + index;
    return at < d->most ? at : at - d->most;
}

void plt_dispatch_add(plt_dispatch *d, const uint32_t item[2]) {
    const plt_packet_slot slot = {.item = {item[0], item[1]},
                                  .edges = PLT_TASK_NONE,
                                  .older = PLT_TASK_NONE,
                                  .state = PLT_PACKET_NEW};
    d->slot[slot_at(d, d->count++)] = slot;
}

int32_t plt_dispatch_oldest(const plt_dispatch *d) {
    const int is_done = d->count > 0 && d->slot[d->first].state == PLT_PACKET_DONE;
    return is_done ? (int32_t)d->first : -1;
}

void plt_dispatch_remove(plt_dispatch *d) {
    d->first = slot_at(d, 1);
    d->count--;
    d->begun--;
    d->stats.packets++;
}

/* ---- edges ---------------------------------------------------------------------- */

/* Bytes of a queue and its tasks, as they go from one memory to another. */
static uint64_t message_bytes(const plt_tasks *tasks, uint16_t queue) {
    return offsetof(plt_task_queue, place) + tasks->place_bytes +
           (uint64_t)plt_tasks_of(tasks, queue) * sizeof(plt_task);
}

/* Where a queue at that distance belongs in the list that begins at `at`, nearest first. */
static uint16_t *place_of(plt_tasks *edges, uint16_t *at, float distance) {
    while (*at != PLT_TASK_NONE && edges->queue[*at].nearest < distance) {
        at = &edges->queue[*at].after;
    }
    return at;
}

/* Sorts the worker's edges in, as long as there is room. */
static void give_edges(plt_dispatch *d, plt_worker *w, plt_packet_slot *slot) {
    while (w->edges.first != PLT_TASK_NONE) {
        const uint16_t i = w->edges.first;
        const uint64_t bytes = message_bytes(&w->edges, i);
        uint16_t *at = place_of(&d->edges, &slot->edges, w->edges.queue[i].nearest);
        if (!plt_tasks_move(&d->edges, at, &w->edges, &w->edges.first)) {
            return;
        }
        d->stats.edges++;
        d->stats.bytes_back += bytes;
    }
}

static void drop_edges(plt_dispatch *d, plt_worker *w, plt_packet_slot *slot) {
    while (slot->edges != PLT_TASK_NONE) {
        plt_tasks_drop(&d->edges, &slot->edges);
    }
    while (w->edges.first != PLT_TASK_NONE) {
        plt_tasks_drop(&w->edges, &w->edges.first);
    }
}

/* The nearest of the edges that the worker could not give back. */
static void go_on(plt_worker *w) {
    uint16_t *nearest = &w->edges.first;
    for (uint16_t *i = nearest; *i != PLT_TASK_NONE; i = &w->edges.queue[*i].after) {
        if (w->edges.queue[*i].nearest < w->edges.queue[*nearest].nearest) {
            nearest = i;
        }
    }
    plt_tasks_begin(&w->edges, nearest);
    w->is_done = 0;
}

/* ---- give and take ------------------------------------------------------------------ */

static int give(plt_dispatch *d, plt_worker *w) {
    plt_packet_slot *slot = &d->slot[w->slot];
    if (d->packet[w->slot].active == 0) {
        drop_edges(d, w, slot);
    }
    give_edges(d, w, slot);
    if (w->edges.first != PLT_TASK_NONE) {
        go_on(w);
        return PLT_MORE;
    }
    w->has = 0;
    d->out--;
    slot->state = PLT_PACKET_DONE;
    if (slot->edges != PLT_TASK_NONE) {
        slot->state = PLT_PACKET_WAITS;
        slot->older = d->newest;
        d->newest = (uint16_t)w->slot;
    }
    return PLT_OK;
}

int plt_dispatch_give(plt_dispatch *d, plt_worker *w) {
    if (!w->has) {
        return PLT_OK;
    }
    if (w->round != d->round) {
        plt_worker_clear(w);
        return PLT_OK;
    }
    if (!w->is_done) {
        return PLT_MORE;
    }
    if (w->status < 0) {
        const int status = w->status;
        plt_worker_clear(w);
        plt_dispatch_clear(d);
        return status;
    }
    return give(d, w);
}

/* Where the packet that comes next stands among those that wait: one whose treelet is in the
 * worker's store, or the last that came back. */
static uint16_t *choose(plt_dispatch *d, const plt_traversal *t) {
    uint16_t *at = &d->newest;
    for (unsigned i = 0; i < LOOKED_AT && *at != PLT_TASK_NONE; i++) {
        const plt_packet_slot *slot = &d->slot[*at];
        if (plt_treelet_at_hand(t, d->edges.queue[slot->edges].treelet)) {
            return at;
        }
        at = &d->slot[*at].older;
    }
    return &d->newest;
}

static void take_waiting(plt_dispatch *d, plt_worker *w, uint16_t *at) {
    plt_packet_slot *slot = &d->slot[*at];
    w->slot = *at;
    *at = slot->older;
    d->stats.bytes_out += message_bytes(&d->edges, slot->edges);
    /* It fits: no worker gives back more than a worker has room for, and this one has nothing. */
    (void)plt_tasks_move(&w->edges, &w->edges.first, &d->edges, &slot->edges);
    plt_tasks_begin(&w->edges, &w->edges.first);
    if (slot->holder != w) { /* from the other worker, and to this one */
        d->stats.packets_moved++;
        d->stats.bytes_back += d->packet_bytes;
        d->stats.bytes_out += d->packet_bytes;
    }
}

/* New packets go to workers by runs, which lie beside each other in the picture. */
static void reserve_run(plt_dispatch *d, const plt_worker *w, uint32_t first) {
    for (uint32_t i = first; i < d->count && i - first < RUN; i++) {
        plt_packet_slot *slot = &d->slot[slot_at(d, i)];
        if (slot->state == PLT_PACKET_NEW && slot->holder == NULL) {
            slot->holder = w;
        }
    }
}

/* The next of the worker's own run, or the first of a run that nobody has, or of another's. There
 * is one. */
static uint32_t choose_new(plt_dispatch *d, const plt_worker *w) {
    uint32_t nobodys = d->count, first = d->count;
    for (uint32_t i = 0; i < d->count; i++) {
        const plt_packet_slot *slot = &d->slot[slot_at(d, i)];
        if (slot->state == PLT_PACKET_NEW) {
            if (slot->holder == w) {
                return i;
            }
            nobodys = nobodys == d->count && slot->holder == NULL ? i : nobodys;
            first = first == d->count ? i : first;
        }
    }
    if (nobodys == d->count) {
        return first;
    }
    reserve_run(d, w, nobodys);
    return nobodys;
}

static void take_new(plt_dispatch *d, plt_worker *w) {
    w->slot = slot_at(d, choose_new(d, w));
    d->begun++;
}

int plt_dispatch_take(plt_dispatch *d, plt_worker *w, const plt_traversal *t) {
    uint16_t *at = choose(d, t);
    if (*at != PLT_TASK_NONE) {
        take_waiting(d, w, at);
    } else if (d->begun < d->count) {
        take_new(d, w);
    } else {
        return d->out > 0 ? PLT_WAIT : PLT_OK;
    }
    plt_packet_slot *slot = &d->slot[w->slot];
    w->is_new = slot->state == PLT_PACKET_NEW;
    slot->state = PLT_PACKET_OUT;
    slot->holder = w;
    w->has = 1;
    w->is_done = 0;
    w->status = PLT_OK;
    w->round = d->round;
    d->out++;
    d->stats.tasks++;
    return PLT_MORE;
}
