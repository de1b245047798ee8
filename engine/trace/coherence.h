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

enum { PLT_COHERENCE_WINDOW = 64 };

/* Whether `count` rays are one beam that is narrow, seen from a scene with this box. Whatever
 * is not a number is left out. */
int plt_rays_are_coherent(const plt_ray *rays, uint32_t count, const plt_box *scene);

#endif
