/* format - the contract between formats of a tree and orders of traversal
 *
 * A format is a header, format_NAME.h, that gives the operations below as static
 * inline functions; an order is a header, order_NAME.h, written once against them.
 * traverse_NAME.c joins a format with the orders that are wanted for it
 * (traverse_format.h); traverse.c chooses the format. There is no function pointer and
 * no test of the format on the path of a ray.
 *
 * A format knows where things are; which rays go there, and every box test, is the
 * order's business. An order's stack entry is a format_place and what the order keeps
 * beside it.
 *
 *   format_state                    what is kept from visit to visit, in t->state, above
 *                                   all the current treelet
 *   void format_state_init(t)
 *   format_place                    a box of the tree and what it leads to
 *   format_children                 the children of a node
 *   format_room                     where a box may be written
 *
 *   int format_root(t, place)       the scene's root; 0: there is nothing to hit
 *   int format_is_leaf(place)       it leads to triangles
 *   int format_is_edge(place)       it leads to the root of another treelet; asked only
 *                                   of what is no leaf
 *   const plt_box *format_box(t, place, room)   its box, in scene units
 *   int format_enter(t, place)      the treelet behind an edge becomes the current one,
 *                                   the place its root; if it fails, the place is spoilt
 *   int format_return(t, place)     a place that has waited: its treelet becomes the
 *                                   current one again, if the place is read through it;
 *                                   of an edge as format_enter
 *   void format_decode(t, place, children)       of the node that it leads to, which is
 *                                   in the current treelet
 *   const plt_box *format_boxes(children)        their two boxes, in scene units
 *   void format_child(children, i, place)        the place of child i
 *   void format_bounds(t, place, lo, hi)         its box in lanes: x, y, z, and a number that
 *                                   means nothing; wanted by order_hulls.h alone, as are
 *   void format_child_bounds(children, i, lo, hi)         that of child i, and
 *   int format_cross(t, place)      enters an edge, if the place is one
 *   int format_leaf(t, p, place, groups)         tests its triangles for these groups
 *   uint32_t format_count(t, place)              of a format that can have a wide form: how
 *                                   many triangles the leaf has, whose treelet is current
 *   void format_triangle(t, place, index, triangle)   one of them, without `longest`
 *   FORMAT_LEAVES_WAIT              1: a leaf can be tested after others, as it is not read
 *                                   through the current treelet
 *   FORMAT_TIGHTENS                 1: format_enter may make the box smaller. An order may
 *                                   then enter an edge that has waited before it tests it
 *                                   (depth first does): fewer visits, but a fetch for
 *                                   nothing where the box is hidden by now
 *
 * Those that may have to fetch return PLT_OK or a negative status (enter, cross,
 * return, leaf). A format whose bytes are all at hand returns the constant PLT_OK, and the
 * compiler drops the test.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_FORMAT_H
#define PLT_TRACE_FORMAT_H

#include "engine/trace/traversal.h"

/* The child whose centre lies further back along the packet's direction comes first. */
static inline unsigned plt_nearer_child(const plt_packet *p, const plt_box child[2]) {
    float ahead = 0.0f;
    for (int a = 0; a < 3; a++) {
        const float left = child[0].lo[a] + child[0].hi[a];
        const float right = child[1].lo[a] + child[1].hi[a];
        ahead += p->forward[a] * (left - right);
    }
    return ahead > 0.0f;
}

#endif
