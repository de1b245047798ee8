/* validate - see validate.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/compact/validate.h"

#include "engine/base/fault.h"
#include "engine/tree/compact/validate_block.h"

static int broken(plt_fault *fault, int rule, uint32_t address) {
    return plt_broken(fault, (uint8_t)rule, address, plt_block_rule_message(rule));
}

/* What has been met of the section. */
typedef struct validation {
    const plt_block_tree *tree;
    plt_info *info;
    plt_fault *fault;
    uint32_t end;   /* of the blocks met so far */
    uint32_t edges; /* of all of them */
    plt_block
        b; /* the block in hand: opened again at each step, because a copy per level costs stack */
} validation;

/* Adds a block that is entered for the first time to the counts. */
static int add_counts(const plt_block_tree *tree, const plt_block *b, plt_info *info) {
    info->treelets++;
    info->nodes += b->nodes;
    info->intermediate_lists += b->pairs;
    info->leaf_lists += b->leaves - b->pairs;
    info->node_bytes += b->node_bytes;
    info->triangle_bytes += b->geometry_bytes;
    if (b->leaves > 0) {
        plt_geometry g;
        plt_geometry_open_counts(&g, b, tree->leaf_triangles);
        if (g.first_triangle != info->triangles) {
            return PLT_I18_COUNTS;
        }
        info->triangles += g.triangles;
    }
    return PLT_BLOCK_VALID;
}

/* The edge with the lowest address above at->last; how many nodes are above it goes
 * into `depth`. PLT_LINK_NONE: none is left. */
static uint32_t next_edge(validation *s, const plt_blocks_validate_level *at, uint32_t *depth) {
    plt_block *b = &s->b;
    uint16_t depths[PLT_BLOCK_NODES_MOST];
    uint32_t best = PLT_LINK_NONE;
    plt_block_open(b, s->tree->bytes + at->address, s->tree->lattice.bits);
    const uint32_t deepest = at->depth + plt_block_depths(b, depths);
    if (deepest > s->info->depth_stack_entries) {
        s->info->depth_stack_entries = deepest;
    }
    for (uint32_t slot = 0; slot < 2 * b->nodes; slot++) {
        if (plt_block_kind(b, slot) != PLT_SLOT_EDGE) {
            continue;
        }
        const uint32_t link = plt_block_edge(b, plt_block_rank(b, PLT_SLOT_EDGE, slot));
        const uint32_t address = plt_block_address(link);
        if (address > at->last && (best == PLT_LINK_NONE || address < plt_block_address(best))) {
            best = link;
            *depth = at->depth + depths[slot / 2];
        }
    }
    return best;
}

/* Validates a block that is met for the first time: it lies where the one before
 * ended, and is as its link says. */
static int enter(validation *s, plt_blocks_validate_level *at) {
    const plt_block_tree *tree = s->tree;
    const unsigned char *bytes = tree->bytes + at->address;
    if (at->address != s->end) {
        return broken(s->fault, PLT_I17_LINKS, at->address);
    }
    int rule = plt_block_validate(bytes, tree->used - at->address, tree);
    if (rule == PLT_BLOCK_VALID) {
        plt_block *b = &s->b;
        plt_block_open(b, bytes, tree->lattice.bits);
        rule = add_counts(tree, b, s->info);
        if (rule == PLT_BLOCK_VALID && at->node_bytes != b->node_bytes) {
            rule = PLT_I17_LINKS;
        }
        s->end += plt_block_bytes(b);
        s->edges += b->edges;
        at->last = at->address;
    }
    return rule == PLT_BLOCK_VALID ? PLT_OK : broken(s->fault, rule, at->address);
}

static int traverse(validation *s, plt_blocks_validate_level *levels) {
    levels[0].address = levels[0].depth = 0;
    levels[0].node_bytes = plt_block_node_bytes(s->tree->root);
    int status = enter(s, &levels[0]);
    for (uint32_t level = 0; status == PLT_OK;) {
        plt_blocks_validate_level *at = &levels[level];
        uint32_t depth = 0;
        const uint32_t link = next_edge(s, at, &depth);
        if (link == PLT_LINK_NONE) {
            if (level-- == 0) {
                break;
            }
            continue;
        }
        at->last = plt_block_address(link);
        if (depth >= PLT_DEPTH_MAX || level + 1 == PLT_DEPTH_MAX) {
            return plt_limit(s->fault, "the tree is deeper than PLT_DEPTH_MAX");
        }
        if (at->last >= s->tree->used) {
            return broken(s->fault, PLT_I17_LINKS, at->address);
        }
        levels[++level].address = at->last;
        levels[level].depth = depth;
        levels[level].node_bytes = plt_block_node_bytes(link);
        status = enter(s, &levels[level]);
    }
    if (status == PLT_OK && (s->end != s->tree->used || s->edges + 1 != s->info->treelets)) {
        status = broken(s->fault, PLT_I17_LINKS, s->end);
    }
    return status;
}

int plt_blocks_validate(const plt_block_tree *tree, plt_blocks_validate_level *levels,
                        plt_info *info, plt_fault *fault) {
    info->nodes = info->node_slots = info->leaf_lists = info->intermediate_lists = 0;
    info->treelets = info->triangles = info->node_bytes = info->triangle_bytes = 0;
    info->local_stack_entries = info->global_stack_entries = info->depth_stack_entries = 0;
    if (tree->root == PLT_LINK_NONE) {
        return tree->used == 0 ? PLT_OK : broken(fault, PLT_I17_LINKS, 0);
    }
    if (plt_block_address(tree->root) != 0 || tree->used == 0) {
        return broken(fault, PLT_I17_LINKS, 0);
    }
    validation s = {.tree = tree, .info = info, .fault = fault};
    const int status = traverse(&s, levels);
    info->node_slots = info->nodes;
    info->node_bytes = tree->used - info->triangle_bytes;
    return status == PLT_OK && info->depth_stack_entries > PLT_DEPTH_MAX
               ? plt_limit(fault, "the tree is deeper than PLT_DEPTH_MAX")
               : status;
}
