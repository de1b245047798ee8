/* collapse - a tree of two children per node made a wide one (tree/bvh4.h)
 *
 * A node opens the child of largest area until it has four, or all are leaves. Lists of
 * triangles become blocks of four; of lists whose triangles do not fit into one block, those
 * that a place is free for are cut in two. Boxes of leaves are those of their triangles,
 * exactly; boxes of nodes are the tree's.
 *
 * Subtrees that are still to be made wait on a stack of 3 * depth + 1 entries at most: a node on
 * level d (the root's is 1) has at most 3 (d - 1) below it, and its parts, at most four, lie where
 * it waited.
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
#include "engine/base/small_stack.h"
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

/* In two, the first one, of whole blocks, where it was. */
static void cut(piece *p, piece *second) {
    const uint32_t half = ((p->count + 1) / 2 + 3) / 4 * 4;
    *second = *p;
    second->first += half;
    second->count -= half;
    p->count = half;
}

/* A piece becomes its first part. What fails is a source, and the scene is at hand here. */
static void open_piece(plt_traversal *t, piece *p, piece *second) {
    if (p->count > 0) {
        cut(p, second);
        return;
    }
    format_place place = p->place;
    format_children c;
    if (format_is_edge(&place)) {
        format_enter(t, &place);
    } else {
        format_return(t, &place);
    }
    format_decode(t, &place, &c);
    format_child(&c, 0, &p->place);
    format_child(&c, 1, &second->place);
    const plt_box *box = format_boxes(&c);
    set_piece(t, p, &box[0]);
    set_piece(t, second, &box[1]);
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

/* The parts of the piece in to[0], at most four. Apart, so that it is not on the stack below what
 * makes leaves of them. */
PLT_APART_ON_SMALL_STACKS static unsigned open_all(plt_traversal *t, waiting_piece *to) {
    unsigned count = 2;
    open_piece(t, &to[0].what, &to[1].what);
    while (count < 4) {
        unsigned best = 0;
        for (unsigned i = 1; i < count; i++) {
            best = is_better(&to[i].what, &to[best].what) ? i : best;
        }
        if (can_open(&to[best].what) == 0) {
            break;
        }
        open_piece(t, &to[best].what, &to[count].what);
        count++;
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

/* Makes a node of the piece in stack[0]; those of its children that are no leaves wait, from there
 * on. */
static uint32_t make_node(plt_traversal *t, plt_wide_build *b, waiting_piece *stack) {
    uint32_t waiting = 0;
    const uint32_t node = b->nodes_count++, depth = stack->depth;
    plt_bvh4_node *n = &b->nodes[node];
    link_to(b, stack, node * (PLT_BVH4_KIND + 1));
    const unsigned count = open_all(t, stack);
    memset(n, 0, sizeof *n);
    b->depth = depth > b->depth ? depth : b->depth;
    for (unsigned i = 0; i < 4; i++) {
        piece *child = &stack[i].what;
        plt_box box = plt_box_empty();
        uint32_t link = PLT_COLLAPSE_NONE;
        if (i < count && is_leaf(child)) {
            format_return(t, &child->place);
            link = make_leaf(t, b, child, &box);
        } else if (i < count) {
            box = child->box;
            stack[waiting].what = *child;
            stack[waiting].node = node;
            stack[waiting].child = i;
            stack[waiting].depth = depth + 1;
            waiting++;
        }
        set_child(n, i, &box, link);
    }
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
        waiting_piece *at = &stack[--waiting];
        plt_box box;
        if (is_leaf(&at->what)) { /* the root alone: others are made with their node */
            link_to(b, at, make_leaf(t, b, &at->what, &box));
        } else {
            waiting += make_node(t, b, at);
        }
    }
}

#endif
