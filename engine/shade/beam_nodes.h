/* beam_nodes - the beam on its way through thesis nodes, near child first
 *
 * The thesis clips a ray's interval in the parent by the six planes of a node (section 3.5):
 * each is owned by one child, so no box is decoded, and none is stored. For a beam the
 * intervals are affordable: one per stack entry.
 *
 * Included once by each beam_NAME.c, with BEAM_TRACE, the name of what it gives, and
 * BEAM_LEAF(b, t, first, lists), which tests the triangles of a leaf and returns how many there
 * were.
 *
 * SPDX-License-Identifier: MIT */
#ifdef BEAM_TRACE /* else there is nothing to make */

#include "engine/shade/beam.h"
#include "engine/trace/treelet_entry.h"

/* Of each child the entry and minus the exit. */
typedef float intervals[2][2];

/* Where planes are met, and which end of the left child's interval each may move; a whole square's,
 * so that they are in registers. */
typedef struct clipper {
    float org[6], factor[6];
    float *end[6];
} clipper;

static inline void set_clipper(clipper *c, const plt_beam *b, intervals at) {
    PLT_UNROLLED for (int p = 0; p < 6; p++) {
        c->org[p] = b->plane[p].org;
        c->factor[p] = b->plane[p].factor;
        c->end[p] = &at[0][b->plane[p].leaves];
    }
}

/* Plane `p` belongs to child `owner`. */
static inline void clip_by(const clipper *c, const plt_node *node, int p, uint32_t owner) {
    const float t = (plt_get_float(&node->word[p]) - c->org[p]) * c->factor[p];
    float *to = c->end[p] + 2 * owner;
    if (t > *to) {
        *to = t;
    }
}

/* Where the beam is in its children: from the parent's interval, by the planes that each owns. */
static inline void clip(const clipper *c, const plt_node *node, const plt_beam_entry *parent,
                        intervals at) {
    const uint32_t left = plt_node_link(node, 0), right = plt_node_link(node, 1);
    at[0][0] = at[1][0] = parent->enter;
    at[0][1] = at[1][1] = parent->minus_leave;
    clip_by(c, node, 0, left >> 4 & 1u); /* plt_owner_bit, shifted down */
    clip_by(c, node, 1, left >> 3 & 1u);
    clip_by(c, node, 2, left >> 2 & 1u);
    clip_by(c, node, 3, right >> 4 & 1u);
    clip_by(c, node, 4, right >> 3 & 1u);
    clip_by(c, node, 5, right >> 2 & 1u);
}

static inline void set_entry(plt_beam_entry *e, const float at[2], const plt_node *node,
                             unsigned child) {
    e->enter = at[0];
    e->minus_leave = at[1];
    e->link = plt_node_link(node, (int)child);
}

/* Goes on to the nearer child that is met; the other one, if it is met, too, waits. 0: none
 * is. */
static inline int visit_node(const plt_beam *b, const clipper *c, const plt_node *node,
                             intervals in, plt_beam_entry *at, plt_beam_entry **top) {
    clip(c, node, at, in);
    const int left = plt_beam_meets(b, in[0][0], in[0][1]);
    const int right = plt_beam_meets(b, in[1][0], in[1][1]);
    unsigned near = !left;
    if (left && right) {
        near = in[1][0] - in[1][1] < in[0][0] - in[0][1];
        set_entry((*top)++, in[near ^ 1], node, near ^ 1);
    } else if (!left && !right) {
        return 0;
    }
    set_entry(at, in[near], node, near);
    return 1;
}

plt_beam_counts BEAM_TRACE(plt_beam *b, plt_traversal *t, uint32_t visits) {
    const plt_node *nodes = t->scene->thesis.nodes;
    plt_beam_entry *bottom = (plt_beam_entry *)t->stack, *top = bottom + t->waiting;
    plt_beam_counts n = {0, 0};
    intervals in;
    clipper c;
    set_clipper(&c, b, in);
    for (uint32_t entries = 0; top > bottom && n.nodes + entries < visits; entries++) {
        plt_beam_entry at = *--top;
        if (!(at.enter <= b->far)) {
            continue;
        }
        int met = 1;
        if (!plt_link_is_leaf(at.link)) {
            plt_treelet_enter(t, at.link);
        }
        while (met && !plt_link_is_leaf(at.link)) {
            n.nodes++;
            met = visit_node(b, &c, &nodes[plt_link_index(at.link)], in, &at, &top);
            if (met && (at.link & PLT_LINK_KIND) == PLT_LINK_OUT) {
                plt_treelet_enter(t, at.link);
            }
        }
        if (met) {
            n.triangles += BEAM_LEAF(b, t, plt_link_index(at.link), plt_link_lists(at.link));
            if (b->is_stored && b->open == 0 && top > bottom) {
                plt_beam_update_far(b);
            }
        }
    }
    t->waiting = (uint32_t)(top - bottom);
    return n;
}

#endif
