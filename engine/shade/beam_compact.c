/* beam_compact - the beam on its way through compact blocks, near child first
 *
 * As in beam_thesis.c a child's interval is its parent's, clipped by the planes it owns. Planes
 * are relative to the parent's box, so an entry has that, too, in lattice coordinates; a plane
 * becomes a float of the scene as it is tested, as in trace/format_compact.h.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/lanes/unroll.h"
#include "engine/shade/beam.h"
#include "engine/trace/block_entry.h"

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
    e->enter = c->at[child][0];
    e->minus_leave = c->at[child][1];
    e->link = to.link;
    e->target = to.target;
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        e->lo[a] = (c->owners >> a & 1u) == child ? c->lo[a] : parent->lo[a];
        e->hi[a] = (c->owners >> (3 + a) & 1u) == child ? c->hi[a] : parent->hi[a];
    }
}

/* Goes on to the nearer child that is met; the other one, if it is met, too, waits. 0: none
 * is. */
static inline int visit_node(const plt_beam *b, plt_traversal *t, const plt_opened_block *o,
                             plt_beam_block_entry *at) {
    const uint32_t node = plt_target_index(at->target);
    children c;
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
static inline const plt_opened_block *enter(plt_traversal *t, plt_beam_block_entry *at) {
    const plt_opened_block *o = plt_block_enter(t, at->link);
    at->target = PLT_SLOT_INNER; /* node 0 */
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        at->lo[a] = (uint32_t)(int32_t)o->lo[a];
        at->hi[a] = (uint32_t)(int32_t)o->hi[a];
    }
    return o;
}

static inline uint32_t test_leaf(plt_beam *b, plt_traversal *t, uint32_t target) {
    const plt_opened_block *o = plt_block_enter_geometry(t);
    uint32_t count;
    const uint32_t first = plt_block_leaf(o, target, &count);
    if (b->tree->leaf_kind == PLT_LEAF_STRIPS) {
        plt_beam_strips(b, &o->geometry, first, count);
    } else {
        plt_beam_lists(b, o->geometry.first_triangle + first, count, 1);
    }
    return count;
}

/* From an entry down to a leaf, or to nothing. */
static inline void descend(plt_beam *b, plt_traversal *t, plt_beam_block_entry *at,
                           plt_beam_counts *c) {
    const plt_opened_block *o = plt_block_enter(t, at->link);
    while (plt_target_kind(at->target) != PLT_SLOT_LEAF) {
        if (plt_target_kind(at->target) == PLT_SLOT_EDGE) {
            o = enter(t, at);
        }
        c->nodes++;
        if (!visit_node(b, t, o, at)) {
            return;
        }
    }
    c->triangles += test_leaf(b, t, at->target);
    if (b->is_stored && b->open == 0) {
        plt_beam_update_far(b);
    }
}

plt_beam_counts plt_beam_trace_blocks(plt_beam *b, plt_traversal *t, uint32_t visits) {
    plt_beam_counts c = {0, 0};
    for (uint32_t entries = 0; t->waiting > 0 && c.nodes + entries < visits; entries++) {
        const plt_beam_block_entry *top = (plt_beam_block_entry *)t->stack + --t->waiting;
        if (plt_beam_meets(b, top->enter, top->minus_leave)) {
            plt_beam_block_entry at = *top;
            descend(b, t, &at, &c);
        }
    }
    return c;
}
