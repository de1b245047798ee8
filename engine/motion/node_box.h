/* node_box - boxes of lists and nodes in lanes, and how a refit writes them
 *
 * A box is two registers, x y z and a lane that means nothing.
 *
 * Source: Karrenberg 2007, figure 3.6; Lauterbach, Yoon, Tuft, Manocha, "RT-DEFORM: Interactive
 * Ray Tracing of Dynamic Scenes using BVHs", 2006, section 4 (the ratio of areas).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_NODE_BOX_H
#define PLT_MOTION_NODE_BOX_H

#include "engine/lanes/lanes.h"
#include "engine/tree/record.h"
#include "engine/tree/thesis/node.h"

typedef struct plt_box4 {
    f4 lo, hi;
} plt_box4;

static inline plt_box4 plt_box4_join(plt_box4 a, plt_box4 b) {
    const plt_box4 both = {f4_min(a.lo, b.lo), f4_max(a.hi, b.hi)};
    return both;
}

/* Of two zeros the positive one: what a box is must not depend on the order of its making. */
static inline void plt_box4_store(plt_box4 b, plt_box *to) {
    float lo[4], hi[4];
    f4_store(lo, f4_add(b.lo, f4_zero()));
    f4_store(hi, f4_add(b.hi, f4_zero()));
    for (int a = 0; a < 3; a++) {
        to->lo[a] = lo[a];
        to->hi[a] = hi[a];
    }
}

/* Four words of an image as floats. */
static inline f4 plt_words_load(const uint32_t *word) {
    float v[4];
    plt_get_floats(v, (const unsigned char *)word, 4);
    return f4_load(v);
}

static inline void plt_words_store(uint32_t *word, f4 a) {
    float v[4];
    f4_store(v, a);
    plt_put_floats((unsigned char *)word, v, 4);
}

static inline plt_box4 plt_record_box4(const plt_record *r) {
    const f4 p = plt_words_load(&r->word[0]), q = plt_words_load(&r->word[3]),
             s = plt_words_load(&r->word[6]);
    const plt_box4 b = {f4_min(f4_min(p, q), s), f4_max(f4_max(p, q), s)};
    return b;
}

/* Of one list, or of two beside each other. */
static inline plt_box4 plt_lists_box4(const plt_record *records, uint32_t link) {
    const plt_record *r = &records[plt_link_index(link)];
    plt_box4 box = plt_record_box4(r);
    for (uint32_t lists = plt_link_lists(link);;) {
        lists -= (uint32_t)plt_record_is_last(r);
        if (lists == 0) {
            return box;
        }
        box = plt_box4_join(box, plt_record_box4(++r));
    }
}

/* Owner bits (x is the highest) of axes that are not the parent's: bits 0 to 2 of `own` are 1. */
static inline uint32_t plt_owner_bits(unsigned own) {
    static const uint8_t bits[8] = {0, 0x10, 0x08, 0x18, 0x04, 0x14, 0x0C, 0x1C};
    return bits[own & 7u];
}

/* The planes of figure 3.6, of equal ones the old, and of new zeros the positive one. Lane 3 of
 * one lies in what is written next. */
static inline uint32_t plt_planes_put(uint32_t *word, f4 old, f4 parent, f4 left, f4 right) {
    const m4 shared = f4_eq(right, parent);
    const f4 plane = f4_select(shared, left, right);
    plt_words_store(word, f4_select(f4_eq(old, plane), old, f4_add(plane, f4_zero())));
    return plt_owner_bits(~m4_mask(shared));
}

/* Both children's boxes into the node; its own. */
static inline plt_box4 plt_node_fit(plt_node *node, plt_box4 left, plt_box4 right) {
    const plt_box4 parent = plt_box4_join(left, right);
    const f4 old_lo = plt_words_load(&node->word[0]), old_hi = plt_words_load(&node->word[3]);
    const uint32_t link[2] = {plt_node_link(node, 0), plt_node_link(node, 1)};
    const uint32_t lo = plt_planes_put(&node->word[0], old_lo, parent.lo, left.lo, right.lo);
    const uint32_t hi = plt_planes_put(&node->word[3], old_hi, parent.hi, left.hi, right.hi);
    plt_node_set_link(node, 0, (link[0] & ~PLT_LINK_OWNERS) | lo);
    plt_node_set_link(node, 1, (link[1] & ~PLT_LINK_OWNERS) | hi);
    return parent;
}

/* What the areas of nodes say of a tree, in integers, so that sums are exact in any order. */
typedef struct plt_areas {
    uint64_t ratios; /* of each node's area to its children's together, in 1/65,536 */
    uint64_t sum;    /* of all nodes' areas, times scale */
    float scale;
} plt_areas;

/* A ratio is at most this: a node of children without area has no more to say. And an area that
 * is beyond its range is as large as that. */
#define PLT_RATIO_MOST 16.0f
#define PLT_AREA_MOST 1073741824.0f

/* Of a node that comes, or goes (`sign` 1 or -1). */
static inline void plt_areas_add(plt_areas *to, int sign, plt_box4 parent, plt_box4 left,
                                 plt_box4 right) {
    f4 x = f4_sub(parent.hi, parent.lo), y = f4_sub(left.hi, left.lo),
       z = f4_sub(right.hi, right.lo), none = z;
    f4_transpose(&x, &y, &z, &none);
    float half_area[4];
    f4_store(half_area, f4_add(f4_add(f4_mul(x, y), f4_mul(y, z)), f4_mul(z, x)));
    const float own = half_area[0], children = half_area[1] + half_area[2];
    const float ratio = own < PLT_RATIO_MOST * children ? own / children
                        : own > 0.0f                    ? PLT_RATIO_MOST
                                                        : 1.0f;
    const float scaled = own * to->scale;
    const float area = scaled < PLT_AREA_MOST ? scaled : PLT_AREA_MOST;
    to->ratios += (uint64_t)((int64_t)sign * (int32_t)(ratio * 65536.0f));
    to->sum += (uint64_t)((int64_t)sign * (int32_t)area);
}

/* Boxes around that area have 24 bits of it, and seven above. */
static inline float plt_areas_scale(const plt_box *box) {
    const float half_area = plt_box_half_area(box);
    return half_area > 0.0f ? 16777216.0f / half_area : 0.0f;
}

#endif
