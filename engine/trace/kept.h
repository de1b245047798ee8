/* kept - the triangles that a packet's hits are of, of a streamed scene
 *
 * A hit names its triangle by number, and of a streamed scene nobody knows where that is once its
 * leaf is left. So where hits will be shaded by what their corners have, each ray keeps the
 * triangle of its hit: when a leaf was tested, those that are new. Packets that seek any hit keep
 * none.
 *
 * Invariant: a ray whose hit is of a triangle of that number has that triangle. It may be one that
 * an earlier packet of the frame has left: triangles stay what they are.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_KEPT_H
#define PLT_TRACE_KEPT_H

#include "engine/trace/leaf_compact.h"
#include "engine/trace/traversal.h"

#if PLT_WITH_PAGES

typedef struct plt_kept {
    plt_record record;
    uint32_t index; /* in the image */
} plt_kept;

/* Before a frame: so that none is any triangle's. Beams keep something else there. */
void plt_kept_init(plt_kept *kept, uint32_t rays);

#if PLT_WITH_GROUPS
static inline int plt_keeps(const plt_traversal *t, const plt_packet *p) {
    return t->keeps && !p->any;
}

/* Of a leaf that has been tested for `groups`: records in a row, the first of that index; or
 * triangles of a block. */
void plt_keep_records(plt_kept *kept, const plt_packet *p, const plt_record *records,
                      uint32_t index, uint32_t count, plt_mask groups);
void plt_keep_strips(plt_kept *kept, const plt_packet *p, const plt_block_tree *tree,
                     const plt_geometry *geometry, const plt_leaf_run *run, plt_mask groups);
#endif

#endif
#endif
