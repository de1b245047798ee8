/* ray_kinds - rays of every kind that tracers are measured with, from one view of a scene
 *
 *   primary  one through each pixel of the view, in Z order in tiles of 16x16: consecutive runs
 *            of 4, 16, 64 or 256 rays are square packets (at the edges of the frame less)
 *   shadow   from every hit of those, in their order, to one light
 *   light    the same the other way round, from the light: all have one origin
 *   bounce   from every hit into a random direction, as diffuse surfaces reflect (the cosine
 *            law), in random order: neighbours have nothing in common
 *   random   from a random point of one side of the scene's box to one of another side
 *   outside  from outside in random directions: lines of equal density through the ball around
 *            the box, from two of its radii before its middle
 *   inside   from random points of the middle of the box, half as long, wide and high, in random
 *            directions: in a closed room all of them hit
 *
 * Of each of the last three there are as many as of primary rays, without any order.
 * Shadow and bounce rays start 1e-4 of the box's diagonal above their surface, and those of the
 * light end there. The same scene and view give the same rays, whichever kinds are made: random
 * numbers are xorshift's, from fixed seeds.
 *
 * Source: Malley's method for the cosine law (Pharr, Jakob,
 * Humphreys, "Physically Based Rendering", 2016, section 13.6.3).
 *
 * SPDX-License-Identifier: MIT */
#ifndef RAY_KINDS_H
#define RAY_KINDS_H

#include "engine/planelet.h"
#include "host_tools/app/ray_box.h"
#include "host_tools/base/fail.h"

enum ray_kind {
    RAYS_PRIMARY,
    RAYS_SHADOW,
    RAYS_LIGHT,
    RAYS_BOUNCE,
    RAYS_RANDOM,
    RAYS_OUTSIDE,
    RAYS_INSIDE,
    RAY_KINDS
};

extern const char *const ray_kind_names[RAY_KINDS + 1]; /* ended by NULL */

typedef struct ray_kinds {
    ray_set of[RAY_KINDS];
} ray_kinds;

/* Makes some of them, `kinds` (a bit each, enum ray_kind), with an open engine, whose frame and
 * statistics are lost. `frame` has a camera that the engine takes and at most 2^24 pixels. Fails
 * when memory is out or, for the first three kinds, no primary ray hits; `name` is for errors.
 * `r` is freed by ray_kinds_free also after that. */
int ray_kinds_make(ray_kinds *r, unsigned kinds, plt_engine *engine, const plt_frame *frame,
                   const char *name, fail *f);
void ray_kinds_free(ray_kinds *r);

#endif
