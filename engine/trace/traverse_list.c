/* traverse_list - the orders that format_list.h is traversed in
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/format_list.h"
#include "engine/trace/order_depth_first.h"

#define FORMAT_NAME list
#define FORMAT_ORDER(order)                                                                        \
    ((void)(order), PLT_ORDER_DEPTH_FIRST) /* one leaf: all orders are the same */
#define FORMAT_ORDERS(ROW) ROW(DEPTH_FIRST, depth_first)
#include "engine/trace/traverse_format.h"
