/* node_box_code - the functions of node_box.h
 *
 * Inline where four lanes are one register, and functions where they are much code: node_box.c.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_NODE_BOX_CODE_H
#define PLT_MOTION_NODE_BOX_CODE_H

#include "engine/motion/node_box_types.h"
#include "engine/tree/words.h"

#ifndef PLT_NODE_BOX
#define PLT_NODE_BOX static inline
#endif

PLT_NODE_BOX plt_box4 plt_record_box4(const plt_record *r) {
    const f4 p = plt_words_load(&r->word[0]), q = plt_words_load(&r->word[3]),
             s = plt_words_load(&r->word[6]);
    const plt_box4 b = {f4_min(f4_min(p, q), s), f4_max(f4_max(p, q), s)};
    return b;
}

/* Of one list, or of two beside each other. */
PLT_NODE_BOX plt_box4 plt_lists_box4(const plt_record *records, uint32_t link) {
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
PLT_NODE_BOX uint32_t plt_planes_put(uint32_t *word, f4 old, f4 parent, f4 left, f4 right) {
    const m4 shared = f4_eq(right, parent);
    const f4 plane = f4_select(shared, left, right);
    plt_words_store(word, f4_select(f4_eq(old, plane), old, f4_add(plane, f4_zero())));
    return plt_owner_bits(~m4_mask(shared));
}

/* Both children's boxes into the node; its own. */
PLT_NODE_BOX plt_box4 plt_node_fit(plt_node *node, plt_box4 left, plt_box4 right) {
    const plt_box4 parent = plt_box4_join(left, right);
    const f4 old_lo = plt_words_load(&node->word[0]), old_hi = plt_words_load(&node->word[3]);
    const uint32_t link[2] = {plt_node_link(node, 0), plt_node_link(node, 1)};
    const uint32_t lo = plt_planes_put(&node->word[0], old_lo, parent.lo, left.lo, right.lo);
    const uint32_t hi = plt_planes_put(&node->word[3], old_hi, parent.hi, left.hi, right.hi);
    plt_node_set_link(node, 0, (link[0] & ~PLT_LINK_OWNERS) | lo);
    plt_node_set_link(node, 1, (link[1] & ~PLT_LINK_OWNERS) | hi);
    return parent;
}

/* Of three boxes; the last number means nothing. */
#if PLT_LANES_REGISTERS
static inline void plt_half_areas(plt_box4 p, plt_box4 q, plt_box4 r, float to[4]) {
    f4 x = f4_sub(p.hi, p.lo), y = f4_sub(q.hi, q.lo), z = f4_sub(r.hi, r.lo), none = z;
    f4_transpose(&x, &y, &z, &none);
    f4_store(to, f4_add(f4_add(f4_mul(x, y), f4_mul(y, z)), f4_mul(z, x)));
}
#else
PLT_NODE_BOX float plt_box4_half_area(plt_box4 b) {
    float d[4];
    f4_store(d, f4_sub(b.hi, b.lo));
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
}

static inline void plt_half_areas(plt_box4 p, plt_box4 q, plt_box4 r, float to[4]) {
    to[0] = plt_box4_half_area(p);
    to[1] = plt_box4_half_area(q);
    to[2] = plt_box4_half_area(r);
}
#endif

/* Of a node that comes, or goes (`sign` 1 or -1). */
PLT_NODE_BOX void plt_areas_add(plt_areas *to, int sign, plt_box4 parent, plt_box4 left,
                                plt_box4 right) {
    float half_area[4];
    plt_half_areas(parent, left, right, half_area);
    const float own = half_area[0], children = half_area[1] + half_area[2];
    const float ratio = own < PLT_RATIO_MOST * children ? own / children
                        : own > 0.0f                    ? PLT_RATIO_MOST
                                                        : 1.0f;
    const float scaled = own * to->scale;
    const float area = scaled < PLT_AREA_MOST ? scaled : PLT_AREA_MOST;
    const int32_t by = (int32_t)(ratio * 65536.0f), size = (int32_t)area;
    to->ratios += (uint64_t)(int64_t)(sign > 0 ? by : -by);
    to->sum += (uint64_t)(int64_t)(sign > 0 ? size : -size);
}

#endif
