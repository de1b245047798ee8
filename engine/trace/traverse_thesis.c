/* traverse_thesis - the orders that format_thesis.h is traversed in
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/format_thesis.h"
#include "engine/trace/order_depth_first.h"
#include "engine/trace/order_hulls.h"
#include "engine/trace/order_two_stage.h"

#define FORMAT_NAME thesis
#define FORMAT_ORDERS(ROW)                                                                         \
    ROW(DEPTH_FIRST, depth_first) FORMAT_ORDER_HULLS(ROW) ROW(TWO_STAGE, two_stage)
#include "engine/trace/traverse_format.h"
