/* traverse_streamed_thesis - the orders that streamed thesis nodes are traversed in
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/format_streamed_thesis.h"
#include "engine/trace/order_depth_first.h"
#include "engine/trace/order_hulls.h"

#define FORMAT_FETCHES 1
#define FORMAT_NAME streamed_thesis
#define FORMAT_ORDERS(ROW) ROW(DEPTH_FIRST, depth_first) FORMAT_ORDER_HULLS(ROW)
#include "engine/trace/traverse_format.h"

#if PLT_WITH_BATCH && PLT_WITH_STREAMED_THESIS
int plt_streamed_thesis_at_hand(const plt_traversal *t, uint32_t treelet) {
    return plt_treelet_stream_has((const plt_treelet_stream *)t->state, plt_link_index(treelet));
}

#if PLT_WITH_PREFETCH
void plt_streamed_thesis_expect(plt_traversal *t, uint32_t treelet, uint32_t scope) {
    plt_treelet_stream_expect((format_state *)t->state, plt_link_index(treelet), scope);
}
#endif
#endif
