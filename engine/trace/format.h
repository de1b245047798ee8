/* format - the contract between formats of a tree and orders of traversal
 *
 * A format is a header, format_NAME.h, that gives the operations below as static
 * inline functions; an order is a header, order_NAME.h, written against them. One
 * file per format, traverse_NAME.c, includes the format and the orders that it is
 * wanted in, and traverse.c chooses. There is no function pointer and no test of the
 * format on the path of a ray.
 *
 *   format_entry                       what waits on a stack: a box, what it leads to,
 *                                      and `groups`, the groups that are concerned
 *   format_children                    both children of a node
 *
 *   int format_root(t, p, e)           the scene's root; 0: there is nothing to hit
 *   int format_is_leaf(e)              it leads to triangles
 *   int format_is_edge(e)              it leads to a node of another treelet; asked only of
 *                                      what is no leaf
 *   int format_resume(t, p, e)         e comes back from a stack: groups that no longer
 *                                      meet its box are dropped, since hits were found
 *                                      meanwhile; if any are left, its treelet is the
 *                                      one in hand
 *   int format_enter(t, p, e)          e is an edge that was just met: the treelet behind
 *                                      it becomes the one in hand, e its root
 *   void format_decode(t, e, c)        the children of the node that e leads to
 *   const plt_box *format_boxes(c)     their two boxes, in scene units
 *   void format_child(c, i, g, e)      e becomes child i, for groups g
 *   int format_leaf(t, p, e)           tests its triangles
 *
 * Those that may have to fetch return PLT_OK or a negative status (resume, enter,
 * leaf); a format whose bytes are all at hand returns the constant PLT_OK, and the
 * compiler drops the test. A new format or order is one header, and one line in its
 * traverse_NAME.c or in traverse.c.
 *
 * Two-stage order needs `float distance` in format_entry, for the order of edges, and
 *
 *   plt_box *format_box(e)             its box, in scene units
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
