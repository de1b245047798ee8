/* treelets_structure - treelets of the thesis's hierarchy as a kind of structure
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_TREELETS_STRUCTURE_H
#define BASELINES_TREELETS_STRUCTURE_H

#include "host_tools/baselines/base/kind.h"
#include "host_tools/baselines/treelets/treelets_choice.h"

/* Its own group of switches. */
enum { TREELETS_BIT = TREELETS_OWN }; /* enum node_edges + 1 */

extern const structure_kind structure_treelets;

#endif
