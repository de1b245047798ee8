/* moving - what an engine keeps of triangles that move
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_MOVING_H
#define PLT_MOTION_MOVING_H

#include "engine/motion/beside.h"
#include "engine/motion/dirty.h"
#include "engine/motion/refit.h"
#include "engine/planelet.h"

#if PLT_WITH_BLOCK_MOTION
#include "engine/motion/block_refit.h"
#endif

#if PLT_WITH_REBUILD
#include "engine/motion/rebuild.h"
#endif
#include "engine/motion/subtrees.h"

typedef struct plt_moving {
    plt_refit_level *levels;
    plt_areas areas, areas_built; /* of the tree as it is, and as it was when it was built */
    plt_box box;                  /* of its root */
#if PLT_WITH_BLOCK_MOTION
    plt_block_refit blocks; /* of compact blocks, instead of all that */
#endif
#if PLT_WITH_MOVE_SOME
    plt_dirty dirty; /* places NULL: all triangles move or none */
#endif
#if PLT_WITH_VERTICES
    plt_beside beside; /* of a scene over vertices */
#endif
    uint32_t moves;
    uint8_t is_new; /* the next refit of all says what areas_built are */
#if PLT_WITH_REBUILD
    plt_rebuild rebuild; /* records NULL: there is no room for a tree */
    uint32_t rebuilds;
    float tried;     /* degradation when a new tree was given up, since the last rebuild; or 0 */
    uint64_t work;   /* of plt_stats, that has been looked at */
    uint64_t excess; /* work since the last rebuild that a new tree would have saved */
#endif
#if PLT_WITH_SUBTREES
    plt_subtrees subtrees; /* none: the whole tree is rebuilt */
    uint64_t rebuilt;      /* triangles of all that have been */
#endif
} plt_moving;

/* How much the sum of all ratios has grown since the tree was built, of itself; below 0: it is
 * less. Likewise the sum of all areas. */
float plt_degradation(const plt_moving *m);
float plt_growth(const plt_moving *m);

#if PLT_WITH_REBUILD
/* `work` has been done by the tree as it is. */
void plt_moving_count(plt_moving *m, uint64_t work);
#endif

#if PLT_WITH_SUBTREES
/* The subtree that is the next to be rebuilt, if `work` has been done meanwhile: the one whose
 * excess is the most per triangle; of equals, if nothing has been traced, the one whose areas have
 * grown most. NULL: there is none. */
plt_subtree *plt_moving_worst(const plt_moving *m, uint64_t work);

/* Its excess then. */
uint64_t plt_subtree_excess(const plt_moving *m, const plt_subtree *p, uint64_t work);

float plt_subtree_degradation(const plt_subtree *p);
#endif

#endif
