/* engine_structure - the engine's tree and grid, as kinds of structures
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_ENGINE_STRUCTURE_H
#define BASELINES_ENGINE_STRUCTURE_H

#include "host_tools/baselines/base/kind.h"

extern const structure_kind structure_tree, structure_tree_never, structure_tree_always,
    structure_grid;

#endif
