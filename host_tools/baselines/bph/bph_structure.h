/* bph_structure - the Bounding Plane Hierarchy of the thesis, as a kind of structure
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_BPH_STRUCTURE_H
#define BASELINES_BPH_STRUCTURE_H

#include "host_tools/baselines/base/kind.h"

extern const structure_kind structure_bph;

#endif
