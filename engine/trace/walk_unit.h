/* walk_unit - a packet against the triangles of a unit
 *
 * Vertices are read once and turned into floats; a triangle's corners are put in
 * canonical order (record.h), which strips do not keep.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WALK_UNIT_H
#define PLT_TRACE_WALK_UNIT_H

#include "engine/trace/walk.h"

/* Tests the triangles of the unit that `at` leads to; the geometry part of its block
 * is open. */
void plt_walk_leaf_strips(plt_walker *w, const plt_opened_block *block, const plt_block_entry *at);

#endif
