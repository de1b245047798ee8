/* ray_order - rays sorted so that neighbours meet the same parts of a scene
 *
 * By the cell that a ray begins in, along a Z curve, and within it by its direction: the face of a
 * cube that it leaves through, and where on the face, likewise. What a packet, or a batch, of such
 * neighbours fetches is little, however the rays came.
 *
 * SPDX-License-Identifier: MIT */
#ifndef RAY_ORDER_H
#define RAY_ORDER_H
#include <stdint.h>

#include "engine/planelet.h"

/* order[i]: which ray comes i-th; rays alike keep their order. 0, or -1: out of memory. */
int ray_order_sort(const plt_ray *rays, uint32_t count, uint32_t *order);

#endif
