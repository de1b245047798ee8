/* collapse - a tree of two children per node made a wide one (tree/bvh4.h)
 *
 * A node opens the child of largest area until it has four, or all are leaves. Lists of
 * triangles become blocks of four; of lists whose triangles do not fit into one block, those
 * that a place is free for are cut in two. Boxes of leaves are those of their triangles,
 * exactly; boxes of nodes are the tree's.
 *
 * Subtrees that are still to be made wait on a stack of 3 * depth + 1 entries at most.
 *
 * Include a format (format.h) before this file.
 *
 * Source: Dammertz, Hanika, Keller, "Shallow bounding volume hierarchies", 2008.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_COLLAPSE_H
#define PLT_TRACE_COLLAPSE_H

#include <string.h>

#include "engine/base/box.h"
#include "engine/trace/collapse_formats.h"

/* What is to be a child: a subtree, or triangles in a row of one leaf. */
typedef struct piece {
    format_place place;
    plt_box box;           /* of a subtree */
    uint32_t first, count; /* triangles; count 0: a subtree */
} piece;

/* A piece that waits, and the link that will lead to it. */
typedef struct waiting_piece {
    piece what;
    uint32_t node, child; /* PLT_MISS: the root */
    uint32_t depth;       /* of the node that it will be; the root's is 1 */
} waiting_piece;

_Static_assert(sizeof(waiting_piece) <= PLT_COLLAPSE_ENTRY_BYTES, "the scratch is for so many");

static void set_piece(plt_traversal *t, piece *p, const plt_box *box) {
    p->box = *box;
    p->first = 0;
    p->count = format_is_leaf(&p->place) ? format_count(t, &p->place) : 0;
}

/* ---- leaves --------------------------------------------------------------------- */

static void set_lane(plt_bvh4_block *b, unsigned lane, const plt_triangle *from, float longest) {
    for (int c = 0; c < 3; c++) {
        for (int a = 0; a < 3; a++) {
            b->corner[c][a][lane] = from->corner[c][a];
        }
    }
    b->longest[lane] = longest;
    b->word[lane] = plt_primitive_word_find(from->ids, from->word) & ~PLT_RECORD_LAST;
}

/* Up to four triangles; adds them to `box`. */
static void set_block(plt_traversal *t, const piece *p, uint32_t first, uint32_t count,
                      plt_bvh4_block *to, plt_box *box) {
    plt_triangle triangle;
    for (unsigned lane = 4; lane-- > 0;) {
        format_triangle(t, &p->place, first + (lane < count ? lane : 0), &triangle);
        plt_box own = plt_box_empty();
        for (int c = 0; c < 3; c++) {
            plt_box_add_point(&own, triangle.corner[c]);
        }
        plt_box_add(box, &own);
        set_lane(to, lane, &triangle,
                 lane < count ? plt_box_longest_side(&own) : -__builtin_inff());
    }
}

/* The piece's blocks, its box and the link to them. */
static uint32_t make_leaf(plt_traversal *t, plt_wide_build *b, const piece *p, plt_box *box) {
    const uint32_t first = b->blocks_count, more = (p->count - 1) / 4;
    *box = plt_box_empty();
    for (uint32_t i = 0; i < p->count; i += 4) {
        const uint32_t left = p->count - i;
        set_block(t, p, p->first + i, left < 4 ? left : 4, &b->blocks[b->blocks_count++], box);
    }
    return PLT_BVH4_LEAF | more << PLT_BVH4_MORE_SHIFT | first * (PLT_BVH4_KIND + 1);
}

/* ---- nodes ---------------------------------------------------------------------- */

/* A leaf of more triangles than a link can lead to is cut like a node. */
static int is_leaf(const piece *p) {
    return p->count > 0 && p->count <= 4 * (PLT_BVH4_MORE_MOST + 1);
}

/* In two, the first one of whole blocks. */
static void cut(const piece *p, piece to[2]) {
    const uint32_t half = ((p->count + 1) / 2 + 3) / 4 * 4;
    to[0] = to[1] = *p;
    to[0].count = half;
    to[1].first += half;
    to[1].count -= half;
}

