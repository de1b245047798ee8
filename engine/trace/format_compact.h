/* format_compact - compact blocks; the operations of format.h
 *
 * Include blocks_resident.h or blocks_streamed.h before it: how a block is reached.
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

#include "engine/trace/block_place.h"
#include "engine/trace/block_target.h"
#include "engine/trace/format.h"
#include "engine/trace/format_meets.h"
#include "engine/trace/leaf_compact.h"

enum { FORMAT_TIGHTENS = 1, FORMAT_LEAVES_WAIT = 0 };

typedef plt_block_place format_place;

/* Boxes in scene units, written four lanes at once: the fourth of a store is
 * overwritten by the next. */
typedef union format_room {
    plt_box box[2];
    float lane[13];
} format_room;

typedef struct format_children {
    const plt_opened_block *opened;
    const plt_lattice *lattice;
    uint32_t node;   /* index in the block */
    float end;       /* of the block's subtree */
    f4 lo[2], hi[2]; /* lattice coordinates */
    format_room scene;
} format_children;

static inline int format_root(plt_traversal *t, format_place *place) {
    const plt_block_tree *tree = &t->scene->compact;
    plt_lattice_spread(&tree->box, place->lo, place->hi);
    blocks_set_end(place->hi, blocks_root_end(tree));
    place->link = tree->root;
    place->target = PLT_SLOT_EDGE;
    blocks_leave((format_state *)t->state);
    return tree->root != PLT_LINK_NONE;
}

static inline int format_is_leaf(const format_place *place) {
    return plt_target_kind(place->target) == PLT_SLOT_LEAF;
}

static inline int format_is_edge(const format_place *place) {
    return plt_target_kind(place->target) == PLT_SLOT_EDGE;
}

/* Seven floats from `to` on; the last means nothing. */
static inline void set_scene_box(const plt_lattice *l, f4 lo, f4 hi, float *to) {
    f4_store(to, plt_lattice_planes(l, lo));
    f4_store(to + 3, plt_lattice_planes(l, hi));
}

static inline const plt_box *format_box(const plt_traversal *t, const format_place *place,
                                        format_room *room) {
    set_scene_box(&t->scene->compact.lattice, f4_load(place->lo), f4_load(place->hi), room->lane);
    return room->box;
}

static inline void format_bounds(const plt_traversal *t, const format_place *place, f4 *lo,
                                 f4 *hi) {
    const plt_lattice *l = &t->scene->compact.lattice;
    *lo = plt_lattice_planes(l, f4_load(place->lo));
    *hi = plt_lattice_planes(l, f4_load(place->hi));
}

/* The root of a block has exact bounds. In trees of our builder they are no larger than
 * the box that led here; in a hostile tree larger ones cost tests, never hits. */
static inline int format_enter(plt_traversal *t, format_place *place) {
    const float end = place->hi[3];
    const int status = blocks_open(t, place->link, end);
    if (status != PLT_OK) {
        return status;
    }
    const plt_opened_block *o = blocks_current(t);
    place->target = PLT_SLOT_INNER; /* node 0 */
    f4_store(place->lo, f4_load(o->lo));
    f4_store(place->hi, f4_load(o->hi));
    blocks_set_end(place->hi, end);
    return PLT_OK;
}

static inline int format_cross(plt_traversal *t, format_place *place) {
    return format_is_edge(place) ? format_enter(t, place) : PLT_OK;
}

#if FORMAT_MEETS
static inline int format_wait(plt_traversal *t, const format_place *place, float distance,
                              const void *entry, size_t bytes) {
    const uint32_t end = (uint32_t)place->hi[3]; /* of its subtree, in eights of bytes */
    return plt_tasks_wait(t->tasks, place->link, end, distance, entry, bytes, sizeof *place);
}
#endif

