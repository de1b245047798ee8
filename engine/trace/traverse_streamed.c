/* traverse_streamed - the orders that streamed compact blocks are traversed in
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/blocks_streamed.h"
#include "engine/trace/format_compact.h"
#include "engine/trace/order_depth_first.h"
#include "engine/trace/order_hulls.h"

#define FORMAT_FETCHES 1
#define FORMAT_NAME streamed
#define FORMAT_ORDERS(ROW) ROW(DEPTH_FIRST, depth_first) FORMAT_ORDER_HULLS(ROW)
#include "engine/trace/traverse_format.h"

#if PLT_WITH_BATCH && PLT_WITH_STREAMED_COMPACT
int plt_streamed_at_hand(const plt_traversal *t, uint32_t treelet) {
    return plt_stream_has((const plt_stream *)t->state, treelet);
}

#if PLT_WITH_PREFETCH
void plt_streamed_expect(plt_traversal *t, uint32_t treelet, uint32_t scope) {
    blocks_leave((format_state *)t->state); /* it may move */
    plt_stream_expect((format_state *)t->state, treelet, (float)scope);
}
#endif
#endif
