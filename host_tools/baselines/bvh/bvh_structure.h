/* bvh_structure - bounding volume hierarchies as kinds of structures
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_BVH_STRUCTURE_H
#define BASELINES_BVH_STRUCTURE_H

#include "host_tools/baselines/base/kind.h"

extern const structure_kind structure_bvh, structure_wbvh;

#endif
