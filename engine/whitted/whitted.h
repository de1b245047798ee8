/* whitted - pixels with lights, shadows, mirrors and glass, a packet of them at a time
 *
 * Nothing recurs: all rays of a packet's pixels that are due, one each, are traced together, then
 * a shadow ray each for every sample of every light, then what they sent out, until none is left.
 * Each step traces for so many visits, or goes through the pixels once.
 *
 * Source: T. Whitted, "An improved illumination model for shaded display", 1980.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WHITTED_WHITTED_H
#define PLT_WHITTED_WHITTED_H

#include "engine/whitted/state.h"

/* Lays it out in `memory`, plt_whitted_bytes(side, bounces) of it. No lights; all is of clay. */
plt_whitted *plt_whitted_init(void *memory, unsigned side, unsigned bounces);

/* Before a frame: `box` of all that may be hit, which must stay where it is, the eye, and what is
 * up. */
void plt_whitted_frame(plt_whitted *w, const plt_box *box, const float eye[3], const float up[3]);

/* Before a packet: pixel k, in Z order, looks along `dir`, of any length; of another the frame has
 * none. */
void plt_whitted_pixel_set(plt_whitted *w, uint32_t k, const float dir[3], uint8_t turn);
void plt_whitted_pixel_none(plt_whitted *w, uint32_t k);

/* The packet of the pixels' own rays is begun, ray k for pixel k; of those from `rays` on there are
 * none. */
void plt_whitted_begin(plt_whitted *w, const plt_packet *packet, uint32_t rays);

/* PLT_OK: all pixels have their colour; PLT_MORE, or what a fetch failed with. */
int plt_whitted_step(plt_whitted *w, plt_traversal *t, plt_packet *packet, uint32_t visits);

#endif
