/* beam_blocks - the beam on its way through compact blocks, near child first
 *
 * Included once for resident and once for streamed blocks, behind trace/blocks_resident.h or
 * trace/blocks_streamed.h, which say how a block is reached, with
 *   BEAM_BLOCKS              in the names of the functions that it gives (beam.h)
 *   BEAM_STACK(t, bytes)     optional, as FORMAT_STACK and
 *   BEAM_PAUSE(t)            FORMAT_PAUSE of trace/traverse_format.h
 *
 * As in beam_thesis.c a child's interval is its parent's, clipped by the planes it owns. Planes
 * are relative to the parent's box, so an entry has that, too, in lattice coordinates; a plane
 * becomes a float of the scene as it is tested, as in trace/format_compact.h.
 *
 * The current block of a streamed scene stays where it is until a part is fetched. So nothing is
 * kept of a block from one entry of the stack to the next.
 *
 * SPDX-License-Identifier: MIT */
#ifdef BEAM_BLOCKS /* else there is nothing to make */

#include "engine/lanes/unroll.h"
#include "engine/shade/beam.h"

#ifndef BEAM_STACK
#define BEAM_STACK(t, bytes)
#define BEAM_PAUSE(t)
#endif

#define BEAM_JOINED_AGAIN(name, what) plt_beam_##name##_##what
#define BEAM_JOINED(name, what) BEAM_JOINED_AGAIN(name, what)

/* Where the subtree of the entry's block ends. */
static inline float end_of(const plt_beam_block_entry *e) {
#ifdef PLT_BLOCKS_RESIDENT
    (void)e;
    return 0.0f;
#else
    return e->end;
#endif
}

static inline void set_end(plt_beam_block_entry *e, float end) {
#ifdef PLT_BLOCKS_RESIDENT
    (void)e;
    (void)end;
#else
    e->end = end;
#endif
}

/* What a node says of its children. */
typedef struct children {
    uint32_t owners;       /* six bits, xmin first; 1: the right child's */
    uint32_t lo[3], hi[3]; /* the planes, each in the box of its owner */
    float at[2][2];        /* entry of each, minus its exit */
} children;

static inline void clip_by(children *c, const plt_beam *b, int p, float at) {
    const plt_beam_plane *plane = &b->plane[p];
    const float t = (at - plane->org) * plane->factor;
    float *to = &c->at[c->owners >> p & 1u][plane->leaves];
    if (t > *to) {
        *to = t;
    }
}

/* Both children's planes, as plt_block_apply (block.h), and where the beam is in them. */
static inline void decode(children *c, const plt_beam *b, const plt_block *block, uint32_t node,
                          const plt_beam_block_entry *parent) {
    const plt_lattice *l = &b->tree->lattice;
    const unsigned char *plane = block->planes + 6 * node;
    c->owners = plt_bits_short(block->owners, 5 * node, 5) << 1 | 1u;
    c->at[0][0] = c->at[1][0] = parent->enter;
    c->at[0][1] = c->at[1][1] = parent->minus_leave;
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const uint32_t step = plt_block_step(parent->hi[a] - parent->lo[a]);
        c->lo[a] = parent->lo[a] + plane[a] * step;
        c->hi[a] = parent->hi[a] - plane[3 + a] * step;
        clip_by(c, b, a, plt_lattice_float(l, a, c->lo[a]));
        clip_by(c, b, 3 + a, plt_lattice_float(l, a, c->hi[a]));
    }
}

/* The entry of a child; `e` may be the parent's. */
static inline void set_entry(plt_beam_block_entry *e, const plt_beam_block_entry *parent,
                             const children *c, const plt_opened_block *o, uint32_t node,
                             uint32_t child) {
    const plt_block_target to = plt_block_target_of(o, 2 * node + child);
    const int is_edge = plt_target_kind(to.target) == PLT_SLOT_EDGE;
    set_end(e, is_edge ? blocks_edge_end(o, to.link) : end_of(parent));
    e->enter = c->at[child][0];
    e->minus_leave = c->at[child][1];
    e->link = to.link;
    e->target = to.target;
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        e->lo[a] = (c->owners >> a & 1u) == child ? c->lo[a] : parent->lo[a];
        e->hi[a] = (c->owners >> (3 + a) & 1u) == child ? c->hi[a] : parent->hi[a];
    }
}

/* What will probably be needed may come meanwhile. */
static inline void expect_leaves(const plt_traversal *t, const plt_opened_block *o, uint32_t node) {
#ifdef PLT_BLOCKS_RESIDENT
    (void)t;
    (void)o;
    (void)node;
#else
    blocks_prefetch(t, &o->block, node);
#endif
}

/* Goes on to the nearer child that is met; the other one, if it is met, too, waits. 0: none
 * is. */
static inline int visit_node(const plt_beam *b, plt_traversal *t, const plt_opened_block *o,
                             plt_beam_block_entry *at) {
    const uint32_t node = plt_target_index(at->target);
    children c;
    expect_leaves(t, o, node);
    decode(&c, b, &o->block, node, at);
    const int left = plt_beam_meets(b, c.at[0][0], c.at[0][1]);
    const int right = plt_beam_meets(b, c.at[1][0], c.at[1][1]);
    uint32_t near = !left;
    if (left && right) {
        near = c.at[1][0] - c.at[1][1] < c.at[0][0] - c.at[0][1];
        set_entry((plt_beam_block_entry *)t->stack + t->waiting++, at, &c, o, node, near ^ 1);
    } else if (!left && !right) {
        return 0;
    }
    set_entry(at, at, &c, o, node, near);
    return 1;
}

