/* polygon_order - the edges that a vertical line crosses, from the lowest up
 *
 * A splay tree to search, and a list for neighbours. Edges are numbers that the
 * caller knows the places of; only `polygon_order_find` compares.
 *
 * SPDX-License-Identifier: MIT */
#ifndef POLYGON_ORDER_H
#define POLYGON_ORDER_H
#include <stdint.h>

#define ORDER_NONE UINT32_MAX

typedef struct order_edge {
    uint32_t parent, child[2]; /* in the tree: lower, higher */
    uint32_t below, above;     /* in the list */
} order_edge;

typedef struct polygon_order {
    order_edge *edge; /* the caller's, one for every edge there can be */
    uint32_t root;
    uint64_t steps; /* down the tree so far */
} polygon_order;

/* 1: the point is above the edge, -1: below, 0: on it. */
typedef int order_side(const void *context, uint32_t edge, uint32_t point);

/* The highest edge below the point, or ORDER_NONE; *is_on is set when it is on an edge. */
uint32_t polygon_order_find(polygon_order *o, order_side *side, const void *context, uint32_t point,
                            int *is_on);
/* Puts `edge` right above `below`; ORDER_NONE: below all. */
void polygon_order_insert(polygon_order *o, uint32_t below, uint32_t edge);
/* Puts `edge` where `old` was. */
void polygon_order_replace(polygon_order *o, uint32_t old, uint32_t edge);
void polygon_order_remove(polygon_order *o, uint32_t edge);

#endif
