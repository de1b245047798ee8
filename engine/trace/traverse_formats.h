/* traverse_formats - what each traverse_NAME.c gives to the switch in traverse.c
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_TRAVERSE_FORMATS_H
#define PLT_TRACE_TRAVERSE_FORMATS_H

#include "engine/trace/traversal.h"

/* plt_thesis_entry_bytes, plt_thesis_begin, plt_thesis_traverse ...: as the
 * functions of traversal.h whose names end so, of one format. */
#define PLT_TRAVERSE_DECLARED(NAME, name, with, text)                                              \
    size_t plt_##name##_entry_bytes(unsigned order);                                               \
    size_t plt_##name##_state_bytes(void);                                                         \
    void plt_##name##_state_init(plt_traversal *t);                                                \
    void plt_##name##_begin(plt_traversal *t, plt_packet *p);                                      \
    int plt_##name##_traverse(plt_traversal *t, plt_packet *p, uint32_t visits);
PLT_FORMATS(PLT_TRAVERSE_DECLARED)
#undef PLT_TRAVERSE_DECLARED

/* plt_treelet_at_hand, plt_treelet_expect, plt_edge_is_open and plt_traversal_pause, of the formats
 * that are streamed. */
#define PLT_STREAMED_DECLARED(name)                                                                \
    int plt_##name##_at_hand(const plt_traversal *t, uint32_t treelet);                            \
    void plt_##name##_expect(plt_traversal *t, uint32_t treelet, uint32_t scope);                  \
    int plt_##name##_is_open(const plt_traversal *t, const plt_packet *p);                         \
    void plt_##name##_pause(plt_traversal *t);
PLT_STREAMED_DECLARED(streamed)
PLT_STREAMED_DECLARED(streamed_thesis)
#undef PLT_STREAMED_DECLARED

#endif