static inline int format_return(plt_traversal *t, format_place *place) {
    if (format_is_edge(place)) {
        return format_enter(t, place);
    }
    return blocks_return(t, place->link, place->hi[3], place->target);
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
static inline void decode_boxes(const plt_block *b, uint32_t node, const format_place *place,
                                f4 lo[2], f4 hi[2]) {
    const unsigned char *plane = b->planes + 6 * node;
    /* xmin is always the right child's: five bits are stored. */
    const uint32_t owners = plt_bits_get(b->owners, 5 * node, 5) << 1 | 1u;
    const f4 old_lo = f4_load(place->lo), old_hi = f4_load(place->hi);
    const f4 step = plane_step(f4_sub(old_hi, old_lo));
    const f4 new_lo = f4_add(old_lo, f4_mul(f4_of_bytes(plane), step));
    const f4 new_hi = f4_sub(old_hi, f4_mul(f4_of_bytes(plane + 3), step));
    const m4 right_lo = m4_bits(owners & 7u), right_hi = m4_bits(owners >> 3);
    lo[0] = f4_select(right_lo, old_lo, new_lo);
    lo[1] = f4_select(right_lo, new_lo, old_lo);
    hi[0] = f4_select(right_hi, old_hi, new_hi);
    hi[1] = f4_select(right_hi, new_hi, old_hi);
}

static inline void format_decode(const plt_traversal *t, const format_place *place,
                                 format_children *c) {
    const plt_block_tree *tree = &t->scene->compact;
    c->opened = blocks_current(t);
    c->node = plt_target_index(place->target);
    c->end = place->hi[3];
    blocks_prefetch(t, &c->opened->block, c->node);
    c->lattice = &tree->lattice;
    decode_boxes(&c->opened->block, c->node, place, c->lo, c->hi);
}

static inline const plt_box *format_boxes(format_children *c) {
    for (int i = 0; i < 2; i++) {
        set_scene_box(c->lattice, c->lo[i], c->hi[i], c->scene.lane + 6 * i);
    }
    return c->scene.box;
}

static inline void format_child_bounds(const format_children *c, unsigned child, f4 *lo, f4 *hi) {
    *lo = plt_lattice_planes(c->lattice, c->lo[child]);
    *hi = plt_lattice_planes(c->lattice, c->hi[child]);
}

/* A child is asked what it is only when it is met. */
static inline void format_child(const format_children *c, unsigned child, format_place *place) {
    f4_store(place->lo, c->lo[child]);
    f4_store(place->hi, c->hi[child]);
    const plt_block_target to = plt_block_target_of(c->opened, 2 * c->node + child);
    place->link = to.link;
    place->target = to.target;
    blocks_set_end(place->hi, plt_target_kind(to.target) == PLT_SLOT_EDGE
                                  ? blocks_edge_end(c->opened, to.link)
                                  : c->end);
}

/* Floats of corners were rounded, so a step is added. */
static inline float longest_side(const plt_lattice *l, const format_place *place) {
    float longest = 0.0f;
    for (int a = 0; a < 3; a++) {
        const float side = place->hi[a] - place->lo[a];
        longest = side > longest ? side : longest;
    }
    return l->step * (longest + 1.0f);
}

static inline int format_leaf(plt_traversal *t, plt_packet *p, const format_place *place,
                              plt_mask groups) {
    const int status = blocks_open_geometry(t);
    if (status != PLT_OK) {
        return status;
    }
    const plt_block_tree *tree = blocks_tree(t);
    const plt_opened_block *o = blocks_current(t);
    plt_leaf_run run;
    run.longest = longest_side(&tree->lattice, place);
    run.first = plt_block_leaf(o, place->target, &run.count);
    t->stats.triangle_tests += (uint64_t)run.count * plt_mask_count(groups);
    plt_leaf_groups(tree, &o->geometry, &run, p, groups);
    blocks_keep(t, p, &run, groups);
    return PLT_OK;
}

#ifdef PLT_BLOCKS_RESIDENT /* which alone are collapsed */
static inline plt_leaf_run run_of(const plt_opened_block *o, const format_place *place) {
    plt_leaf_run run = {0, 0, 0.0f};
    run.first = plt_block_leaf(o, place->target, &run.count);
    return run;
}

static inline uint32_t format_count(const plt_traversal *t, const format_place *place) {
    return run_of(plt_block_with_geometry(t), place).count;
}

#if PLT_WITH_WAVE
static inline void format_triangle(const plt_traversal *t, const format_place *place,
                                   uint32_t index, plt_triangle *to) {
    const plt_opened_block *o = plt_block_with_geometry(t);
    const plt_leaf_run run = run_of(o, place);
    plt_leaf_triangle(&t->scene->compact, &o->geometry, &run, index, to);
}
#endif
#endif

#endif
