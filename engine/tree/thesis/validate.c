/* validate - see validate.h
 *
 * Needs, for a node in hand (SPEC.md, section 5, has the derivation):
 *   local  = the greater child's + 1 when both children are inner to the
 *            treelet (the far one waits), else the inner child's, else 0
 *   edges  = edges of inner children + 1 for every other child
 *   depth  = the greater child's + 1, a leaf counting 0
 *   locals = the greatest local need of any treelet behind an edge: treelets
 *            follow one another on the same local stack
 *   global need of a treelet = edges + max(0, beyond - 1): one edge is followed,
 *            the others wait while what lies behind it is worked off
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/thesis/validate.h"

#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/header_at.h"
#include "engine/tree/thesis/node_planes.h"

static uint32_t larger(uint32_t a, uint32_t b) {
    return a > b ? a : b;
}

static uint32_t treelet_need(const plt_need *root) {
    return root->edges + (root->beyond > 0 ? root->beyond - 1 : 0);
}

/* Reads the lists of a leaf link. Lists lie in the order of a left-first traversal,
 * `seen` records in all so far: every record is in one list and read once. */
static int validate_lists(const plt_tree *tree, uint32_t link, uint32_t *seen, plt_info *info,
                          plt_fault *fault) {
    uint32_t record = plt_link_index(link);
    if (record != *seen) {
        return plt_broken(fault, PLT_I4_LIST_ORDER, record,
                          "a list does not follow the one before it");
    }
    for (uint32_t lists = plt_link_lists(link); lists > 0; lists--) {
        uint32_t length = 0;
        do {
            if (record >= tree->records_count) {
                return plt_broken(fault, PLT_I3_LIST_ENDS, record - 1,
                                  "a list of triangles runs past the last one");
            }
            length++;
        } while (!plt_tree_is_last(tree, record++));
        info->leaf_triangles = larger(info->leaf_triangles, length);
    }
    *seen = record;
    if (plt_link_lists(link) == 2) {
        info->intermediate_lists++;
    } else {
        info->leaf_lists++;
    }
    return PLT_OK;
}

static void combine(plt_need *need, const plt_node *node, const plt_need child[2]) {
    const plt_need none = {0, 0, 0, 0, 0};
    *need = none;
    int inner = 0;
    for (int c = 0; c < 2; c++) {
        const uint32_t link = plt_node_link(node, c);
        need->depth = larger(need->depth, child[c].depth);
        need->locals = larger(need->locals, child[c].locals);
        if (plt_link_is_inner(link)) {
            inner++;
            need->local = larger(need->local, child[c].local);
            need->edges += child[c].edges;
            need->beyond = larger(need->beyond, child[c].beyond);
        } else {
            need->edges++;
            if (!plt_link_is_leaf(link)) {
                need->beyond = larger(need->beyond, treelet_need(&child[c]));
                need->locals = larger(need->locals, child[c].local);
            }
        }
    }
    need->local += inner == 2;
    need->depth++;
}

/* An inner link stays in the block of its node, an edge leaves it. */
static int link_kind_is_right(const plt_tree *tree, uint32_t node, uint32_t link) {
    const int same = node / tree->treelet_nodes == plt_link_index(link) / tree->treelet_nodes;
    return same == plt_link_is_inner(link);
}

/* The link from node `from` leads to a node that may be visited, and counts it. */
static int check_link(const plt_tree *tree, uint32_t from, uint32_t link, plt_info *info,
                      plt_fault *fault) {
    if (plt_link_index(link) >= tree->node_slots) {
        return plt_broken(fault, PLT_I1_LINKS, from, "a link names a node that is not there");
    }
    if (!link_kind_is_right(tree, from, link)) {
        return plt_broken(fault, PLT_I1_LINKS, from, "a link is not in the treelet that it says");
    }
    if (++info->nodes > tree->node_slots) {
        return plt_broken(fault, PLT_I2_TREE, from, "the nodes form no tree");
    }
    info->treelets += (link & PLT_LINK_OUT) != 0;
    return PLT_OK;
}

/* Post-order traversal of the subtree of levels[0].node, from `*depth` on, which is 0 at first,
 * until `seen` is `until` or more: PLT_MORE. */
