/* dispatch - a dispatcher, which hands tasks to workers
 *
 * The dispatcher has packets, and for each the edges that it waits at: the thesis's global stack,
 * one per packet. A task is a packet and all of its entries at the nearest of those edges, and at
 * some that are next. The worker that gets it traverses the treelets behind them, leaves included,
 * as long as it has room for the edges that the packet meets there, and then gives them back, which
 * are sorted in by distance. While a worker has a packet, nobody
 * else has: hits are written where they are, and are the same whoever found them.
 *
 * Packets are begun in order, in a ring: a slot is free when its packet and all before it are
 * done. What a packet needs while it is traced, much more than its slot, is a room, which is free
 * as soon as it is done; workers keep to their rooms, which are in their caches.
 *
 * Nothing here is safe from two callers at once but plt_worker_run: give and take need a lock
 * around them if workers are threads.
 *
 * Source: Karrenberg 2007, section 4.3 (the first scheme; sorting by distance, leaves before
 * inner nodes). There the stack is of one packet, whose tasks go to all SPEs at once, and
 * "traversal is not influenced by different branches (except for discarding branches if a nearer
 * intersection has been found)"; DESIGN.md, section 3.1, has why it is not so here.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCHEDULE_DISPATCH_H
#define PLT_SCHEDULE_DISPATCH_H

#include "engine/schedule/packets.h"
#include "engine/schedule/worker.h"

enum plt_packet_state {
    PLT_PACKET_NEW,   /* not begun */
    PLT_PACKET_WAITS, /* at edges */
    PLT_PACKET_OUT,   /* a worker has it */
    PLT_PACKET_DONE
};

typedef struct plt_packet_slot {
    const plt_worker *holder; /* has it, or had it last; or NULL */
    uint32_t item[2];         /* what it is of, for those who set it up: a ray, or a pixel */
    uint16_t edges;           /* queue of the nearest; PLT_TASK_NONE: there is none */
    uint16_t older;           /* of those that wait, the one that came back before it */
    uint16_t room;            /* where the packet is, once it is begun, until it is done */
    uint8_t state;            /* enum plt_packet_state */
} plt_packet_slot;

/* Memory of one packet. */
typedef struct plt_packet_room {
    const plt_worker *holder; /* of the last packet in it; NULL: there was none */
    uint32_t is_taken;
} plt_packet_room;

/* Slots per room: who is ahead of the others goes on, as far as that. */
enum { PLT_DISPATCH_AHEAD = 16 };

typedef struct plt_dispatch {
    plt_packet *packet;    /* [rooms] */
    plt_packet_room *room; /* [rooms] */
    plt_packet_slot *slot; /* [most] */
    plt_tasks edges;       /* of all packets */
    uint32_t rooms;        /* 0: there is no dispatcher */
    uint32_t most;         /* packets that are begun, or done before others */
    uint32_t first;        /* slot of the oldest packet */
    uint32_t number;       /* of the oldest packet, from 0 */
    uint32_t reserved;     /* packets below that number are some worker's to begin */
    uint32_t count, begun; /* packets in the ring, and how many of them are not new */
    uint32_t out;          /* with workers */
    uint32_t out_most;     /* ... at once, so far */
    uint32_t round;        /* changes when all of it is dropped */
    uint16_t newest;       /* packet that waits, the last that came back; PLT_TASK_NONE */
    size_t packet_bytes;   /* that move to a worker */
    plt_task_stats stats;
} plt_dispatch;

/* Slots of a dispatcher with room for so many packets. */
static inline uint32_t plt_dispatch_slots(uint32_t packets) {
    return PLT_DISPATCH_AHEAD * packets;
}

/* Bytes of so many packets, with their rooms and slots. */
static inline uint64_t plt_dispatch_bytes(uint32_t packets, unsigned side) {
    return plt_packets_bytes(packets, side) + packets * (uint64_t)sizeof(plt_packet_room) +
           plt_dispatch_slots(packets) * (uint64_t)sizeof(plt_packet_slot);
}

/* Edges that there is room for: few packets wait at once, but theirs may be many (DESIGN.md,
 * section 3.1). */
static inline uint32_t plt_dispatch_queues(uint32_t packets) {
    return 32 * packets + 64;
}

static inline uint64_t plt_dispatch_edges_bytes(uint32_t packets, unsigned side) {
    return plt_tasks_bytes(plt_packets_tasks(packets, side), plt_dispatch_queues(packets));
}

/* `packets`: plt_dispatch_bytes of it, for `rooms`; `edges`: plt_dispatch_edges_bytes. */
void plt_dispatch_init(plt_dispatch *d, uint32_t rooms, unsigned side, void *packets, void *edges);

/* Drops all packets. What a worker still has is dropped when it comes back. */
void plt_dispatch_clear(plt_dispatch *d);

/* Adds a packet, behind the others. There are fewer than `most`. */
void plt_dispatch_add(plt_dispatch *d, const uint32_t item[2]);

/* The slot of the oldest packet, if it is done; else -1. The second frees it. */
int32_t plt_dispatch_oldest(const plt_dispatch *d);
void plt_dispatch_remove(plt_dispatch *d);

/* A worker gives back what it has. PLT_OK; PLT_MORE: it is not done, or there is no room for its
 * edges, and it goes on with the nearest of them; or what its task failed with: then all has been
 * dropped. */
int plt_dispatch_give(plt_dispatch *d, plt_worker *w);

/* A task for a worker that has none. PLT_MORE: it has one now; PLT_WAIT: there is none until
 * another worker comes back; PLT_OK: there are no packets left that are not done. */
int plt_dispatch_take(plt_dispatch *d, plt_worker *w, const plt_traversal *t);

#endif
