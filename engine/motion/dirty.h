/* dirty - a refit of some triangles: their records, and the paths above them
 *
 * A bit says of each record that it has changed. Lists lie in the order of a left-first traversal,
 * so a subtree is a range of records, and where no bit of it is set, its box is the one that its
 * parent's planes give it: boxes come down from the root as rays see them, and new ones go up.
 *
 * Keeps: every byte is that of a refit of all (refit.h).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_DIRTY_H
#define PLT_MOTION_DIRTY_H

#include "engine/motion/node_box.h"
#include "engine/motion/subtrees.h"
#include "engine/tree/thesis/tree.h"

/* A node above a record that has changed. */
typedef struct plt_dirty_level {
    float old_lo[4], old_hi[4]; /* its box before */
    float lo[4], hi[4];         /* of its left child, once that is done */
    uint32_t node, right, end;  /* right: first record of the right child; end: behind its last */
    uint32_t is_done;           /* the left child is */
} plt_dirty_level;

typedef struct plt_dirty {
    uint32_t *places; /* of each id: its record */
    uint32_t *bits;   /* of each record; all 0 between calls */
    plt_dirty_level *levels;
#if PLT_WITH_SUBTREES
    const plt_subtrees *subtrees; /* whose areas are counted, too; NULL: there are none */
#endif
} plt_dirty;

/* Bytes of places and bits. */
static inline uint64_t plt_dirty_bytes(uint32_t records) {
    return 4ull * records + 4 * (((uint64_t)records + 31) / 32);
}

static inline void plt_dirty_set(plt_dirty *d, uint32_t record) {
    d->bits[record / 32] |= 1u << record % 32;
}

/* Where each id is. 0: two records have one. */
int plt_dirty_find(plt_dirty *d, const plt_record *records, uint32_t count);

/* Refits what is above records whose bit is set, one at least. `box`: the
 * root's, before and after; `areas`: of all nodes, likewise. The tree has a node, and its
 * boxes are those of its records but for these. */
void plt_dirty_refit(plt_dirty *d, const plt_tree *tree, plt_box *box, plt_areas *areas);

#endif
