/* polygon_tree - finds the marked points near a triangle
 *
 * A binary tree of boxes over points in Morton order. Points do not move; marks
 * come and go, and subtrees without a mark are passed by.
 *
 * SPDX-License-Identifier: MIT */
#ifndef POLYGON_TREE_H
#define POLYGON_TREE_H
#include <stddef.h>
#include <stdint.h>

#define POLYGON_NONE UINT32_MAX

typedef struct tree_box {
    double lo[2], hi[2];
} tree_box;

typedef struct tree_key {
    uint64_t key;
    uint32_t point;
} tree_key;

/* Zero-initialised; grows; freed by polygon_tree_free. */
typedef struct polygon_tree {
    const double (*point)[2];
    tree_key *key;    /* in Morton order; behind them as many again, to sort */
    uint32_t *place;  /* of each point in that order */
    tree_box *box;    /* nodes 1 to 2 leaves - 1; node i is above 2i and 2i + 1 */
    uint32_t *marked; /* inner node: how many below; leaf: a bit for each of its points */
    uint32_t leaves;  /* a power of 2 */
    size_t room;      /* in points */
} polygon_tree;

/* A search for the points that may lie in a triangle that turns left. */
typedef struct tree_search {
    const polygon_tree *t;
    double corner[3][2];
    tree_box box;
    double slack; /* how far outside a point may be */
    uint32_t waiting[40];
    int waits;
    uint32_t leaf, bits; /* being looked at, and what is left of it */
    uint64_t visits;     /* nodes and points so far */
} tree_search;

/* Builds the tree over `n` points, none marked; they stay the caller's. -1: no memory. */
int polygon_tree_build(polygon_tree *t, const double (*point)[2], uint32_t n);
void polygon_tree_mark(polygon_tree *t, uint32_t point, int on);
int polygon_tree_is_marked(const polygon_tree *t, uint32_t point);
void polygon_tree_free(polygon_tree *t);

tree_search polygon_tree_search(const polygon_tree *t, const double a[2], const double b[2],
                                const double c[2], double slack);
/* The next marked point that may be inside, or POLYGON_NONE. Marks stay while it searches. */
uint32_t polygon_tree_next(tree_search *s);

#endif
