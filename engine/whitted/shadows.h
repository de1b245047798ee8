/* shadows - light on its way through glass to a hit
 *
 * Where an image has glass, a shadow ray asks for the nearest hit. Glass takes its share of the
 * light, and the ray goes on from there, straight; what is opaque ends it. So a sample of a light
 * is one packet per surface of glass in a row, PLT_SHADOW_SURFACES at most, each of the rays that
 * are still on their way.
 *
 * Invariant: a ray's share depends on the ray, the scene and the materials alone: of any-hit rays,
 * which meet triangles in the order of the tree, it would not (DESIGN.md, 9.2).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WHITTED_SHADOWS_H
#define PLT_WHITTED_SHADOWS_H

#include "engine/whitted/state.h"

/* Surfaces of glass that light passes on its way, at most; beyond them it is dark. */
#define PLT_SHADOW_SURFACES 16

/* Light passes through some of what there is. */
static inline int plt_shadows_are_clear(const plt_whitted *w) {
    return w->materials.has_glass && !w->lighting.solid_shadows;
}

/* The pixels of `slot` have a ray each that sets out for the current sample of the light. */
void plt_shadows_begin(plt_whitted *w);

/* The rays are traced: adds the light of those that nothing more is in the way of. Those that go on
 * behind glass stay in `slot`; returns how many. */
uint32_t plt_shadows_take(plt_whitted *w, const plt_packet *packet);

#endif
