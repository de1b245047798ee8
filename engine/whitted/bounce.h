/* bounce - the rays that a hit sends out: off a mirror, off glass and through it
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WHITTED_BOUNCE_H
#define PLT_WHITTED_BOUNCE_H

#include "engine/whitted/state.h"

/* All hits are shaded: each pixel goes on with one of the rays that its hit sends out, or one that
 * waits. Those go into `slot`; returns how many. */
uint32_t plt_bounce_all(plt_whitted *w);

#endif