static int traverse(const plt_tree *tree, plt_validate_level *levels, uint32_t *depth,
                    uint32_t until, plt_need *root, uint32_t *seen, plt_info *info,
                    plt_fault *fault) {
    for (uint32_t level = *depth;;) {
        plt_validate_level *at = &levels[level];
        const plt_node *node = &tree->nodes[at->node];
        if (at->next_child == 2) {
            plt_need need;
            combine(&need, node, at->need);
            if (level == 0) {
                *root = need;
                return PLT_OK;
            }
            level--;
            levels[level].need[levels[level].next_child++] = need;
            continue;
        }
        const uint32_t link = plt_node_link(node, (int)at->next_child);
        if (plt_link_is_leaf(link)) {
            const plt_need leaf = {0, 0, 0, 0, 0};
            const int status =
                *seen < until ? validate_lists(tree, link, seen, info, fault) : PLT_MORE;
            if (status != PLT_OK) {
                *depth = level;
                return status;
            }
            at->need[at->next_child++] = leaf;
            continue;
        }
        const int status = check_link(tree, at->node, link, info, fault);
        if (status != PLT_OK) {
            return status;
        }
        if (++level == PLT_DEPTH_MAX) {
            return plt_limit(fault, "the tree is deeper than PLT_DEPTH_MAX");
        }
        levels[level].node = plt_link_index(link);
        levels[level].next_child = 0;
    }
}

static void set_needs(plt_info *info, const plt_need *root) {
    info->local_stack_entries = larger(root->local, root->locals);
    info->global_stack_entries = larger(1, treelet_need(root));
    info->depth_stack_entries = larger(1, root->depth);
}

/* The root link is a node: traverses what is below it and fills in the stack needs. */
static int validate_nodes(const plt_tree *tree, plt_validate_level *levels, uint32_t *seen,
                          plt_info *info, plt_fault *fault) {
    if (plt_link_index(tree->root) >= tree->node_slots) {
        return plt_broken(fault, PLT_I1_LINKS, PLT_AT_ROOT_LINK,
                          "the root link names a node that is not there");
    }
    info->nodes = info->treelets = 1;
    levels[0].node = plt_link_index(tree->root);
    levels[0].next_child = 0;
    plt_need root;
    uint32_t depth = 0;
    const int status = traverse(tree, levels, &depth, UINT32_MAX, &root, seen, info, fault);
    if (status == PLT_OK) {
        set_needs(info, &root);
    }
    return status;
}

#if PLT_WITH_REBUILD
void plt_tree_count_begin(plt_counting *c, const plt_tree *tree, plt_info *info) {
    info->nodes = info->treelets = 1;
    info->leaf_lists = info->intermediate_lists = info->leaf_triangles = 0;
    c->depth = c->seen = 0;
    c->levels[0].node = plt_link_index(tree->root);
    c->levels[0].next_child = 0;
}

int plt_tree_count(plt_counting *c, const plt_tree *tree, uint32_t triangles, plt_info *info) {
    const uint32_t left = tree->records_count - c->seen;
    plt_fault fault;
    plt_need root;
    const int status =
        traverse(tree, c->levels, &c->depth, triangles < left ? c->seen + triangles : UINT32_MAX,
                 &root, &c->seen, info, &fault);
    if (status == PLT_OK) {
        set_needs(info, &root);
    }
    return status;
}
#endif

int plt_tree_validate(const plt_tree *tree, plt_validate_level *levels, plt_info *info,
                      plt_fault *fault) {
    info->nodes = info->leaf_lists = info->intermediate_lists = info->treelets = 0;
    info->leaf_triangles = 0;
    info->local_stack_entries = info->global_stack_entries = info->depth_stack_entries = 0;
    if (tree->root == PLT_LINK_NONE) {
        return PLT_OK;
    }
    uint32_t seen = 0;
    info->global_stack_entries = info->depth_stack_entries = 1;
    const int status = plt_link_is_leaf(tree->root)
                           ? validate_lists(tree, tree->root, &seen, info, fault)
                           : validate_nodes(tree, levels, &seen, info, fault);
    if (status == PLT_OK && seen != tree->records_count) {
        return plt_broken(fault, PLT_I4_LIST_ORDER, seen, "a triangle is in no list");
    }
    return status;
}

int plt_planes_validate(const plt_header *header, const plt_node *nodes, plt_fault *fault) {
    const uint32_t offset = plt_header_section(header, PLT_SECTION_NODES)->offset;
    plt_between box[3];
    plt_between_set(box, header->info.lo, header->info.hi);
    for (const plt_node *node = nodes, *end = nodes + header->info.node_slots; node < end; node++) {
        const uint32_t *plane = plt_node_outside(box, node);
        if (plane != NULL) {
            return plt_broken(fault, PLT_I6_PLANES, offset + 4 * (uint32_t)(plane - nodes->word),
                              "a plane lies outside the scene's box");
        }
    }
    return PLT_OK;
}
