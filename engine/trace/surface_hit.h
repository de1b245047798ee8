/* surface_hit - what the corners of a hit's triangle have, wherever that is
 *
 * Of a resident scene triangles are found by their number, or are at hand. Of a streamed one they
 * have been kept (kept.h), and what their corners have may have to be fetched.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_SURFACE_HIT_H
#define PLT_TRACE_SURFACE_HIT_H

#include "engine/surface/surface_corners.h"
#include "engine/trace/traversal.h"

#if PLT_WITH_SURFACE

/* Of a record, which is triangle `index` of the image; without pages that is not looked at. PLT_OK,
 * or what a fetch failed with, of a streamed scene: no block is the current one then, as after any
 * that did not. */
int plt_surface_of_record(plt_traversal *t, const plt_record *record, uint32_t index,
                          plt_surface_corners *corners);

#if PLT_WITH_GROUPS
/* Of what ray `ray` of a packet has hit, likewise. */
int plt_surface_of_ray(plt_traversal *t, const plt_packet *packet, uint32_t ray,
                       plt_surface_corners *corners);

/* Of the triangle of that number, of a resident scene. */
void plt_surface_of_id(const plt_scene *scene, uint32_t id, plt_surface_corners *corners);
#endif

#endif
#endif
