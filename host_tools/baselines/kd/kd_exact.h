/* kd_exact - whole trees by the surface area heuristic, each cell in time that is linear in it
 *
 * Events are sorted once. A cell's stay in order when they are dealt to its parts; only those of
 * triangles that are cut are new, sorted, and merged.
 *
 * Source: Wald, Havran, "On building fast kd-trees for ray tracing, and on doing that in
 * O(N log N)", 2006, section 4.3.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_KD_EXACT_H
#define BASELINES_KD_EXACT_H

#include "host_tools/baselines/kd/kd_tree.h"

/* The root cell is the tree's, whatever is returned. -1: no memory. */
int kd_build_exactly(kd_tree *t, const kd_scene *s, const kd_cell *root);

#endif
