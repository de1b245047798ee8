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
typedef struct surveying {
    const plt_block_tree *tree;
    plt_info *info;
    plt_fault *fault;
    uint32_t end;   /* of the blocks met so far */
    uint32_t edges; /* of all of them */
    plt_block b;    /* the block in hand: opened anew at each step, as stacks are short */
} surveying;

/* Depth of every node of a block, and the deepest into `info`. */
static void node_depths(const plt_block *b, uint32_t depth, uint16_t *depths, plt_info *info) {
    depths[0] = (uint16_t)(depth + 1);
    for (uint32_t slot = 0; slot < 2 * b->nodes; slot++) {
        if (plt_block_kind(b, slot) == PLT_SLOT_INNER) {
            depths[1 + plt_block_rank(b, PLT_SLOT_INNER, slot)] = (uint16_t)(depths[slot / 2] + 1);
        }
    }
    for (uint32_t i = 0; i < b->nodes; i++) {
        info->depth_stack_entries =
            depths[i] > info->depth_stack_entries ? depths[i] : info->depth_stack_entries;
    }
}

/* Takes a block that the walk arrives at for the first time into the counts. */
static int count(const plt_block_tree *tree, const plt_block *b, plt_info *info) {
    info->treelets++;
    info->nodes += b->nodes;
    info->intermediate_lists += b->pairs;
    info->leaf_lists += b->units - b->pairs;
    info->node_bytes += b->node_bytes;
    info->triangle_bytes += b->geometry_bytes;
    if (b->units > 0) {
        plt_geometry g;
        plt_geometry_open_counts(&g, b, tree->leaf_triangles);
        if (g.first_triangle != info->triangles) {
            return PLT_BLOCK_RULE_COUNTS;
        }
        info->triangles += g.triangles;
    }
    return PLT_BLOCK_VALID;
}

/* The edge with the lowest address above f->last; its number of nodes above
 * into `depth`. PLT_MISS: none is left. */
static uint32_t next_edge(surveying *s, const plt_blocks_validate_level *f, uint32_t *depth) {
    plt_block *b = &s->b;
    uint16_t depths[PLT_BLOCK_NODES_MOST];
    uint32_t best = PLT_MISS;
    plt_block_open(b, s->tree->bytes + f->address, s->tree->lattice.bits);
    node_depths(b, f->depth, depths, s->info);
    for (uint32_t slot = 0; slot < 2 * b->nodes; slot++) {
        if (plt_block_kind(b, slot) != PLT_SLOT_EDGE) {
            continue;
        }
        const uint32_t link = plt_block_edge(b, plt_block_rank(b, PLT_SLOT_EDGE, slot));
        const uint32_t address = plt_block_address(link);
        if (address > f->last && (best == PLT_MISS || address < plt_block_address(best))) {
            best = link;
            *depth = depths[slot / 2];
        }
    }
    return best;
}

/* The first time at a block: it lies where the one before ended, and is as its link says. */
static int arrive(surveying *s, plt_blocks_validate_level *f) {
    const plt_block_tree *tree = s->tree;
    const unsigned char *bytes = tree->bytes + f->address;
    if (f->address != s->end) {
        return broken(s->fault, PLT_BLOCK_RULE_LINKS, f->address);
    }
    int rule = plt_block_validate(bytes, tree->used - f->address, tree);
    if (rule == PLT_BLOCK_VALID) {
        plt_block *b = &s->b;
        plt_block_open(b, bytes, tree->lattice.bits);
        rule = count(tree, b, s->info);
        if (rule == PLT_BLOCK_VALID && f->node_bytes != b->node_bytes) {
            rule = PLT_BLOCK_RULE_LINKS;
        }
        s->end += plt_block_bytes(b);
        s->edges += b->edges;
        f->last = f->address;
    }
    return rule == PLT_BLOCK_VALID ? PLT_OK : broken(s->fault, rule, f->address);
}

static int walk(surveying *s, plt_blocks_validate_level *frames) {
    frames[0].address = frames[0].depth = 0;
    frames[0].node_bytes = plt_block_node_bytes(s->tree->root);
    int status = arrive(s, &frames[0]);
    for (uint32_t level = 0; status == PLT_OK;) {
        plt_blocks_validate_level *f = &frames[level];
        uint32_t depth = 0;
        const uint32_t link = next_edge(s, f, &depth);
        if (link == PLT_MISS) {
            if (level-- == 0) {
                break;
            }
            continue;
        }
        f->last = plt_block_address(link);
        if (depth >= PLT_DEPTH_MAX || level + 1 == PLT_DEPTH_MAX) {
            return plt_limit(s->fault, "the tree is deeper than PLT_DEPTH_MAX");
        }
        if (f->last >= s->tree->used) {
            return broken(s->fault, PLT_BLOCK_RULE_LINKS, f->address);
        }
        frames[++level].address = f->last;
        frames[level].depth = depth;
        frames[level].node_bytes = plt_block_node_bytes(link);
        status = arrive(s, &frames[level]);
    }
    if (status == PLT_OK && (s->end != s->tree->used || s->edges + 1 != s->info->treelets)) {
        status = broken(s->fault, PLT_BLOCK_RULE_LINKS, s->end);
    }
    return status;
}

int plt_blocks_validate(const plt_block_tree *tree, plt_blocks_validate_level *frames,
                        plt_info *info, plt_fault *fault) {
    info->nodes = info->node_slots = info->leaf_lists = info->intermediate_lists = 0;
    info->treelets = info->triangles = info->node_bytes = info->triangle_bytes = 0;
    info->local_stack_entries = info->global_stack_entries = info->depth_stack_entries = 0;
    if (tree->root == PLT_MISS) {
        return tree->used == 0 ? PLT_OK : broken(fault, PLT_BLOCK_RULE_LINKS, 0);
    }
    if (plt_block_address(tree->root) != 0 || tree->used == 0) {
        return broken(fault, PLT_BLOCK_RULE_LINKS, 0);
    }
    surveying s = {.tree = tree, .info = info, .fault = fault};
    const int status = walk(&s, frames);
    info->node_slots = info->nodes;
    info->node_bytes = tree->used - info->triangle_bytes;
    return status == PLT_OK && info->depth_stack_entries > PLT_DEPTH_MAX
               ? plt_limit(fault, "the tree is deeper than PLT_DEPTH_MAX")
               : status;
}
