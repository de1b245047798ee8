/* dispatch - see dispatch.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/schedule/dispatch.h"

#include <string.h>

/* Of packets that wait, those that came back last are looked at for a treelet that the worker has
 * in its store. */
enum { LOOKED_AT = 16 };

void plt_dispatch_init(plt_dispatch *d, uint32_t rooms, unsigned side, void *packets, void *edges) {
    unsigned char *behind = (unsigned char *)packets + plt_packets_bytes(rooms, side);
    memset(d, 0, sizeof *d);
    d->rooms = rooms;
    d->most = plt_dispatch_slots(rooms);
    d->packet = plt_packets_init(rooms, side, packets);
    d->room = (plt_packet_room *)(void *)behind;
    d->slot = (plt_packet_slot *)(void *)(behind + rooms * sizeof(plt_packet_room));
    d->packet_bytes = sizeof(plt_packet) + plt_packet_bytes(side);
    plt_tasks_init(&d->edges, edges, plt_packets_tasks(rooms, side), plt_dispatch_queues(rooms));
    plt_dispatch_clear(d);
}

void plt_dispatch_clear(plt_dispatch *d) {
    if (d->edges.count > 0 || d->edges.queues > 0) {
        plt_tasks_clear(&d->edges);
    }
    memset(d->room, 0, d->rooms * sizeof *d->room);
    d->first = d->count = d->begun = d->out = 0;
    d->number = d->reserved = 0;
    d->out_most = 1;
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
    d->number++;
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

/* Sorts in the worker's edges, as long as there is room. */
static void give_edges(plt_dispatch *d, plt_worker *w, plt_packet_slot *slot) {
    while (w->edges.first != PLT_TASK_NONE) {
        const uint64_t bytes = message_bytes(&w->edges, w->edges.first);
        uint16_t *at = place_of(&d->edges, &slot->edges, w->edges.queue[w->edges.first].nearest);
        if (!plt_tasks_move(&d->edges, at, &w->edges, &w->edges.first)) {
            return;
        }
        d->stats.edges++;
        d->stats.bytes_back += bytes;
    }
}

/* What the worker has to know of the edges that it does not have. */
static void tell_others(const plt_dispatch *d, plt_worker *w, const plt_packet_slot *slot) {
    w->has_others = slot->edges != PLT_TASK_NONE;
    w->others = w->has_others ? d->edges.queue[slot->edges].nearest : 0x1p127f;
}

static void drop_edges(plt_dispatch *d, plt_worker *w, plt_packet_slot *slot) {
    while (slot->edges != PLT_TASK_NONE) {
        plt_tasks_drop(&d->edges, &slot->edges);
    }
    while (w->edges.first != PLT_TASK_NONE) {
        plt_tasks_drop(&w->edges, &w->edges.first);
    }
}

/* ---- give and take ------------------------------------------------------------------ */

static int give(plt_dispatch *d, plt_worker *w) {
    plt_packet_slot *slot = &d->slot[w->slot];
    if (w->packet->active == 0) {
        drop_edges(d, w, slot);
    }
    give_edges(d, w, slot);
    if (w->edges.first != PLT_TASK_NONE) {
        plt_tasks_begin(&w->edges, plt_worker_nearest(&w->edges));
        tell_others(d, w, slot);
        w->is_done = 0;
        return PLT_MORE;
    }
    w->has = 0;
    d->out--;
    if (slot->edges != PLT_TASK_NONE) {
        slot->state = PLT_PACKET_WAITS;
        slot->older = d->newest;
        d->newest = (uint16_t)w->slot;
    } else {
        slot->state = PLT_PACKET_DONE;
        d->room[slot->room].is_taken = 0;
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

/* The nearest of the packet's edges, and those behind it that leave the worker most of its room.
 * The first fits: no worker gives back more than a worker has room for, and this one has nothing.
 */
static void take_edges(plt_dispatch *d, plt_worker *w, plt_packet_slot *slot) {
    uint16_t *at = &w->edges.first;
    do {
        const uint64_t bytes = message_bytes(&d->edges, slot->edges);
        if (!plt_tasks_move(&w->edges, at, &d->edges, &slot->edges)) {
            break;
        }
        d->stats.bytes_out += bytes;
        at = &w->edges.queue[*at].after;
    } while (slot->edges != PLT_TASK_NONE && w->edges.queues < PLT_WORKER_QUEUES / 4 &&
             w->edges.count < PLT_WORKER_TASKS / 4);
    plt_tasks_begin(&w->edges, &w->edges.first);
}

static void take_waiting(plt_dispatch *d, plt_worker *w, uint16_t *at) {
    plt_packet_slot *slot = &d->slot[*at];
    w->slot = *at;
    *at = slot->older;
    take_edges(d, w, slot);
    if (slot->holder != w) { /* from the other worker, and to this one */
        d->stats.packets_moved++;
        d->stats.bytes_back += d->packet_bytes;
        d->stats.bytes_out += d->packet_bytes;
    }
}

/* ---- new packets ---------------------------------------------------------------------- */

static int is_new(const plt_dispatch *d, uint32_t index) {
    return d->slot[slot_at(d, index)].state == PLT_PACKET_NEW;
}

/* Packets go to a worker one after the other that lie beside each other in the picture: all in the
 * ring, over the workers that were seen at once. */
static void reserve_run(plt_dispatch *d, plt_worker *w) {
    const uint32_t left = d->number + d->count - d->reserved;
    const uint32_t most = d->most / d->out_most + 1;
    w->run = d->reserved;
    w->end = d->reserved + (left < most ? left : most);
    d->reserved = w->end;
}

/* Of the worker's run, the next that nobody has taken. 0: there is none. Numbers wrap. The run may
 * be of what was dropped, or of another dispatcher: it counts as far as packets are reserved here.
 */
static int skip_begun(const plt_dispatch *d, plt_worker *w) {
    const uint32_t left = w->end - d->number;
    if (left > d->reserved - d->number) {
        w->run = w->end;
    } else if (w->end - w->run > left) {
        w->run = d->number;
    }
    while (w->run != w->end && !is_new(d, w->run - d->number)) {
        w->run++;
    }
    return w->run != w->end;
}

/* The next of the worker's own run, or the first of a new one, or else one of another's. There
 * is one. */
static uint32_t choose_new(plt_dispatch *d, plt_worker *w) {
    if (!skip_begun(d, w) && d->reserved != d->number + d->count) {
        reserve_run(d, w);
    }
    if (w->run != w->end) {
        return w->run++ - d->number;
    }
    uint32_t first = 0;
    while (!is_new(d, first)) {
        first++;
    }
    return first;
}

/* A free room, the worker's last one if it can be. d->rooms: there is none. */
static uint32_t choose_room(const plt_dispatch *d, const plt_worker *w) {
    uint32_t best = d->rooms;
    for (uint32_t i = 0; i < d->rooms; i++) {
        if (!d->room[i].is_taken && (best == d->rooms || d->room[i].holder == w)) {
            best = i;
        }
    }
    return best;
}

/* 0: there is no new packet, or no room for one. */
static int take_new(plt_dispatch *d, plt_worker *w) {
    const uint32_t room = d->begun < d->count ? choose_room(d, w) : d->rooms;
    if (room == d->rooms) {
        return 0;
    }
    w->slot = slot_at(d, choose_new(d, w));
    d->slot[w->slot].room = (uint16_t)room;
    d->room[room].holder = w;
    d->room[room].is_taken = 1;
    d->begun++;
    return 1;
}

int plt_dispatch_take(plt_dispatch *d, plt_worker *w, const plt_traversal *t) {
    uint16_t *at = choose(d, t);
    if (*at != PLT_TASK_NONE) {
        take_waiting(d, w, at);
    } else if (!take_new(d, w)) {
        return d->out > 0 ? PLT_WAIT : PLT_OK;
    }
    plt_packet_slot *slot = &d->slot[w->slot];
    w->packet = &d->packet[slot->room];
    w->item[0] = slot->item[0];
    w->item[1] = slot->item[1];
    w->is_new = slot->state == PLT_PACKET_NEW;
    tell_others(d, w, slot);
    slot->state = PLT_PACKET_OUT;
    slot->holder = w;
    w->has = 1;
    w->is_done = 0;
    w->status = PLT_OK;
    w->round = d->round;
    d->out++;
    d->out_most = d->out > d->out_most ? d->out : d->out_most;
    d->stats.tasks++;
    return PLT_MORE;
}
