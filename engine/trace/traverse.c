/* traverse - the one place that chooses how a format is traversed, see traversal.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/hulls.h"
#include "engine/trace/traversal.h"
#include "engine/trace/traverse_formats.h"

size_t plt_entry_bytes(enum plt_format format, unsigned order) {
    switch (format) {
#define ENTRY_BYTES(NAME, name, with, text)                                                        \
    PLT_IF(with, case PLT_FORMAT_##NAME : return plt_##name##_entry_bytes(order);)
        PLT_FORMATS(ENTRY_BYTES)
#undef ENTRY_BYTES
    default:
        return 0;
    }
}

size_t plt_state_bytes(enum plt_format format) {
    switch (format) {
#define STATE_BYTES(NAME, name, with, text)                                                        \
    PLT_IF(with, case PLT_FORMAT_##NAME : return plt_##name##_state_bytes();)
        PLT_FORMATS(STATE_BYTES)
#undef STATE_BYTES
    default:
        return 0;
    }
}

void plt_state_init(plt_traversal *t) {
    switch (t->scene->format) {
#define STATE_INIT(NAME, name, with, text)                                                         \
    PLT_IF(with, case PLT_FORMAT_##NAME : plt_##name##_state_init(t); break;)
        PLT_FORMATS(STATE_INIT)
#undef STATE_INIT
    default:
        break;
    }
}

void plt_traversal_begin(plt_traversal *t, plt_packet *p, uint32_t rays) {
#if PLT_WITH_HULLS
    if (PLT_WITH_GRID && t->scene->format == PLT_FORMAT_GRID) {
        /* plt_grid_begin does what it needs */
    } else if (PLT_WITH_INSTANCES && t->scene->format == PLT_FORMAT_INSTANCES) {
        /* and so does plt_instances_begin */
    } else if (plt_order_for(t, p) == PLT_ORDER_HULLS && t->scene->format != PLT_FORMAT_LIST) {
        plt_hulls_set(p);
    } else {
        plt_packet_make_ready(p);
    }
#endif
    t->stats.rays += rays;
    t->stats.packets++;
    t->stats.mixed_packets += p->slabs.coherence == PLT_MIXED;
    switch (t->scene->format) {
#define BEGIN(NAME, name, with, text)                                                              \
    PLT_IF(with, case PLT_FORMAT_##NAME : plt_##name##_begin(t, p); break;)
        PLT_FORMATS(BEGIN)
#undef BEGIN
    default:
        break;
    }
}

#if PLT_WITH_BATCH
/* plt_streamed_CALL, or plt_streamed_thesis_CALL, as the scene's format is. */
#if PLT_WITH_STREAMED_COMPACT && PLT_WITH_STREAMED_THESIS
#define STREAMED(t, call)                                                                          \
    ((t)->scene->format == PLT_FORMAT_STREAMED_THESIS ? plt_streamed_thesis_##call                 \
                                                      : plt_streamed_##call)
#elif PLT_WITH_STREAMED_THESIS
#define STREAMED(t, call) plt_streamed_thesis_##call
#else
#define STREAMED(t, call) plt_streamed_##call
#endif

int plt_treelet_at_hand(const plt_traversal *t, uint32_t treelet) {
    return STREAMED(t, at_hand(t, treelet));
}

#if PLT_WITH_PREFETCH
void plt_treelet_expect(plt_traversal *t, uint32_t treelet, uint32_t scope) {
    STREAMED(t, expect(t, treelet, scope));
}

int plt_edge_is_open(const plt_traversal *t, const plt_packet *p) {
    return STREAMED(t, is_open(t, p));
}

void plt_traversal_pause(plt_traversal *t) {
    STREAMED(t, pause(t));
}
#endif
#undef STREAMED
#endif

int plt_traverse(plt_traversal *t, plt_packet *p, uint32_t visits) {
    switch (t->scene->format) {
#define TRAVERSE(NAME, name, with, text)                                                           \
    PLT_IF(with, case PLT_FORMAT_##NAME : return plt_##name##_traverse(t, p, visits);)
        PLT_FORMATS(TRAVERSE)
#undef TRAVERSE
    default:
        return PLT_OK;
    }
}
