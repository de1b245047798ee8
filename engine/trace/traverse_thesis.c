/* traverse_thesis - the orders that format_thesis.h is traversed in
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/format_thesis.h"
#include "engine/trace/order_depth_first.h"
#include "engine/trace/order_two_stage.h"
#include "engine/trace/traverse_formats.h"

size_t plt_thesis_entry_bytes(void) {
    return sizeof(format_entry);
}

void plt_thesis_begin(plt_traversal *t, const plt_packet *p) {
    t->waiting = format_root(t, p, t->stack) && p->active != 0;
}

int plt_thesis_traverse(plt_traversal *t, plt_packet *p, uint32_t visits) {
    return t->order == PLT_ORDER_TWO_STAGE ? traverse_two_stage(t, p, visits)
                                           : traverse_depth_first(t, p, visits);
}
