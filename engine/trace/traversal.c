/* traversal - see traversal.h; what depends on the format is in traverse.c
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/traversal.h"

#include <string.h>

/* Blocks of thesis nodes have an index; if they are streamed, slots have, and
 * pages of records; compact blocks lie at multiples of 8. */
uint32_t plt_touched_words(enum plt_format format, const plt_info *info) {
    if (PLT_WITH_GRID && format == PLT_FORMAT_GRID) {
        return 0; /* nodes are not looked at */
    }
    if (PLT_WITH_INSTANCES && format == PLT_FORMAT_INSTANCES) { /* bodies begin with a word each */
        return info->node_slots / info->treelet_nodes / 32 + info->bodies + 1;
    }
    if (plt_has_blocks(format)) {
        return (uint32_t)(((uint64_t)info->node_bytes + info->triangle_bytes) / 8 / 32 + 1);
    }
    if (plt_is_streamed(format)) {
        return (info->node_slots + info->triangles / PLT_PAGE_RECORDS) / 32 + 1;
    }
    return info->node_slots / info->treelet_nodes / 32 + 1;
}

void plt_traversal_init(plt_traversal *t, const plt_scene *scene, const plt_options *options,
                        void *const part[PLT_PARTS_COUNT]) {
    memset(t, 0, sizeof *t);
    t->scene = scene;
    t->order = options->order;
    t->stack = part[PLT_PART_STACK];
    t->local = part[PLT_PART_LOCAL_STACK];
#if PLT_WITH_PAGES
    if (options->order == PLT_ORDER_DEPTH_FIRST) {
        t->kept = part[PLT_PART_KEPT];
    }
#endif
#if PLT_WITH_HULLS
    t->leaves = part[PLT_PART_LEAVES];
#endif
    t->state = part[PLT_PART_FORMAT];
#if PLT_WITH_STREAMED
    t->store = part[PLT_PART_STORE];
    t->store_bytes = options->store_bytes;
    t->prefetch = options->prefetch;
#endif
    if (options->count_touched) {
        t->touched = part[PLT_PART_TOUCHED];
        t->touched_words = plt_touched_all_words((enum plt_format)scene->format, &scene->info);
    }
#if PLT_WITH_GROUPS
    plt_state_init(t);
#endif
    plt_traversal_reset_stats(t);
}

void plt_traversal_reset_stats(plt_traversal *t) {
    memset(&t->stats, 0, sizeof t->stats);
    if (t->touched != NULL) {
        memset(t->touched, 0, 4 * (size_t)t->touched_words);
    }
}
