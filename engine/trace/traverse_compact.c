/* traverse_compact - the orders that format_compact.h is traversed in
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/blocks_resident.h"
#include "engine/trace/format_compact.h"
#include "engine/trace/order_depth_first.h"
#include "engine/trace/order_hulls.h"

#define FORMAT_NAME compact
#define FORMAT_ORDERS(ROW) ROW(DEPTH_FIRST, depth_first) FORMAT_ORDER_HULLS(ROW)
#include "engine/trace/traverse_format.h"
