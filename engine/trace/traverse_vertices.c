/* traverse_vertices - the orders that format_vertices.h is traversed in
 *
 * SPDX-License-Identifier: MIT */
#include "engine/planelet_config.h"

#if PLT_WITH_VERTICES

#include "engine/trace/format_vertices.h"
#include "engine/trace/order_depth_first.h"
#include "engine/trace/order_hulls.h"
#include "engine/trace/order_two_stage.h"

#define FORMAT_NAME vertices
#define FORMAT_ORDERS(ROW)                                                                         \
    ROW(DEPTH_FIRST, depth_first) FORMAT_ORDER_HULLS(ROW) ROW(TWO_STAGE, two_stage)
#include "engine/trace/traverse_format.h"

#endif
