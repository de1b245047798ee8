/* polygon_order - see polygon_order.h
 *
 * Source: D. D. Sleator and R. E. Tarjan, "Self-Adjusting Binary Search Trees", 1985.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/polygon_order.h"

static int is_higher_child(const polygon_order *o, uint32_t x) {
    return o->edge[o->edge[x].parent].child[1] == x;
}

static void adopt(polygon_order *o, uint32_t parent, int which, uint32_t child) {
    o->edge[parent].child[which] = child;
    if (child != ORDER_NONE) {
        o->edge[child].parent = parent;
    }
}

/* Puts x in its parent's place, and that below it. */
static void rotate(polygon_order *o, uint32_t x) {
    const uint32_t parent = o->edge[x].parent, above = o->edge[parent].parent;
    const int which = is_higher_child(o, x);
    const int which_above = above != ORDER_NONE && is_higher_child(o, parent);
    adopt(o, parent, which, o->edge[x].child[!which]);
    adopt(o, x, !which, parent);
    o->edge[x].parent = above;
    if (above != ORDER_NONE) {
        o->edge[above].child[which_above] = x;
    }
}

static void splay(polygon_order *o, uint32_t x) {
    while (o->edge[x].parent != ORDER_NONE) {
        const uint32_t parent = o->edge[x].parent;
        if (o->edge[parent].parent != ORDER_NONE) {
            rotate(o, is_higher_child(o, x) == is_higher_child(o, parent) ? parent : x);
        }
        rotate(o, x);
    }
    o->root = x;
}

uint32_t polygon_order_find(polygon_order *o, order_side *side, const void *context, uint32_t point,
                            int *is_on) {
    uint32_t below = ORDER_NONE, last = ORDER_NONE;
    for (uint32_t x = o->root; x != ORDER_NONE;) {
        const int s = side(context, x, point);
        last = x;
        *is_on |= s == 0;
        below = s > 0 ? x : below;
        x = o->edge[x].child[s > 0];
        o->steps++;
    }
    if (last != ORDER_NONE) {
        splay(o, last); /* what pays for the next searches */
    }
    return below;
}

static uint32_t lowest(const polygon_order *o) {
    uint32_t x = o->root;
    while (x != ORDER_NONE && o->edge[x].child[0] != ORDER_NONE) {
        x = o->edge[x].child[0];
    }
    return x;
}

void polygon_order_insert(polygon_order *o, uint32_t below, uint32_t edge) {
    const uint32_t above = below != ORDER_NONE ? o->edge[below].above : lowest(o);
    o->edge[edge] = (order_edge){ORDER_NONE, {ORDER_NONE, ORDER_NONE}, below, above};
    if (above != ORDER_NONE) {
        o->edge[above].below = edge;
    }
    if (below != ORDER_NONE) {
        o->edge[below].above = edge;
        splay(o, below);
        adopt(o, edge, 1, o->edge[below].child[1]);
        adopt(o, below, 1, edge);
    } else if (above != ORDER_NONE) {
        splay(o, above);
        adopt(o, above, 0, edge);
    }
    splay(o, edge);
}

void polygon_order_replace(polygon_order *o, uint32_t old, uint32_t edge) {
    const order_edge place = o->edge[old];
    if (place.parent == ORDER_NONE) {
        o->root = edge;
    } else {
        o->edge[place.parent].child[is_higher_child(o, old)] = edge;
    }
    o->edge[edge] = place;
    adopt(o, edge, 0, place.child[0]);
    adopt(o, edge, 1, place.child[1]);
    if (place.below != ORDER_NONE) {
        o->edge[place.below].above = edge;
    }
    if (place.above != ORDER_NONE) {
        o->edge[place.above].below = edge;
    }
}

void polygon_order_remove(polygon_order *o, uint32_t edge) {
    splay(o, edge);
    const order_edge gone = o->edge[edge];
    for (int which = 0; which < 2; which++) {
        if (gone.child[which] != ORDER_NONE) {
            o->edge[gone.child[which]].parent = ORDER_NONE;
        }
    }
    o->root = gone.child[1];
    if (gone.below != ORDER_NONE) {
        splay(o, gone.below); /* the highest of what is lower */
        adopt(o, gone.below, 1, gone.child[1]);
        o->edge[gone.below].above = gone.above;
    }
    if (gone.above != ORDER_NONE) {
        o->edge[gone.above].below = gone.below;
    }
}
