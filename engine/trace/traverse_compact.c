/* traverse_compact - the orders that format_compact.h is traversed in
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/format_compact.h"
#include "engine/trace/order_depth_first.h"
#include "engine/trace/traverse_formats.h"

size_t plt_compact_entry_bytes(void) {
    return sizeof(format_entry);
}

void plt_compact_begin(plt_traversal *t, const plt_packet *p) {
    t->waiting = format_root(t, p, t->stack) && p->active != 0;
}

int plt_compact_traverse(plt_traversal *t, plt_packet *p, uint32_t visits) {
    return traverse_depth_first(t, p, visits);
}
