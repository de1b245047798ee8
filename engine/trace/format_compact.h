/* format_compact - compact blocks; the operations of format.h
 *
 * Boxes are decoded once per packet and visit, in whole lattice numbers. They are
 * kept in floats, which hold whole numbers up to 2^24 exactly, so that the 4-lane
 * operations decode all three axes at once; a lattice has at most 21 bits. They become
 * planes of the scene just before they are tested: from there on everything is as for
 * thesis nodes, and hits are the same bit for bit.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_FORMAT_COMPACT_H
#define PLT_TRACE_FORMAT_COMPACT_H

#include "engine/memory/traffic.h"
#include "engine/trace/boxes.h"
#include "engine/trace/format.h"
#include "engine/trace/leaf_compact.h"

typedef struct format_entry {
    float lo[4], hi[4]; /* lattice numbers; the fourth means nothing */
    uint32_t link;      /* of its block; of an edge the block behind it */
    uint32_t what;      /* see below */
    plt_mask groups;
} format_entry;

/* `what`, four bytes: enum plt_slot_kind, the index of the node or leaf in its block,
 * and of a leaf the pairs before it, and whether it is a pair. */
static inline uint32_t kind_of(const format_entry *e) {
    return e->what & 0xFFu;
}

static inline uint32_t index_of(const format_entry *e) {
    return e->what >> 8 & 0xFFu;
}

static inline uint32_t pairs_before(const format_entry *e) {
    return e->what >> 16 & 0xFFu;
}

static inline int is_pair(const format_entry *e) {
    return (int)(e->what >> 24);
}

/* Boxes in scene units, written four lanes at once: the fourth of a store is
 * overwritten by the next. */
typedef union scene_boxes {
    plt_box box[2];
    float lane[13];
} scene_boxes;

typedef struct format_children {
    const plt_opened_block *opened;
    uint32_t node;   /* index in the block */
    f4 lo[2], hi[2]; /* lattice numbers */
    scene_boxes scene;
} format_children;

/* Makes the block behind `link` the one in hand. */
static inline plt_opened_block *open_block(plt_traversal *t, uint32_t link) {
    if (t->opened != NULL && link == t->opened->link) {
        return t->opened;
    }
    t->opened = plt_block_cache_find(t->cache, &t->scene->compact, link);
    t->geometry_counted = 0;
    t->stats.treelet_fetches++;
    plt_traffic_count(&t->stats, t->touched, plt_block_address(link) / 8,
                      t->opened->block.node_bytes);
    return t->opened;
}

static inline int format_root(plt_traversal *t, const plt_packet *p, format_entry *e) {
    const plt_block_tree *tree = &t->scene->compact;
    plt_lattice_spread(&tree->box, e->lo, e->hi);
    e->link = tree->root;
    e->what = PLT_SLOT_EDGE;
    e->groups = p->active;
    t->opened = NULL;
    return tree->root != PLT_MISS;
}

static inline int format_is_leaf(const format_entry *e) {
    return kind_of(e) == PLT_SLOT_LEAF;
}

static inline int format_is_edge(const format_entry *e) {
    return kind_of(e) == PLT_SLOT_EDGE;
}

/* Seven floats from `to` on; the last means nothing. */
static inline void set_scene_box(const plt_lattice *l, f4 lo, f4 hi, float *to) {
    f4_store(to, plt_lattice_planes(l, lo));
    f4_store(to + 3, plt_lattice_planes(l, hi));
}

PLT_OUTLINED static plt_mask meet(const plt_traversal *t, const plt_packet *p,
                                  const format_entry *e) {
    scene_boxes scene;
    set_scene_box(&t->scene->compact.lattice, f4_load(e->lo), f4_load(e->hi), scene.lane);
    return plt_box_groups(&p->slabs, scene.box, e->groups);
}

/* Into the block behind an edge: its root has exact bounds. Those of a tree that was
 * packed are no larger than the box that led here; larger ones cost tests, never hits. */
static inline void enter_block(plt_traversal *t, format_entry *e) {
    const plt_opened_block *o = open_block(t, e->link);
    e->what = PLT_SLOT_INNER; /* node 0 */
    f4_store(e->lo, f4_load(o->lo));
    f4_store(e->hi, f4_load(o->hi));
}

/* The box that led here has just been tested. Of many groups the bounds rarely turn any
 * away; of one they do often enough to be asked. */
static inline int format_enter(plt_traversal *t, const plt_packet *p, format_entry *e) {
    enter_block(t, e);
    if ((e->groups & (e->groups - 1)) == 0) {
        e->groups = meet(t, p, e);
    }
    return PLT_OK;
}

static inline int format_resume(plt_traversal *t, const plt_packet *p, format_entry *e) {
    if (e->groups != 0 && format_is_edge(e)) {
        enter_block(t, e);
    }
    e->groups = meet(t, p, e);
    if (e->groups != 0) {
        open_block(t, e->link);
    }
    return PLT_OK;
}

/* Asks for the blocks behind a node before it is known whether they are met. */
static inline void prefetch_edges(const plt_block_tree *tree, const plt_block *b, uint32_t node) {
    const uint32_t word = node >> 4, shift = node << 1 & 31, edge = b->mask[PLT_SLOT_EDGE][word];
    if ((edge >> shift & 3u) == 0) {
        return;
    }
    const uint32_t edges =
        b->before[PLT_SLOT_EDGE][word] + plt_count_bits(edge & plt_low_bits(shift));
    for (uint32_t i = 0; i < plt_count_bits(edge >> shift & 3u); i++) {
        plt_prefetch(tree->bytes + plt_block_address(plt_block_edge(b, edges + i)));
    }
}

