/* beam_trace - the beam on its way through thesis nodes, near child first
 *
 * The thesis clips a ray's interval in the parent by the six planes of a node (section 3.5):
 * each is owned by one child, so no box is decoded, and none is stored. For a beam the
 * intervals are affordable: one per stack entry.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/beam.h"
#include "engine/trace/treelet_entry.h"

static void bound(plt_beam_entry *e, const plt_beam_plane *plane, float at) {
    const float t = (at - plane->org) * plane->factor;
    float *to = plane->leaves ? &e->minus_leave : &e->enter;
    *to = t > *to ? t : *to;
}

/* Where the beam is inside the scene's box. */
static plt_beam_entry root_entry(const plt_beam *b, const plt_box *box) {
    plt_beam_entry e = {0.0f, -PLT_VIEW_FAR, 0};
    for (int a = 0; a < 3; a++) {
        bound(&e, &b->plane[a], box->lo[a]);
        bound(&e, &b->plane[3 + a], box->hi[a]);
    }
    return e;
}

static int is_met(const plt_beam *b, const plt_beam_entry *e) {
    return e->enter <= -e->minus_leave && e->enter <= b->far;
}

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
    const int left = in[0][0] <= -in[0][1] && in[0][0] <= b->far;
    const int right = in[1][0] <= -in[1][1] && in[1][0] <= b->far;
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

/* No pixel is open any more: the greatest t. */
static void update_far(plt_beam *b) {
    b->is_stored = 0;
    b->far = 0.0f;
    for (uint32_t y = 0; y < b->rows; y++) {
        const plt_pixel *row = &b->pixel[y * b->square.side];
        for (uint32_t x = 0; x < b->columns; x++) {
            b->far = row[x].t > b->far ? row[x].t : b->far;
        }
    }
}

/* What is counted while stack entries are worked off. */
typedef struct counts {
    uint32_t nodes, triangles;
} counts;

/* From an entry down to a leaf, or to nothing. */
static inline void descend(plt_beam *b, plt_traversal *t, plt_beam_entry at, counts *c) {
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
    c->triangles += plt_beam_lists(b, plt_link_index(at.link), plt_link_lists(at.link), 0);
    if (b->is_stored && b->open == 0) {
        update_far(b);
    }
}

void plt_beam_push_root(plt_beam *b, plt_traversal *t) {
    plt_beam_entry *root = (plt_beam_entry *)t->stack;
    *root = root_entry(b, &t->scene->box);
    t->waiting = is_met(b, root);
    if (t->scene->format == PLT_FORMAT_LIST) {
        t->waiting = t->waiting && t->scene->list.count > 0;
        return;
    }
    root->link = t->scene->thesis.root;
    t->waiting = t->waiting && root->link != PLT_LINK_NONE;
    plt_treelet_state_init(t);
}

static void count(plt_stats *s, const counts *c) {
    s->node_visits += c->nodes;
    s->group_tests += 2 * (uint64_t)c->nodes;
    s->triangle_tests += c->triangles;
}

int plt_beam_trace(plt_beam *b, plt_traversal *t, uint32_t visits) {
    counts c = {0, 0};
    if (t->scene->format == PLT_FORMAT_LIST && t->waiting > 0) {
        c.triangles = plt_beam_lists(b, 0, t->scene->list.count, 1);
        t->waiting = 0;
    }
    for (uint32_t entries = 0; t->waiting > 0 && c.nodes + entries < visits; entries++) {
        const plt_beam_entry *top = (plt_beam_entry *)t->stack + --t->waiting;
        if (is_met(b, top)) {
            const plt_beam_entry at = {top->enter, top->minus_leave, top->link};
            descend(b, t, at, &c);
        }
    }
    count(&t->stats, &c);
    return t->waiting > 0 ? PLT_MORE : PLT_OK;
}
