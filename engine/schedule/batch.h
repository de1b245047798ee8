/* batch - many packets that meet at treelets
 *
 * All packets of a batch are alive at once. Each is traced until it comes to edges, where it waits
 * (trace/tasks.h); then the nearest treelet that packets wait at is worked off. So a treelet
 * is fetched once for a whole batch, however small the store is. Hits are those of packets
 * traced one by one, as every order of visits gives the same.
 *
 * Between two calls of plt_batch_trace nothing but the batch and its traversal may be touched.
 *
 * Sources: Karrenberg 2007, section 4.3 (tasks of a treelet and a packet); Pharr, Kolb,
 * Gershbein, Hanrahan, "Rendering complex scenes with memory-coherent ray tracing", 1997
 * (rays that wait where the geometry is).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCHEDULE_BATCH_H
#define PLT_SCHEDULE_BATCH_H

#include "engine/schedule/packets.h"
#include "engine/trace/tasks.h"
#include "engine/trace/traversal.h"

typedef struct plt_batch {
    plt_packet *packet; /* [most], and their slabs, rays and hulls behind them */
    uint32_t most;      /* packets that are alive at most; 0: there are no batches */
    uint32_t count;     /* begun */
    plt_tasks tasks;
} plt_batch;

/* Treelets that packets wait at. */
static inline uint32_t plt_batch_queues(uint32_t packets) {
    return 8 * packets + 128;
}

static inline uint64_t plt_batch_tasks_bytes(uint32_t packets, unsigned side) {
    return plt_tasks_bytes(plt_packets_tasks(packets, side), plt_batch_queues(packets));
}

/* `packets`, plt_packets_bytes of it, and `tasks`, plt_batch_tasks_bytes of it. */
void plt_batch_init(plt_batch *batch, uint32_t most, unsigned side, void *packets, void *tasks);

/* Drops what the batch has, and begins anew. */
void plt_batch_clear(plt_batch *batch);

/* Begins the packet behind those of the batch, packet[count], which is set up, and has `rays`
 * rays. There are fewer than `most`. */
void plt_batch_add(plt_batch *batch, plt_traversal *t, uint32_t rays);

/* As plt_traverse, of all packets that were added. After a failure the batch is empty. */
int plt_batch_trace(plt_batch *batch, plt_traversal *t, uint32_t visits);

#endif