/* A piece's two parts. What fails is a source, and the scene is at hand here. */
static void open_piece(plt_traversal *t, piece *p, piece to[2]) {
    if (p->count > 0) {
        cut(p, to);
        return;
    }
    format_children c;
    if (format_is_edge(&p->place)) {
        format_enter(t, &p->place);
    } else {
        format_return(t, &p->place);
    }
    format_decode(t, &p->place, &c);
    for (unsigned i = 0; i < 2; i++) {
        format_child(&c, i, &to[i].place);
    }
    const plt_box *box = format_boxes(&c);
    for (unsigned i = 0; i < 2; i++) {
        set_piece(t, &to[i], &box[i]);
    }
}

/* 2: a node. 1: triangles of more than a block. 0: it stays as it is. */
static unsigned can_open(const piece *p) {
    return p->count == 0 ? 2u : p->count > 4;
}

/* Whether a place is better spent on opening `a`: nodes first, by area. */
static int is_better(const piece *a, const piece *b) {
    if (can_open(a) != can_open(b)) {
        return can_open(a) > can_open(b);
    }
    return a->count == 0 ? plt_box_half_area(&a->box) > plt_box_half_area(&b->box)
                         : a->count > b->count;
}

static unsigned open_all(plt_traversal *t, piece *p, piece to[4]) {
    unsigned count = 2;
    open_piece(t, p, to);
    while (count < 4) {
        unsigned best = 0;
        for (unsigned i = 1; i < count; i++) {
            best = is_better(&to[i], &to[best]) ? i : best;
        }
        if (can_open(&to[best]) == 0) {
            break;
        }
        piece opened[2], at = to[best];
        open_piece(t, &at, opened);
        to[best] = opened[0];
        to[count++] = opened[1];
    }
    return count;
}

static void set_child(plt_bvh4_node *n, unsigned child, const plt_box *box, uint32_t link) {
    for (int a = 0; a < 3; a++) {
        n->plane[a][0][child] = box->lo[a];
        n->plane[a][1][child] = box->hi[a];
    }
    n->link[child] = link;
}

static void link_to(plt_wide_build *b, const waiting_piece *w, uint32_t link) {
    if (w->node == PLT_MISS) {
        b->root = link;
    } else {
        b->nodes[w->node].link[w->child] = link;
    }
}

/* Makes a node of a piece; those of its children that are no leaves wait. */
static uint32_t make_node(plt_traversal *t, plt_wide_build *b, waiting_piece *w,
                          waiting_piece *stack) {
    piece child[4];
    uint32_t waiting = 0;
    const uint32_t node = b->nodes_count++;
    plt_bvh4_node *n = &b->nodes[node];
    const plt_box none = plt_box_empty();
    const unsigned count = open_all(t, &w->what, child);
    memset(n, 0, sizeof *n);
    b->depth = w->depth > b->depth ? w->depth : b->depth;
    for (unsigned i = 0; i < 4; i++) {
        if (i >= count) {
            set_child(n, i, &none, PLT_COLLAPSE_NONE);
        } else if (is_leaf(&child[i])) {
            plt_box box;
            format_return(t, &child[i].place);
            const uint32_t link = make_leaf(t, b, &child[i], &box);
            set_child(n, i, &box, link);
        } else {
            set_child(n, i, &child[i].box, PLT_COLLAPSE_NONE);
            const waiting_piece next = {child[i], node, i, w->depth + 1};
            stack[waiting++] = next;
        }
    }
    link_to(b, w, node * (PLT_BVH4_KIND + 1));
    return waiting;
}

static void collapse(plt_traversal *t, plt_wide_build *b) {
    waiting_piece *stack = (waiting_piece *)b->scratch;
    uint32_t waiting = 0;
    waiting_piece *root = &stack[0];
    root->node = PLT_MISS;
    root->depth = 1;
    if (format_root(t, &root->what.place)) {
        set_piece(t, &root->what, &t->scene->box);
        waiting = 1;
    }
    while (waiting > 0) {
        waiting_piece at = stack[--waiting];
        plt_box box;
        if (is_leaf(&at.what)) { /* the root alone: others are made with their node */
            link_to(b, &at, make_leaf(t, b, &at.what, &box));
        } else {
            waiting += make_node(t, b, &at, stack + waiting);
        }
    }
}

#endif
