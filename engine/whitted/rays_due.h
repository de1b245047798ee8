/* rays_due - the rays of pixels that are due, traced together
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WHITTED_RAYS_DUE_H
#define PLT_WHITTED_RAYS_DUE_H

#include "engine/whitted/state.h"

/* Sets a packet up for the rays of pixels slot[0] .. slot[rays - 1], and begins it.
 * `shadows`: they go towards the current sample of the current light, else they are the pixels'
 * own. */
void plt_rays_due_begin(plt_whitted *w, plt_traversal *t, plt_packet *packet, int shadows);

/* Traces the packet, those rays or the first of pixels, as plt_traverse; incoherent rays go by the
 * wave, if there is one (trace/wave.h), which gives the same hits. */
#if PLT_WITH_WAVE
int plt_rays_due_trace(const plt_whitted *w, plt_traversal *t, plt_packet *packet, uint32_t visits);
#else
static inline int plt_rays_due_trace(const plt_whitted *w, plt_traversal *t, plt_packet *packet,
                                     uint32_t visits) {
    (void)w;
    return plt_traverse(t, packet, visits);
}
#endif

#endif
