/* engine_structure - the engine's tree and grid, as kinds of structures
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_ENGINE_STRUCTURE_H
#define BASELINES_ENGINE_STRUCTURE_H

#include "host_tools/baselines/base/kind.h"

extern const structure_kind structure_tree, structure_tree_never, structure_tree_always,
    structure_grid;

/* One that is open already, whoever has opened it; without a name that could be asked for. */
extern const structure_kind structure_opened;
void *engine_structure_of(plt_engine *engine, const char *name); /* its self; NULL: no memory */

#endif
