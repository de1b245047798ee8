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

/* Plane `p` belongs to child `owner`. */
static inline void clip_by(intervals at, const plt_beam *b, const plt_node *node, int p,
                           uint32_t owner) {
    const plt_beam_plane *plane = &b->plane[p];
    const float t = (plt_get_float(&node->word[p]) - plane->org) * plane->factor;
    float *to = &at[owner][plane->leaves];
    if (t > *to) {
        *to = t;
    }
}

/* Where the beam is in its children: from the parent's interval, by the planes that each owns. */
static inline void clip(const plt_beam *b, const plt_node *node, const plt_beam_entry *parent,
                        intervals at) {
    const uint32_t left = plt_node_link(node, 0), right = plt_node_link(node, 1);
    at[0][0] = at[1][0] = parent->enter;
    at[0][1] = at[1][1] = parent->minus_leave;
    clip_by(at, b, node, 0, left >> 4 & 1u); /* plt_owner_bit, shifted down */
    clip_by(at, b, node, 1, left >> 3 & 1u);
    clip_by(at, b, node, 2, left >> 2 & 1u);
    clip_by(at, b, node, 3, right >> 4 & 1u);
    clip_by(at, b, node, 4, right >> 3 & 1u);
    clip_by(at, b, node, 5, right >> 2 & 1u);
}

static inline void set_entry(plt_beam_entry *e, const float at[2], const plt_node *node,
                             unsigned child) {
    e->enter = at[0];
    e->minus_leave = at[1];
    e->link = plt_node_link(node, (int)child);
}

/* Goes on to the nearer child that is met; the other one, if it is met, too, waits. 0: none
 * is. */
static inline int visit_node(const plt_beam *b, plt_traversal *t, plt_beam_entry *at) {
    const plt_node *node = &t->scene->thesis.nodes[plt_link_index(at->link)];
    intervals in;
    clip(b, node, at, in);
    const int left = plt_beam_meets(b, in[0][0], in[0][1]);
    const int right = plt_beam_meets(b, in[1][0], in[1][1]);
    unsigned near = !left;
    if (left && right) {
        near = in[1][0] - in[1][1] < in[0][0] - in[0][1];
        set_entry((plt_beam_entry *)t->stack + t->waiting++, in[near ^ 1], node, near ^ 1);
    } else if (!left && !right) {
        return 0;
    }
    set_entry(at, in[near], node, near);
    return 1;
}

/* From an entry down to a leaf, or to nothing. */
static inline void descend(plt_beam *b, plt_traversal *t, plt_beam_entry at, plt_beam_counts *c) {
    if (!plt_link_is_leaf(at.link)) {
        plt_treelet_enter(t, at.link);
    }
    while (!plt_link_is_leaf(at.link)) {
        c->nodes++;
        if (!visit_node(b, t, &at)) {
            return;
        }
        if ((at.link & PLT_LINK_KIND) == PLT_LINK_OUT) {
            plt_treelet_enter(t, at.link);
        }
    }
    c->triangles += BEAM_LEAF(b, t, plt_link_index(at.link), plt_link_lists(at.link));
    if (b->is_stored && b->open == 0) {
        plt_beam_update_far(b);
    }
}

plt_beam_counts BEAM_TRACE(plt_beam *b, plt_traversal *t, uint32_t visits) {
    plt_beam_counts c = {0, 0};
    for (uint32_t entries = 0; t->waiting > 0 && c.nodes + entries < visits; entries++) {
        const plt_beam_entry *top = (plt_beam_entry *)t->stack + --t->waiting;
        if (plt_beam_meets(b, top->enter, top->minus_leave)) {
            const plt_beam_entry at = {top->enter, top->minus_leave, top->link};
            descend(b, t, at, &c);
        }
    }
    return c;
}

#endif
