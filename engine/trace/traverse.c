/* traverse - the one place that chooses how a format is traversed
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/traversal.h"
#include "engine/trace/traverse_formats.h"

void plt_traversal_init(plt_traversal *t, const plt_scene *scene, enum plt_order order,
                        const plt_traversal_memory *m) {
    const plt_traversal clear = {.scene = scene,
                                 .order = (uint8_t)order,
                                 .stack = m->stack,
                                 .local = m->local,
                                 .cache = m->cache,
                                 .touched = m->touched};
    *t = clear;
#if PLT_WITH_COMPACT
    if (scene->format == PLT_FORMAT_COMPACT) {
        plt_block_cache_clear(t->cache);
    }
#endif
}

uint32_t plt_touched_words(const plt_info *info) {
    if (plt_format_of(info) == PLT_FORMAT_COMPACT) { /* blocks lie at multiples of 8 */
        return (uint32_t)(((uint64_t)info->node_bytes + info->triangle_bytes) / 8 / 32 + 1);
    }
    return info->node_slots / info->treelet_nodes / 32 + 1;
}

size_t plt_entry_bytes(enum plt_format format) {
    switch (format) {
#if PLT_WITH_COMPACT
    case PLT_FORMAT_COMPACT:
        return plt_compact_entry_bytes();
#endif
#if PLT_WITH_THESIS
    case PLT_FORMAT_LIST:
        return plt_list_entry_bytes();
    case PLT_FORMAT_THESIS:
        return plt_thesis_entry_bytes();
#endif
    default:
        return 0;
    }
}

static void begin(plt_traversal *t, const plt_packet *p) {
    switch (t->scene->format) {
#if PLT_WITH_COMPACT
    case PLT_FORMAT_COMPACT:
        plt_compact_begin(t, p);
        break;
#endif
#if PLT_WITH_THESIS
    case PLT_FORMAT_LIST:
        plt_list_begin(t, p);
        break;
    case PLT_FORMAT_THESIS:
        plt_thesis_begin(t, p);
        break;
#endif
    default:
        break;
    }
}

void plt_traversal_begin(plt_traversal *t, const plt_packet *p, uint32_t rays) {
    begin(t, p);
    t->stats.rays += rays;
    t->stats.packets++;
    t->stats.mixed_packets += p->slabs.coherence == PLT_MIXED;
}

int plt_traverse(plt_traversal *t, plt_packet *p, uint32_t visits) {
    switch (t->scene->format) {
#if PLT_WITH_COMPACT
    case PLT_FORMAT_COMPACT:
        return plt_compact_traverse(t, p, visits);
#endif
#if PLT_WITH_THESIS
    case PLT_FORMAT_LIST:
        return plt_list_traverse(t, p, visits);
    case PLT_FORMAT_THESIS:
        return plt_thesis_traverse(t, p, visits);
#endif
    default:
        return PLT_OK;
    }
}
