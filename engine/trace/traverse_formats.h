/* traverse_formats - what each traverse_NAME.c gives to the switch in traverse.c
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_TRAVERSE_FORMATS_H
#define PLT_TRACE_TRAVERSE_FORMATS_H

#include "engine/trace/traversal.h"

/* As plt_entry_bytes, plt_traversal_begin and plt_traverse, of one format. */
size_t plt_thesis_entry_bytes(void);
void plt_thesis_begin(plt_traversal *t, const plt_packet *p);
int plt_thesis_traverse(plt_traversal *t, plt_packet *p, uint32_t visits);

size_t plt_compact_entry_bytes(void);
void plt_compact_begin(plt_traversal *t, const plt_packet *p);
int plt_compact_traverse(plt_traversal *t, plt_packet *p, uint32_t visits);

size_t plt_list_entry_bytes(void);
void plt_list_begin(plt_traversal *t, const plt_packet *p);
int plt_list_traverse(plt_traversal *t, plt_packet *p, uint32_t visits);

#endif
