/* budget - how many bytes each part of an arena takes
 *
 * SPDX-License-Identifier: MIT */
#include "engine/budget.h"

#include "engine/builder/blocks.h"
#include "engine/builder/build.h"

/* Sums are of 64 bits: on a 32-bit machine they may exceed any arena. */
static uint64_t cut(uint64_t bytes) {
    return (bytes + PLT_ALIGN - 1) & ~(uint64_t)(PLT_ALIGN - 1);
}

static uint64_t larger(uint64_t a, uint64_t b) {
    return a > b ? a : b;
}

/* For fields of plt_info; so many bytes of blocks cannot be linked to anyway. */
static uint32_t saturated(uint64_t bytes) {
    return bytes < UINT32_MAX ? (uint32_t)bytes : UINT32_MAX;
}

int plt_options_valid(const plt_options *o) {
    const unsigned side = o->packet_side;
    return (side == 2 || side == 4 || side == 8 || side == 16) && side <= PLT_PACKET_SIDE_MAX &&
           o->order <= PLT_ORDER_TWO_STAGE;
}

int plt_budget_walk_valid(const plt_info *info, const plt_options *o) {
    return info->nodes_format == PLT_NODES_THESIS || o->order == PLT_ORDER_DEPTH_FIRST;
}

size_t plt_budget_groups(const plt_options *o) {
    return (size_t)o->packet_side * o->packet_side / 4 * sizeof(plt_group);
}

uint32_t plt_budget_touched_words(const plt_info *info) {
    if (info->nodes_format == PLT_NODES_COMPACT) {
        return (uint32_t)(((uint64_t)info->node_bytes + info->triangle_bytes) / 8 / 32 + 1);
    }
    return info->node_slots / info->treelet_nodes / 32 + 1;
}

uint32_t plt_budget_main_stack(const plt_info *info, const plt_options *o) {
    const uint32_t need =
        o->order == PLT_ORDER_TWO_STAGE ? info->global_stack_entries : info->depth_stack_entries;
    return need > 0 ? need : 1;
}

uint32_t plt_budget_local_stack(const plt_info *info, const plt_options *o) {
    return o->order == PLT_ORDER_TWO_STAGE ? info->local_stack_entries : 0;
}

size_t plt_budget_entry(const plt_info *info) {
    return info->nodes_format == PLT_NODES_COMPACT ? sizeof(plt_block_entry) : sizeof(plt_entry);
}

size_t plt_budget_open_blocks(const plt_info *info) {
    return info->nodes_format == PLT_NODES_COMPACT ? PLT_OPEN_BLOCKS * sizeof(plt_opened_block) : 0;
}

size_t plt_budget_survey(const plt_info *info) {
    return info->nodes_format == PLT_NODES_COMPACT
               ? PLT_DEPTH_MAX * sizeof(plt_blocks_validate_level)
               : PLT_VALIDATE_LEVELS * sizeof(plt_validate_level);
}

/* What is cut when the scratch of opening has been given back. */
static uint64_t last_bytes(const plt_info *info, const plt_options *o) {
    const uint64_t entry = plt_budget_entry(info);
    return cut(4ull * plt_budget_touched_words(info)) + cut(plt_budget_groups(o)) +
           cut(3 * PLT_TILE_SIDE * PLT_TILE_SIDE) + cut(plt_budget_main_stack(info, o) * entry) +
           cut(plt_budget_local_stack(info, o) * entry) + cut(plt_budget_open_blocks(info));
}

plt_info plt_budget_worst_tree(const plt_info *info) {
    plt_info worst = *info;
    worst.nodes = plt_build_nodes_bound(info->triangles);
    worst.node_slots = plt_build_slots_bound(worst.nodes, info->treelet_nodes);
    worst.depth_stack_entries = PLT_DEPTH_MAX;
    worst.local_stack_entries = PLT_DEPTH_MAX;
    worst.global_stack_entries =
        info->triangles < PLT_GLOBAL_STACK_MAX ? info->triangles : PLT_GLOBAL_STACK_MAX;
    if (info->nodes_format == PLT_NODES_COMPACT) {
        /* A node takes 7.1 bytes, a triangle at most three new vertices of 63
         * bits and its strip bits; blocks of one node add 28 bytes of headers. */
        worst.node_bytes = 8 * worst.nodes + 64;
        worst.triangle_bytes = saturated(40ull * info->triangles + 64);
    }
    return worst;
}

/* Scene and scratch of an image whose tree the engine builds. */
static uint64_t build_bytes(const plt_info *info, const plt_info *worst, uint64_t last,
                            int mapped) {
    const uint64_t survey = cut(plt_budget_survey(info));
    if (info->nodes_format == PLT_NODES_COMPACT) {
        const uint64_t blocks = cut((uint64_t)worst->node_bytes + worst->triangle_bytes);
        const uint32_t corners = plt_corners_bytes(info->lattice_bits);
        const uint64_t window = mapped ? 0 : cut(plt_record_cache_bytes(corners));
        return blocks + larger(cut(plt_blocks_scratch_bytes(info->triangles)) + window, last);
    }
    const uint64_t scene =
        cut(info->triangle_bytes) + cut((uint64_t)worst->node_slots * PLT_NODE_BYTES);
    const uint64_t scratch = cut(plt_build_scratch_bytes(worst->nodes, info->treelet_nodes));
    return scene + larger(larger(scratch, survey), last);
}

static uint64_t fetched_bytes(const plt_info *info) {
    uint32_t kind[PLT_SECTIONS_MOST];
    uint64_t bytes = 0;
    for (unsigned i = plt_header_kinds(info, kind); i-- > 0;) {
        bytes += cut(plt_header_section_bytes(info, kind[i]));
    }
    return bytes;
}

size_t plt_arena_need(const plt_info *info, int mapped, const plt_options *o) {
    if (!plt_options_valid(o) || !plt_budget_walk_valid(info, o) || info->treelet_nodes == 0) {
        return 0;
    }
    uint64_t need = cut(sizeof(plt_engine));
    if (info->build == PLT_BUILD_DEVICE) {
        const plt_info worst = plt_budget_worst_tree(info);
        need += build_bytes(info, &worst, last_bytes(&worst, o), mapped);
    } else {
        need += (mapped ? 0 : fetched_bytes(info)) +
                larger(cut(plt_budget_survey(info)), last_bytes(info, o));
    }
    return need < SIZE_MAX ? (size_t)need : SIZE_MAX;
}
