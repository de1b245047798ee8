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

#endif
