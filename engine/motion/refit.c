/* refit - see refit.h
 *
 * Post-order, left first, as lists lie: a node is encoded when both of its children's boxes are
 * known, and its own goes up.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/refit.h"

#include "engine/motion/words.h"

/* Lane 3 has no meaning. */
typedef struct box4 {
    f4 lo, hi;
} box4;

static inline box4 join(box4 a, box4 b) {
    const box4 both = {f4_min(a.lo, b.lo), f4_max(a.hi, b.hi)};
    return both;
}

static inline box4 record_box(const plt_record *r) {
    const f4 p = plt_words_load(&r->word[0]), q = plt_words_load(&r->word[3]),
             s = plt_words_load(&r->word[6]);
    const box4 b = {f4_min(f4_min(p, q), s), f4_max(f4_max(p, q), s)};
    return b;
}

/* Of one list, or of two beside each other. */
static box4 leaf_box(const plt_record *records, uint32_t link) {
    const plt_record *r = &records[plt_link_index(link)];
    box4 box = record_box(r);
    for (uint32_t lists = plt_link_lists(link);;) {
        lists -= (uint32_t)plt_record_is_last(r);
        if (lists == 0) {
            return box;
        }
        box = join(box, record_box(++r));
    }
}

/* Owner bits (x is the highest) of axes that are not the parent's: bits 0 to 2 of `own` are 1. */
static inline uint32_t owner_bits(unsigned own) {
    static const uint8_t bits[8] = {0, 0x10, 0x08, 0x18, 0x04, 0x14, 0x0C, 0x1C};
    return bits[own & 7u];
}

/* The planes of figure 3.6, of equal ones the old. Lane 3 of one lies in what is written next. */
static inline uint32_t put_planes(uint32_t *word, f4 old, f4 parent, f4 left, f4 right) {
    const m4 shared = f4_eq(right, parent);
    const f4 plane = f4_select(shared, left, right);
    plt_words_store(word, f4_select(f4_eq(old, plane), old, plane));
    return owner_bits(~m4_mask(shared));
}

/* Both children's boxes into the node; its own. */
static inline box4 encode(plt_node *node, box4 left, box4 right) {
    const box4 parent = join(left, right);
    const f4 old_lo = plt_words_load(&node->word[0]), old_hi = plt_words_load(&node->word[3]);
    const uint32_t link[2] = {plt_node_link(node, 0), plt_node_link(node, 1)};
    const uint32_t owners_lo = put_planes(&node->word[0], old_lo, parent.lo, left.lo, right.lo);
    const uint32_t owners_hi = put_planes(&node->word[3], old_hi, parent.hi, left.hi, right.hi);
    plt_node_set_link(node, 0, (link[0] & ~PLT_LINK_OWNERS) | owners_lo);
    plt_node_set_link(node, 1, (link[1] & ~PLT_LINK_OWNERS) | owners_hi);
    return parent;
}

static inline void keep(plt_refit_level *l, box4 box) {
    f4_store(l->lo, box.lo);
    f4_store(l->hi, box.hi);
    l->is_done = 1;
}

static inline box4 kept(const plt_refit_level *l) {
    const box4 box = {f4_load(l->lo), f4_load(l->hi)};
    return box;
}

/* Down to the leftmost leaf below `link`, every node on the way a level. */
static uint32_t descend(const plt_refit_job *job, uint32_t link, plt_refit_level **top) {
    while (!plt_link_is_leaf(link)) {
        (*top)->node = plt_link_index(link);
        (*top)->is_done = 0;
        link = plt_node_link(&job->nodes[(*top)->node], 0);
        ++*top;
    }
    return link;
}

/* Encodes all nodes that `box` was the last child of; then it is the left child of another one,
 * whose right link is the result, or the root's: PLT_LINK_NONE. */
static uint32_t ascend(const plt_refit_job *job, box4 *box, plt_refit_level **top) {
    while (*top != job->levels) {
        plt_refit_level *l = *top - 1;
        if (!l->is_done) {
            keep(l, *box);
            return plt_node_link(&job->nodes[l->node], 1);
        }
        *box = encode(&job->nodes[l->node], kept(l), *box);
        --*top;
    }
    return PLT_LINK_NONE;
}

void plt_refit(plt_refit_job *job) {
    plt_refit_level *top = job->levels;
    uint32_t link = job->root;
    box4 box;
    do {
        link = descend(job, link, &top);
        box = leaf_box(job->records, link);
        link = ascend(job, &box, &top);
    } while (link != PLT_LINK_NONE);
    float lo[4], hi[4];
    f4_store(lo, box.lo);
    f4_store(hi, box.hi);
    for (int a = 0; a < 3; a++) {
        job->box.lo[a] = lo[a];
        job->box.hi[a] = hi[a];
    }
}
