/* collapse_formats - the formats that have a wide form
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_COLLAPSE_FORMATS_H
#define PLT_TRACE_COLLAPSE_FORMATS_H

#include "engine/trace/traversal.h"
#include "engine/tree/bvh4.h"

/* Bytes that each subtree still to be made takes of the scratch. */
enum { PLT_COLLAPSE_ENTRY_BYTES = 96 };

/* A link that leads nowhere, while it is made. */
#define PLT_COLLAPSE_NONE 0xFFFFFFFFu

/* What a collapse writes. `nodes` and `blocks` have room for plt_wide_nodes_bound and
 * plt_wide_blocks_bound. */
typedef struct plt_wide_build {
    plt_bvh4_node *nodes;
    plt_bvh4_block *blocks;
    void *scratch; /* plt_wide_scratch_bytes */
    uint32_t nodes_count, blocks_count, root, depth;
} plt_wide_build;

/* ROW(NAME, name, knob that builds it in), names as in scene/formats.h. */
#define PLT_WIDE_FORMATS(ROW)                                                                      \
    ROW(THESIS, thesis, PLT_WITH_THESIS)                                                           \
    ROW(COMPACT, compact, PLT_WITH_COMPACT)

/* plt_thesis_collapse ...: makes nodes, blocks and root. */
#define PLT_COLLAPSE_DECLARED(NAME, name, with)                                                    \
    void plt_##name##_collapse(plt_traversal *t, plt_wide_build *build);
PLT_WIDE_FORMATS(PLT_COLLAPSE_DECLARED)
#undef PLT_COLLAPSE_DECLARED

#endif
