/* dirty - see dirty.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/dirty.h"

#include "engine/motion/node_box.h"

#define NOWHERE 0xFFFFFFFFu

int plt_dirty_find(plt_dirty *d, const plt_record *records, uint32_t count) {
    memset(d->bits, 0, 4 * (((size_t)count + 31) / 32));
    memset(d->places, 0xFF, 4 * (size_t)count);
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t id = plt_primitive_id(plt_get_u32(&records[i].word[9]));
        if (d->places[id] != NOWHERE) {
            return 0;
        }
        d->places[id] = i;
    }
    return 1;
}

typedef struct refitting {
    plt_dirty *d;
    plt_node *nodes;
    const plt_record *records;
    uint32_t count;
    uint32_t next; /* the first record whose bit is set; count: there is none */
    plt_areas areas;
    plt_dirty_level *top; /* behind the path from the root */
} refitting;

/* Records before `from` are done with. */
static void go_on(refitting *r, uint32_t from) {
    const uint32_t words = (r->count + 31) / 32;
    uint32_t w = from / 32;
    uint32_t bits = w < words ? r->d->bits[w] & ~0u << from % 32 : 0;
    while (bits == 0 && ++w < words) {
        bits = r->d->bits[w];
    }
    r->next = r->count;
    if (bits != 0) {
        for (r->next = 32 * w; (bits & 1u) == 0; bits >>= 1) {
            r->next++;
        }
    }
}

static uint32_t first_record(const refitting *r, uint32_t link) {
    while (!plt_link_is_leaf(link)) {
        link = plt_node_link(&r->nodes[plt_link_index(link)], 0);
    }
    return plt_link_index(link);
}

static void push(refitting *r, uint32_t link, plt_box4 old, uint32_t end) {
    plt_dirty_level *l = r->top++;
    l->node = plt_link_index(link);
    f4_store(l->old_lo, old.lo);
    f4_store(l->old_hi, old.hi);
    l->right = first_record(r, plt_node_link(&r->nodes[l->node], 1));
    l->end = end;
    l->is_done = 0;
}

/* Owner bits of a link as bits of lanes, x the lowest. */
static inline m4 right_owns(const plt_node *node, int child) {
    static const uint8_t bits[8] = {0, 4, 2, 6, 1, 5, 3, 7};
    return m4_bits(bits[plt_node_link(node, child) >> 2 & 7u]);
}

/* As they were: plt_node_decode, in lanes. */
static void old_children(const plt_node *node, const plt_dirty_level *l, plt_box4 child[2]) {
    const f4 parent_lo = f4_load(l->old_lo), parent_hi = f4_load(l->old_hi);
    const f4 lo = plt_words_load(&node->word[0]), hi = plt_words_load(&node->word[3]);
    const m4 right_lo = right_owns(node, 0), right_hi = right_owns(node, 1);
    child[0].lo = f4_select(right_lo, parent_lo, lo);
    child[1].lo = f4_select(right_lo, lo, parent_lo);
    child[0].hi = f4_select(right_hi, parent_hi, hi);
    child[1].hi = f4_select(right_hi, hi, parent_hi);
}

/* The next child of the top node: 0: it is a node, pushed, and its box is to come. */
static int child_box(refitting *r, plt_box4 *box) {
    const plt_dirty_level *l = r->top - 1;
    const uint32_t end = l->is_done ? l->end : l->right;
    const uint32_t link = plt_node_link(&r->nodes[l->node], (int)l->is_done);
    plt_box4 old[2];
    old_children(&r->nodes[l->node], l, old);
    *box = old[l->is_done];
    if (r->next >= end) {
        return 1;
    }
    if (!plt_link_is_leaf(link)) {
        push(r, link, *box, end);
        return 0;
    }
    *box = plt_lists_box4(r->records, link);
    go_on(r, end);
    return 1;
}

/* What has come to the areas of all nodes, or left them, has to those of the node's subtree. */
static void count_in_subtree(const refitting *r, const plt_dirty_level *l, const plt_areas *had) {
#if PLT_WITH_SUBTREES
    plt_subtree *p = r->d->subtrees == NULL
                         ? NULL
                         : plt_subtrees_of(r->d->subtrees, l->right, (uint32_t)(l - r->d->levels));
    if (p != NULL) {
        p->ratios += r->areas.ratios - had->ratios;
        p->sum += r->areas.sum - had->sum;
    }
#else
    (void)r;
    (void)l;
    (void)had;
#endif
}

/* Both children's boxes are known. */
static plt_box4 fit(refitting *r, const plt_dirty_level *l, plt_box4 right) {
    plt_node *node = &r->nodes[l->node];
    const plt_box4 old = {f4_load(l->old_lo), f4_load(l->old_hi)};
    const plt_box4 left = {f4_load(l->lo), f4_load(l->hi)};
    const plt_areas had = r->areas;
    plt_box4 was[2];
    old_children(node, l, was);
    plt_areas_count(&r->areas, -1, old, was[0], was[1]);
    const plt_box4 box = plt_node_fit(node, left, right);
    plt_areas_count(&r->areas, 1, box, left, right);
    count_in_subtree(r, l, &had);
    return box;
}

/* Up to a node whose right child is to come; 0: `box` is the root's. */
static int ascend(refitting *r, plt_box4 *box) {
    while (r->top != r->d->levels) {
        plt_dirty_level *l = r->top - 1;
        if (!l->is_done) {
            f4_store(l->lo, box->lo);
            f4_store(l->hi, box->hi);
            l->is_done = 1;
            return 1;
        }
        *box = fit(r, l, *box);
        r->top--;
    }
    return 0;
}

void plt_dirty_refit(plt_dirty *d, const plt_tree *tree, plt_box *box, plt_areas *areas) {
    refitting r = {.d = d,
                   .nodes = (plt_node *)(uintptr_t)tree->nodes,
                   .records = tree->records,
                   .count = tree->records_count,
                   .areas = *areas,
                   .top = d->levels};
    plt_box4 now = plt_box4_load(box);
    go_on(&r, 0);
    push(&r, tree->root, now, r.count);
    while (!child_box(&r, &now) || ascend(&r, &now)) {
    }
    plt_box4_store(now, box);
    *areas = r.areas;
}
