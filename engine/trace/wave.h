/* wave - many single rays in flight, advanced one step at a time
 *
 * For rays that have nothing in common. A step of one ray is a visit of one node or a test of
 * four triangles; between two steps of a ray lie those of all others, which is the time that
 * memory has to bring what the next one needs. Which step comes next is arithmetic, not a
 * branch: rays are on one of three lists, and every list is worked off whole.
 *
 * Invariants: what is computed for a ray depends on it and the scene's box alone, by the
 * arithmetic of packet.c and triangle.c: hits are the same, bit for bit. A ray's stack holds
 * at most what plt_wave_bytes (wave_state.h) gives it room for.
 *
 * Source: the idea is Embree's "stream" filters turned round (no sorting, no coherence); the
 * algorithm is ours (DESIGN.md, section 6).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WAVE_H
#define PLT_TRACE_WAVE_H

#include "engine/trace/traversal.h"

/* Traces `count` rays. `packet` has room for `most` rays; its first group may be used. If
 * `looks`, coherent rays among them (coherence.h) go in packets. PLT_OK, or what a fetch for a
 * packet failed with: then hits from that packet on are as they were. */
int plt_wave_trace(plt_traversal *t, plt_packet *packet, uint32_t most, int looks,
                   const plt_ray *rays, plt_hit *hits, uint32_t count, int any);

#endif
