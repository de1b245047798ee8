/* wide_form - see wide_form.h
 *
 * Bounds. Let m be the nodes of the tree, of two children each. A wide node that has four
 * children stands for three of them, one with fewer for at least one, and all its children
 * are leaves. F of the first kind have at most 4 F - (F - 1) = 3 F + 1 children of the second
 * kind, G; with 3 F + G <= m, F + G is at most (2 m + 1) / 3. Lists are cut where a place is
 * free, without more nodes; only a leaf of more than 64 triangles needs some of its own, at
 * most one for every 32 of its triangles. Its levels are as many as halves of it.
 *
 * A leaf of n triangles takes (n + 3) / 4 blocks.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/wide_form.h"

#include <string.h>

#include "engine/trace/collapse_formats.h"

static int has_long_lists(const plt_info *info) {
    return info->leaf_triangles > 2 * (PLT_BVH4_MORE_MOST + 1);
}

uint32_t plt_wide_nodes_bound(const plt_info *info) {
    const uint32_t cut = has_long_lists(info) ? info->triangles / 32 : 0;
    return (2 * info->nodes + 1) / 3 + cut + 1; /* node 0, if the root is a leaf */
}

uint32_t plt_wide_blocks_bound(const plt_info *info) {
    const uint64_t leaves = (uint64_t)info->leaf_lists + info->intermediate_lists;
    const uint64_t most = info->triangles > leaves ? info->triangles : leaves;
    return (uint32_t)((most + 3 * leaves) / 4); /* a single triangle is in two (SPEC, 4.11) */
}

uint32_t plt_wide_depth_bound(const plt_info *info) {
    return info->depth_stack_entries + (has_long_lists(info) ? 24u : 0u);
}

static size_t header_bytes(void) {
    return (sizeof(plt_bvh4) + PLT_BVH4_ALIGN - 1) / PLT_BVH4_ALIGN * PLT_BVH4_ALIGN;
}

uint64_t plt_wide_bytes(const plt_info *info) {
    return header_bytes() + PLT_BVH4_ALIGN +
           (uint64_t)plt_wide_nodes_bound(info) * sizeof(plt_bvh4_node) +
           (uint64_t)plt_wide_blocks_bound(info) * sizeof(plt_bvh4_block);
}

uint64_t plt_wide_scratch_bytes(const plt_info *info) {
    return (3ull * plt_wide_depth_bound(info) + 1) * PLT_COLLAPSE_ENTRY_BYTES;
}

int plt_wide_supports(enum plt_format format) {
    switch (format) {
#define SUPPORTS(NAME, name, with) PLT_IF(with, case PLT_FORMAT_##NAME : return 1;)
        PLT_WIDE_FORMATS(SUPPORTS)
#undef SUPPORTS
    default:
        return 0;
    }
}

static void collapse(plt_traversal *t, plt_wide_build *b) {
    switch (t->scene->format) {
#define COLLAPSE(NAME, name, with)                                                                 \
    PLT_IF(with, case PLT_FORMAT_##NAME : plt_##name##_collapse(t, b); break;)
        PLT_WIDE_FORMATS(COLLAPSE)
#undef COLLAPSE
    default:
        break;
    }
}

/* The next multiple of PLT_BVH4_ALIGN behind the header. */
static plt_bvh4_node *nodes_of(void *memory) {
    const uintptr_t at = (uintptr_t)memory + header_bytes();
    const uintptr_t up = (PLT_BVH4_ALIGN - at % PLT_BVH4_ALIGN) % PLT_BVH4_ALIGN;
    return (plt_bvh4_node *)(void *)((unsigned char *)memory + header_bytes() + up);
}

/* A link as collapse.h makes it, with an index in place of the offset. */
static uint32_t placed(uint32_t link, uint32_t nodes) {
    const uint32_t node = sizeof(plt_bvh4_node), block = sizeof(plt_bvh4_block);
    if (link == PLT_COLLAPSE_NONE) {
        return PLT_BVH4_NONE;
    }
    const uint32_t kind = link & PLT_BVH4_KIND, index = link / (PLT_BVH4_KIND + 1);
    return kind | ((kind & PLT_BVH4_LEAF) == 0 ? index * node : nodes * node + index * block);
}

const plt_bvh4 *plt_wide_make(plt_traversal *t, void *memory, void *scratch, size_t *used_bytes) {
    plt_bvh4 *w = memory;
    plt_bvh4_node *nodes = nodes_of(memory);
    plt_wide_build b = {.nodes = nodes, .scratch = scratch, .root = PLT_COLLAPSE_NONE};
    b.blocks = (plt_bvh4_block *)(void *)(nodes + plt_wide_nodes_bound(&t->scene->info));
    collapse(t, &b);
    if (b.nodes_count == 0) {
        memset(&nodes[b.nodes_count++], 0, sizeof *nodes);
    }
    plt_bvh4_block *blocks = (plt_bvh4_block *)(void *)(nodes + b.nodes_count);
    memmove(blocks, b.blocks, b.blocks_count * sizeof *blocks);
    for (uint32_t i = 0; i < 4 * b.nodes_count; i++) {
        uint32_t *link = &nodes[i / 4].link[i % 4];
        *link = placed(*link, b.nodes_count);
    }
    const plt_bvh4 made = {
        nodes, blocks, b.nodes_count, b.blocks_count, placed(b.root, b.nodes_count), b.depth};
    *w = made;
    *used_bytes = (size_t)((unsigned char *)(blocks + b.blocks_count) - (unsigned char *)memory);
    plt_state_init(t);
    plt_traversal_reset_stats(t);
    return w;
}
