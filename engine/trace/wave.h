/* wave - many single rays in flight, advanced one step at a time
 *
 * For rays that have nothing in common. A step of one ray is a visit of one node or a test of
 * four triangles; between two steps of a ray lie those of all others, which is the time that
 * memory has to bring what the next one needs. Which step comes next is arithmetic, not a
 * branch: rays are on one of three lists, and each but that of rays
 * that are done is worked off whole.
 *
 * Invariants: what is computed for a ray depends on it and the scene's box alone, by the
 * arithmetic of packet_set.c and triangle.c: hits are the same, bit for bit. A ray's stack holds
 * at most what plt_wave_bytes (wave_state.h) gives it room for.
 *
 * Source: the idea is Embree's "stream" filters turned round (no sorting, no coherence); the
 * algorithm is ours (DESIGN.md, section 6).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WAVE_H
#define PLT_TRACE_WAVE_H

#include "engine/trace/traversal.h"
#include "engine/trace/wave_state.h"

/* Traces `count` rays. `packet` has room for `most` rays; its first group may be used. If
 * `looks`, coherent rays among them (coherence.h) go in packets. PLT_OK, or what a fetch for a
 * packet failed with: then hits from that packet on are as they were. */
int plt_wave_trace(plt_traversal *t, plt_packet *packet, uint32_t most, int looks,
                   const plt_ray *rays, plt_hit *hits, uint32_t count, int any);

/* Starts on a packet whose groups are set, and counts its `rays`: each of them is traced for
 * itself, and its hit kept where its group would. plt_packet_finish need not have been called. */
void plt_wave_packet_begin(plt_traversal *t, uint32_t rays);

/* Goes on for about `visits` nodes, at most 128 more. PLT_OK: all are traced; or PLT_MORE. */
int plt_wave_packet_step(plt_traversal *t, plt_packet *packet, uint32_t visits);

/* Whether the rays of a packet whose groups are set are better traced so: they are incoherent, or
 * packets of the kind were of little use so far. To be asked once per packet: it counts down to the
 * next try of packets. */
int plt_wave_suits(plt_traversal *t, const plt_packet *packet, enum plt_wave_kind kind);

/* Before and after a packet that is not: learns of what use it was, by its visits; `any` hit will
 * do. */
void plt_wave_watch(plt_traversal *t, enum plt_wave_kind kind, uint32_t rays);
void plt_wave_watch_end(plt_traversal *t, int any);

#endif