/* max(1, (e + 254) / 255 rounded down), three axes at once: the quotient is at
 * least 1 / 255 from any whole number that it is not, and below 2^14, so that the
 * product is on the right side after 0.498 is taken off; adding 2^23 rounds. */
static inline f4 plane_step(f4 extent) {
    const f4 quotient = f4_mul(f4_add(extent, f4_all(254.0f)), f4_all(1.0f / 255.0f));
    const f4 magic = f4_all(8388608.0f);
    const f4 whole = f4_sub(f4_add(f4_sub(quotient, f4_all(0.498f)), magic), magic);
    return f4_max(whole, f4_all(1.0f));
}

/* Both children's boxes, as plt_block_apply (block.h). */
static inline void decode_boxes(const plt_block *b, uint32_t node, const format_entry *e, f4 lo[2],
                                f4 hi[2]) {
    const unsigned char *plane = b->planes + 6 * node;
    /* xmin is always the right child's: five bits are stored. */
    const uint32_t owners = plt_bits_get(b->owners, 5 * node, 5) << 1 | 1u;
    const f4 old_lo = f4_load(e->lo), old_hi = f4_load(e->hi);
    const f4 step = plane_step(f4_sub(old_hi, old_lo));
    const f4 new_lo = f4_add(old_lo, f4_mul(f4_of_bytes(plane), step));
    const f4 new_hi = f4_sub(old_hi, f4_mul(f4_of_bytes(plane + 3), step));
    const m4 right_lo = m4_bits(owners & 7u), right_hi = m4_bits(owners >> 3);
    lo[0] = f4_select(right_lo, old_lo, new_lo);
    lo[1] = f4_select(right_lo, new_lo, old_lo);
    hi[0] = f4_select(right_hi, old_hi, new_hi);
    hi[1] = f4_select(right_hi, new_hi, old_hi);
}

static inline void format_decode(const plt_traversal *t, const format_entry *e,
                                 format_children *c) {
    const plt_block_tree *tree = &t->scene->compact;
    c->opened = t->opened;
    c->node = index_of(e);
    prefetch_edges(tree, &c->opened->block, c->node);
    decode_boxes(&c->opened->block, c->node, e, c->lo, c->hi);
    for (int i = 0; i < 2; i++) {
        set_scene_box(&tree->lattice, c->lo[i], c->hi[i], c->scene.lane + 6 * i);
    }
}

static inline const plt_box *format_boxes(const format_children *c) {
    return c->scene.box;
}

/* What slot `slot` of the block leads to. */
static inline void set_target(const plt_opened_block *o, uint32_t slot, format_entry *e) {
    const plt_block *b = &o->block;
    const uint32_t word = slot >> 5, bit = 1u << (slot & 31), below = bit - 1u;
    const uint32_t inner = b->mask[PLT_SLOT_INNER][word], edge = b->mask[PLT_SLOT_EDGE][word];
    const uint32_t inners = b->before[PLT_SLOT_INNER][word] + plt_count_bits(inner & below);
    e->link = o->link;
    if (inner & bit) {
        e->what = PLT_SLOT_INNER | (inners + 1) << 8;
        return;
    }
    const uint32_t edges = b->before[PLT_SLOT_EDGE][word] + plt_count_bits(edge & below);
    if (edge & bit) {
        e->link = plt_block_edge(b, edges);
        e->what = PLT_SLOT_EDGE;
        return;
    }
    const uint32_t pair = b->pair[word];
    const uint32_t pairs = b->pairs_before[word] + plt_count_bits(pair & below);
    e->what = PLT_SLOT_LEAF | (slot - inners - edges) << 8 | pairs << 16 |
              (uint32_t)((pair & bit) != 0) << 24;
}

/* A child is asked what it is only when it is met. */
static inline void format_child(const format_children *c, unsigned child, plt_mask groups,
                                format_entry *e) {
    f4_store(e->lo, c->lo[child]);
    f4_store(e->hi, c->hi[child]);
    e->groups = groups;
    set_target(c->opened, 2 * c->node + child, e);
}

/* Floats of corners were rounded: hence the step more. */
static inline float longest_side(const plt_lattice *l, const format_entry *e) {
    float longest = 0.0f;
    for (int a = 0; a < 3; a++) {
        const float side = e->hi[a] - e->lo[a];
        longest = side > longest ? side : longest;
    }
    return l->step * (longest + 1.0f);
}

static inline int format_leaf(plt_traversal *t, plt_packet *p, const format_entry *e) {
    const plt_block_tree *tree = &t->scene->compact;
    plt_opened_block *o = t->opened;
    if (!o->geometry_open) {
        plt_opened_block_geometry(o, tree);
    }
    if (!t->geometry_counted) {
        t->geometry_counted = 1; /* beside the bit of the nodes part */
        plt_traffic_count(&t->stats, t->touched, plt_block_address(o->link) / 8 + 1,
                          o->block.geometry_bytes);
    }
    plt_leaf_run run = {.longest = longest_side(&tree->lattice, e)};
    run.first = plt_leaf_find(&o->geometry, index_of(e), pairs_before(e), is_pair(e), &run.count);
    t->stats.triangle_tests += (uint64_t)run.count * plt_mask_count(e->groups);
    plt_leaf_groups(tree, &o->geometry, &run, p, e->groups);
    return PLT_OK;
}

#endif
