/* binary_halve - the global heuristic: splits where a regular grid of the scene would have them
 *
 * The scene's box is halved across its longest side again and again, towards the triangles of a
 * range, until a half leaves some of their centres on either side. So splits lie on one grid for
 * all ranges and do not depend on boxes of triangles; halves without triangles make no nodes.
 *
 * Source: Waechter, Keller, "Instant ray tracing: the bounding interval hierarchy", 2006.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_BINARY_HALVE_H
#define BASELINES_BINARY_HALVE_H

#include "engine/builder/split.h"

/* As plt_split_records; `scene` is the box of all records. What no halving can part, or the range's
 * depth has no levels left for, is halved by count. */
uint32_t binary_halve(plt_record_items *items, const plt_split_range *range, const plt_box *scene,
                      const plt_box *box, plt_box half[2]);

#endif
