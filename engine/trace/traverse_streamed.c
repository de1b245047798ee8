/* traverse_streamed - the orders that streamed compact blocks are traversed in
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/blocks_streamed.h"
#include "engine/trace/format_compact.h"
#include "engine/trace/order_depth_first.h"
#include "engine/trace/order_hulls.h"

#if PLT_WITH_PREFETCH
#define FORMAT_STACK(t, bytes) (t)->entry_bytes = (uint16_t)(bytes)
#define FORMAT_PAUSE(t) plt_prefetch_end(&((plt_stream *)(t)->state)->fetcher)
#endif

#define FORMAT_NAME streamed
#define FORMAT_ORDERS(ROW) ROW(DEPTH_FIRST, depth_first) FORMAT_ORDER_HULLS(ROW)
#include "engine/trace/traverse_format.h"

#if PLT_WITH_BATCH && PLT_WITH_STREAMED_COMPACT
int plt_streamed_at_hand(const plt_traversal *t, uint32_t treelet) {
    return plt_stream_has((const plt_stream *)t->state, treelet);
}
#endif
