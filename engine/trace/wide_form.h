/* wide_form - the wide form of a scene, made in the arena when it is opened
 *
 * How large it gets, and who makes it of which format. trace/collapse.h has the algorithm.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WIDE_FORM_H
#define PLT_TRACE_WIDE_FORM_H

#include "engine/trace/traversal.h"
#include "engine/tree/bvh4.h"

/* Links of the wide form reach 4 GiB; so many triangles take at most 281 bytes each. */
#define PLT_WIDE_TRIANGLES_MOST 15000000u

/* Most nodes and blocks that a tree of these counts collapses to, and most nodes on a path. */
uint32_t plt_wide_nodes_bound(const plt_info *info);
uint32_t plt_wide_blocks_bound(const plt_info *info);
uint32_t plt_wide_depth_bound(const plt_info *info);

/* Bytes of all of it, plt_bvh4 included, for the bounds, and while it is made. */
uint64_t plt_wide_bytes(const plt_info *info);
uint64_t plt_wide_scratch_bytes(const plt_info *info);

/* 1: scenes of this format can have a wide form. */
int plt_wide_supports(enum plt_format format);

/* Makes it of the traversal's scene in `memory`, plt_wide_bytes of it; `used_bytes`: what
 * it took, from the front on. The traversal's statistics are lost. */
const plt_bvh4 *plt_wide_make(plt_traversal *t, void *memory, void *scratch, size_t *used_bytes);

#endif
