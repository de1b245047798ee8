/* treelets_structure - treelets of the thesis's hierarchy as a kind of structure
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_TREELETS_STRUCTURE_H
#define BASELINES_TREELETS_STRUCTURE_H

#include "host_tools/baselines/base/kind.h"

/* Its own groups of switches. */
enum treelets_choice {
    TREELETS_SIZE = STRUCTURE_OWN, /* the place in treelets_sizes, from 1 on */
    TREELETS_ORDER,                /* enum treelet_order + 1 */
    TREELETS_AGAIN,                /* 1: what comes off a stack is tested again, 2: it is not */
    TREELETS_FILL,                 /* enum treelet_fill + 1 */
    TREELETS_SLOTS,                /* enum treelet_slots + 1 */
    TREELETS_BIT                   /* enum node_edges + 1 */
};

/* Of Tables 5.5 and 5.6. */
enum { TREELETS_SIZES = 9 };
extern const uint32_t treelets_sizes[TREELETS_SIZES];

extern const structure_kind structure_treelets;

#endif
