/* validate_treelet - see validate_treelet.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/thesis/validate_treelet.h"

#include "engine/base/rules.h"
#include "engine/tree/thesis/node_planes.h"

/* Slots from the treelet's first on, in order; breadth first, the next child is at `next`. */
typedef struct scan {
    uint32_t next;
    uint32_t level_end;           /* the level of the slot in hand ends there */
    uint32_t block_at, block_end; /* slots */
} scan;

static int link_rule(const plt_treelet_scene *scene, scan *s, uint32_t link, uint32_t *edges) {
    const uint32_t index = plt_link_index(link);
    if (plt_link_is_leaf(link)) {
        return index < scene->triangles ? PLT_TREELET_VALID : PLT_I3_LIST_ENDS;
    }
    if (plt_link_is_inner(link)) {
        return index == s->next++ && index < s->block_end ? PLT_TREELET_VALID : PLT_I1_LINKS;
    }
    ++*edges;
    return index < scene->node_slots && (index < s->block_at || index >= s->block_end)
               ? PLT_TREELET_VALID
               : PLT_I1_LINKS;
}

static int node_rule(const plt_treelet_scene *scene, scan *s, const plt_node *node,
                     uint32_t *edges) {
    if (plt_node_outside(scene->box, node) != NULL) {
        return PLT_I6_PLANES;
    }
    const int rule = link_rule(scene, s, plt_node_link(node, 0), edges);
    return rule == PLT_TREELET_VALID ? link_rule(scene, s, plt_node_link(node, 1), edges) : rule;
}

int plt_treelet_validate(const plt_treelet_scene *scene, const plt_node *nodes, uint32_t slot,
                         uint32_t count, plt_treelet_facts *facts) {
    const uint32_t block_at = slot - slot % scene->treelet_nodes;
    scan s = {slot + 1, slot + 1, block_at, block_at + scene->treelet_nodes};
    uint32_t i = 0;
    facts->depth = 1;
    facts->edges = 0;
    for (; i < count && slot + i < s.next; i++) {
        if (slot + i == s.level_end) {
            s.level_end = s.next;
            facts->depth++;
        }
        const int rule = node_rule(scene, &s, &nodes[i], &facts->edges);
        if (rule != PLT_TREELET_VALID) {
            return rule;
        }
    }
    facts->nodes = i;
    const int fills = slot == block_at && i == scene->treelet_nodes;
    if (facts->depth > PLT_TREELET_DEPTH_MOST || (facts->edges > 0 && !fills)) {
        return PLT_I2_TREE;
    }
    return slot + i == s.next ? PLT_TREELET_VALID : PLT_TREELET_GOES_ON;
}

/* Does an edge of the block lead to the first slot of a later one? */
static int is_start(const plt_treelet_scene *scene, uint32_t block, uint32_t link, uint32_t *to) {
    *to = plt_link_index(link) / scene->treelet_nodes;
    return (link & PLT_LINK_KIND) == PLT_LINK_OUT &&
           *to * scene->treelet_nodes == plt_link_index(link) && *to > block;
}

static int is_new(const plt_treelet_starts *starts, uint32_t block) {
    int is = 1;
    for (uint32_t i = 0; i < starts->count; i++) {
        is &= starts->block[i] != block;
    }
    return is;
}

int plt_treelet_starts_find(const plt_treelet_scene *scene, const plt_node *nodes, uint32_t block,
                            plt_treelet_starts *starts) {
    int differ = 1;
    starts->count = 0;
    for (uint32_t i = 0; i < 2 * scene->treelet_nodes; i++) {
        uint32_t to = 0;
        if (is_start(scene, block, plt_node_link(&nodes[i / 2], (int)(i & 1)), &to)) {
            differ &= is_new(starts, to);
            starts->block[starts->count++] = to;
        }
    }
    return differ;
}
