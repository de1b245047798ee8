/* node_box - see node_box.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/node_box.h"

#if !PLT_LANES_REGISTERS
#define PLT_NODE_BOX __attribute__((noinline))
#include "engine/motion/node_box_code.h"
#endif
