/* refit_job - what is kept of a refit between steps
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_REFIT_JOB_H
#define PLT_MOTION_REFIT_JOB_H

#include "engine/motion/node_box.h"
#include "engine/tree/record.h"
#include "engine/tree/thesis/node.h"
#include "engine/tree/vertex_lists.h"

/* A node whose left child is done, or not yet. */
typedef struct plt_refit_level {
    float lo[4], hi[4]; /* of the left child, if it is done */
    uint32_t node;
    uint32_t is_done;
} plt_refit_level;

typedef struct plt_refit_job {
    plt_node *nodes;
    const plt_record *records;
#if PLT_WITH_VERTICES
    const plt_vertex_lists *vertices; /* or these */
#endif
    uint32_t root;           /* link, not PLT_LINK_NONE */
    plt_refit_level *levels; /* as many as there are nodes on the longest path */
    plt_refit_level *top;    /* between steps: the path so far ... */
    uint32_t link;           /* ... and where it goes on */
    plt_areas areas;         /* scale, and results: of all nodes */
    plt_box box;             /* result: of all records */
} plt_refit_job;

#endif
