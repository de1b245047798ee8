/* worst_tree - see worst_tree.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/scene/worst_tree.h"

#include "engine/builder/build.h"

/* For fields of plt_info; so many bytes of blocks cannot be linked to anyway. */
static uint32_t saturated(uint64_t bytes) {
    return bytes < UINT32_MAX ? (uint32_t)bytes : UINT32_MAX;
}

#if PLT_WITH_REBUILD
plt_info plt_rebuilt_tree(const plt_info *info, uint32_t room) {
    plt_info worst = *info;
    worst.nodes = plt_build_nodes_bound(info->triangles);
    worst.nodes = worst.nodes < room ? worst.nodes : room;
    worst.node_slots = room;
    worst.depth_stack_entries = PLT_DEPTH_MAX;
    worst.local_stack_entries = PLT_DEPTH_MAX;
    worst.global_stack_entries =
        info->triangles < PLT_GLOBAL_STACK_MAX ? info->triangles : PLT_GLOBAL_STACK_MAX;
    return worst;
}

uint32_t plt_rebuilt_room(const plt_info *info) {
    const uint32_t most =
        plt_build_slots_bound(plt_build_nodes_bound(info->triangles), info->treelet_nodes);
    return most > info->node_slots ? most : info->node_slots;
}
#endif

plt_info plt_worst_tree(const plt_info *info) {
    plt_info worst = *info;
    if (info->build != PLT_BUILD_DEVICE) {
        return worst;
    }
    worst.nodes = plt_build_nodes_bound(info->triangles);
#if PLT_WITH_THESIS
    worst.node_slots = plt_build_slots_bound(worst.nodes, info->treelet_nodes);
#endif
    worst.leaf_lists = worst.nodes + 1; /* each of one triangle */
    worst.intermediate_lists = 0;
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
