/* vertices_entry - what a traversal over vertices keeps from visit to visit
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_VERTICES_ENTRY_H
#define PLT_TRACE_VERTICES_ENTRY_H

#include "engine/trace/treelet_entry.h"
#include "engine/tree/vertex_lists.h"

typedef struct plt_vertices_state {
    plt_treelet_state treelet;          /* first, as of nodes over records */
    plt_record record[PLT_LISTED_MOST]; /* of the leaf that is visited */
} plt_vertices_state;

#endif
