/* child_order - four children sorted by a table instead of branches
 *
 * Of equal numbers any may come first: of the six comparisons one goes round the circle, and
 * the table has the answer for every tie.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_CHILD_ORDER_H
#define PLT_TRACE_CHILD_ORDER_H

#include "engine/lanes/lanes.h"

/* Both tables lie side by side, so that one register leads to them. */
typedef struct plt_child_order {
    /* By comparisons of four distances, where each lands in descending order. Bits 0 .. 3: lane
     * i is less than lane i + 1 (of 3: lane 0); 4 and 5: lane 0 than 2, 1 than 3. Rows that no
     * four numbers lead to have any order. */
    uint8_t descending[64][4];
    int8_t ones_less_one[16]; /* bits that are set, less one */
} plt_child_order;

static const plt_child_order plt_child_orders = {
    {{0, 1, 2, 3}, {1, 0, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 3, 2}, {2, 0, 3, 1},
     {0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3}, {1, 0, 2, 3}, {0, 2, 1, 3}, {0, 1, 2, 3},
     {0, 1, 3, 2}, {1, 0, 3, 2}, {0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3}, {3, 0, 1, 2},
     {1, 2, 0, 3}, {3, 1, 0, 2}, {0, 1, 2, 3}, {3, 0, 2, 1}, {0, 1, 2, 3}, {0, 1, 2, 3},
     {0, 1, 2, 3}, {2, 0, 1, 3}, {1, 2, 0, 3}, {2, 1, 0, 3}, {0, 1, 2, 3}, {0, 1, 2, 3},
     {0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3}, {0, 3, 1, 2}, {0, 1, 2, 3},
     {1, 2, 3, 0}, {2, 1, 3, 0}, {1, 3, 2, 0}, {0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3},
     {0, 3, 1, 2}, {0, 1, 2, 3}, {0, 2, 3, 1}, {0, 1, 2, 3}, {0, 3, 2, 1}, {0, 1, 2, 3},
     {0, 1, 2, 3}, {0, 1, 2, 3}, {2, 3, 0, 1}, {3, 2, 0, 1}, {0, 1, 2, 3}, {3, 1, 2, 0},
     {2, 3, 1, 0}, {3, 2, 1, 0}, {0, 1, 2, 3}, {0, 1, 2, 3}, {1, 3, 0, 2}, {0, 1, 2, 3},
     {0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3}},
    {-1, 0, 0, 1, 0, 1, 1, 2, 0, 1, 1, 2, 1, 2, 2, 3}};

/* By which children are met, a bit each: how many, and where the second, third and fourth land in
 * the order they have. Those that are not met land above the others. The first one, or what is
 * there if it is not met, is always at 0. */
static const uint8_t plt_child_places[16][4] = {
    {0, 1, 1, 1}, {1, 1, 1, 1}, {1, 0, 1, 1}, {2, 1, 2, 2}, {1, 1, 0, 1}, {2, 1, 1, 2},
    {2, 0, 1, 2}, {3, 1, 2, 3}, {1, 1, 1, 0}, {2, 1, 1, 1}, {2, 0, 1, 1}, {3, 1, 2, 2},
    {2, 1, 0, 1}, {3, 1, 1, 2}, {3, 0, 1, 2}, {4, 1, 2, 3}};

/* The row of the table for these numbers. */
static inline unsigned plt_descending(f4 key) {
    const f4 next = f4_rotate(key), across = f4_rotate(next);
    const unsigned low = m4_mask(f4_lt(key, next)), high = m4_mask(f4_lt(key, across)) & 3u;
    return low | high << 4;
}

#endif
