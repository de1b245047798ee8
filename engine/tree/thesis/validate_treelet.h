/* validate_treelet - is a treelet, which has come by itself, safe to traverse?
 *
 * A tree that is read whole is a tree because each record is met once (validate.h). Of a streamed
 * one only a treelet is known; so more is asked of it, which all that our builder makes is
 * (SPEC.md, 5.5): its nodes stand breadth first, and if edges leave it, it fills a block of N
 * slots.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_THESIS_VALIDATE_TREELET_H
#define PLT_TREE_THESIS_VALIDATE_TREELET_H

#include "engine/base/between.h"
#include "engine/tree/thesis/node.h"

/* The scene, as its header describes it. */
typedef struct plt_treelet_scene {
    plt_between box[3];
    uint32_t treelet_nodes, node_slots, triangles;
} plt_treelet_scene;

/* Blocks behind the treelet's own that an edge leads to the first slot of: what is there may have
 * edges itself. Room for N + 1. */
typedef struct plt_treelet_starts {
    uint32_t count;
    uint32_t *block;
} plt_treelet_starts;

typedef struct plt_treelet_facts {
    uint32_t nodes; /* from its first slot on */
    uint32_t depth; /* in nodes */
    uint32_t edges; /* that leave it */
} plt_treelet_facts;

enum { PLT_TREELET_VALID = 0, PLT_TREELET_GOES_ON = -1 };

/* What is deeper is no treelet of a tree of PLT_DEPTH_MAX 64. */
enum { PLT_TREELET_DEPTH_MOST = 64 };

/* The treelet that begins in `slot`, of which `count` slots are at `nodes`, none beyond its block.
 * PLT_TREELET_VALID, PLT_TREELET_GOES_ON: it has more nodes than that, or the rule that it
 * breaks. */
int plt_treelet_validate(const plt_treelet_scene *scene, const plt_node *nodes, uint32_t slot,
                         uint32_t count, plt_treelet_facts *facts);

/* Of a treelet that fills the block and is valid. 0: two edges lead to the same block. */
int plt_treelet_starts_find(const plt_treelet_scene *scene, const plt_node *nodes, uint32_t block,
                            plt_treelet_starts *starts);

#endif
