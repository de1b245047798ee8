/* treelet_trees_structure - other trees in treelets as kinds of structures
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_TREELET_TREES_STRUCTURE_H
#define BASELINES_TREELET_TREES_STRUCTURE_H

#include "host_tools/baselines/base/kind.h"

extern const structure_kind structure_bvh_treelets, structure_bkd_treelets, structure_bih_treelets;

#endif
