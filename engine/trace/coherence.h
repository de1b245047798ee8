/* coherence - do rays that follow one another point alike?
 *
 * A packet of rays traverses boxes as wide as the beam of all its rays; a wave traces each
 * for itself. So it is the width of that beam that counts: how far origins are apart, over the
 * size of the scene, and how far directions are. Looked at in windows of a packet, at least
 * PLT_COHERENCE_WINDOW rays, six operations per ray.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_COHERENCE_H
#define PLT_TRACE_COHERENCE_H

#include "engine/base/box.h"
#include "engine/planelet.h"
#include "engine/trace/packet.h"

enum { PLT_COHERENCE_WINDOW = 64 };

/* Width of the beam above which rays are incoherent: origins by the scene's longest side, and
 * directions by their largest component. Windows of primary rays measured 0.01 to 0.02, of
 * shadow rays mostly up to 0.2, of bounces 0.8 to 1.6 when they are sorted, 2 to 3 when not.
 * Over compact blocks as they are a ray of the wave costs more, and the middle goes in packets. */
#define PLT_COHERENCE_NARROW 0.5f
#define PLT_COHERENCE_NARROW_IN_BLOCKS 1.75f

/* Whether `count` rays are one beam no wider than that, seen from a scene with this box. Whatever
 * is not a number is left out. */
int plt_rays_are_narrow(const plt_ray *rays, uint32_t count, const plt_box *scene, float narrow);

/* The same of the rays of a packet whose groups are set. */
int plt_packet_is_narrow(const plt_packet *packet, float narrow);

static inline int plt_rays_are_coherent(const plt_ray *rays, uint32_t count, const plt_box *scene) {
    return plt_rays_are_narrow(rays, count, scene, PLT_COHERENCE_NARROW);
}

#endif