/* To the root of the block behind an edge, which has exact bounds. */
static inline int cross_edge(plt_traversal *t, plt_beam_block_entry *at) {
    const int status = blocks_open(t, at->link, end_of(at));
    if (status != PLT_OK) {
        return status;
    }
    const plt_opened_block *o = blocks_current(t);
    at->target = PLT_SLOT_INNER; /* node 0 */
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        at->lo[a] = (uint32_t)(int32_t)o->lo[a];
        at->hi[a] = (uint32_t)(int32_t)o->hi[a];
    }
    return PLT_OK;
}

/* No pixel sees what a block, or a node that has waited, leads to. What would have to be fetched is
 * always looked at, the rest where that pays. */
static inline int is_hidden(plt_beam *b, const plt_traversal *t, const plt_beam_block_entry *at) {
    if (!blocks_at_hand(t, at->link)) {
        return !plt_beam_sees(b, at);
    }
    return plt_target_kind(at->target) == PLT_SLOT_INNER && plt_beam_hides(b, &b->node_doubt, at);
}

/* Nor the triangles of a leaf. */
static inline int is_leaf_hidden(plt_beam *b, const plt_traversal *t,
                                 const plt_beam_block_entry *at) {
    return blocks_geometry_at_hand(t) ? plt_beam_hides(b, &b->leaf_doubt, at)
                                      : !plt_beam_sees(b, at);
}

static inline int test_leaf(plt_beam *b, plt_traversal *t, const plt_beam_block_entry *at,
                            plt_beam_counts *c) {
    if (is_leaf_hidden(b, t, at)) {
        return PLT_OK;
    }
    const int status = blocks_open_geometry(t);
    if (status != PLT_OK) {
        return status;
    }
    const plt_opened_block *o = blocks_current(t);
    uint32_t count;
    const uint32_t first = plt_block_leaf(o, at->target, &count);
    if (b->tree->leaf_kind == PLT_LEAF_STRIPS) {
        plt_beam_strips(b, &o->geometry, first, count);
    } else {
        plt_beam_lists(b, o->geometry.first_triangle + first, count, 1);
    }
    c->triangles += count;
    if (b->is_stored && b->open == 0) {
        plt_beam_update_far(b);
    }
    return PLT_OK;
}

/* From an entry down to a leaf, or to nothing. */
static inline int descend(plt_beam *b, plt_traversal *t, plt_beam_block_entry *at,
                          plt_beam_counts *c) {
    int status = PLT_OK;
    if (is_hidden(b, t, at)) {
        return PLT_OK;
    }
    if (plt_target_kind(at->target) != PLT_SLOT_EDGE) {
        status = blocks_return(t, at->link, end_of(at), at->target);
    }
    for (;;) {
        if (plt_target_kind(at->target) == PLT_SLOT_EDGE) {
            status = cross_edge(t, at);
        }
        if (status != PLT_OK) {
            return status;
        }
        const plt_opened_block *o = blocks_current(t);
        do {
            if (plt_target_kind(at->target) == PLT_SLOT_LEAF) {
                return test_leaf(b, t, at, c);
            }
            c->nodes++;
            if (!visit_node(b, t, o, at)) {
                return PLT_OK;
            }
        } while (plt_target_kind(at->target) != PLT_SLOT_EDGE);
        if (is_hidden(b, t, at)) {
            return PLT_OK;
        }
    }
}

void BEAM_JOINED(BEAM_BLOCKS, init)(plt_traversal *t) {
    format_state_init(t);
}

void BEAM_JOINED(BEAM_BLOCKS, push)(plt_beam *b, plt_traversal *t, const plt_beam_entry *root) {
    plt_beam_block_entry *to = (plt_beam_block_entry *)t->stack;
    b->tree = blocks_tree(t);
    to->enter = root->enter;
    to->minus_leave = root->minus_leave;
    to->link = b->tree->root;
    to->target = PLT_SLOT_EDGE;
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        to->lo[a] = b->tree->box.lo[a];
        to->hi[a] = b->tree->box.hi[a];
    }
    set_end(to, blocks_root_end(b->tree));
    blocks_leave((format_state *)t->state);
    t->waiting = to->link != PLT_LINK_NONE;
    BEAM_STACK(t, sizeof *to);
}

int BEAM_JOINED(BEAM_BLOCKS, trace)(plt_beam *b, plt_traversal *t, uint32_t visits,
                                    plt_beam_counts *c) {
    int status = PLT_OK;
    for (uint32_t entries = 0; t->waiting > 0 && c->nodes + entries < visits; entries++) {
        const plt_beam_block_entry *top = (plt_beam_block_entry *)t->stack + --t->waiting;
        if (plt_beam_meets(b, top->enter, top->minus_leave)) {
            plt_beam_block_entry at = *top;
            status = descend(b, t, &at, c);
            if (status != PLT_OK) {
                t->waiting = 0;
                break;
            }
        }
    }
    BEAM_PAUSE(t);
    return status;
}

#endif
