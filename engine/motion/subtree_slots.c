/* subtree_slots - see subtree_slots.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/subtree_slots.h"

#if PLT_WITH_SUBTREES

/* A link comes into the tree or leaves it: `by` 1 or -1. */
static void count_link(plt_info *info, uint32_t link, uint32_t by) {
    if (plt_link_is_leaf(link)) {
        const int is_intermediate = plt_link_lists(link) == 2;
        info->intermediate_lists += is_intermediate ? by : 0;
        info->leaf_lists += is_intermediate ? 0 : by;
    } else {
        info->nodes += by;
        info->treelets += (link & PLT_LINK_OUT) != 0 ? by : 0;
    }
}

/* The greatest of a heap whose root alone may be out of order comes to its top. */
static void sift(uint32_t *a, uint32_t root, uint32_t count) {
    for (uint32_t child; (child = 2 * root + 1) < count; root = child) {
        child += child + 1 < count && a[child] < a[child + 1];
        if (a[root] >= a[child]) {
            return;
        }
        const uint32_t t = a[root];
        a[root] = a[child];
        a[child] = t;
    }
}

/* Heapsort: in place, and n log n whatever the order. */
static void sort(uint32_t *a, uint32_t count) {
    for (uint32_t i = count / 2; i-- > 0;) {
        sift(a, i, count);
    }
    for (uint32_t i = count; i-- > 1;) {
        const uint32_t t = a[0];
        a[0] = a[i];
        a[i] = t;
        sift(a, 0, i);
    }
}

static uint32_t link_from_parent(const plt_subtree *p, const plt_tree *tree) {
    return p->parent == PLT_SUBTREE_NONE
               ? tree->root
               : plt_node_link(&tree->nodes[p->parent / 2], (int)(p->parent % 2));
}

/* Nodes breadth first: the list is its own queue. */
void plt_subtree_slots(const plt_subtree *p, const plt_tree *tree, uint32_t *slot, plt_info *info) {
    uint32_t count = 1;
    slot[0] = p->root;
    count_link(info, link_from_parent(p, tree), (uint32_t)-1);
    for (uint32_t i = 0; i < count; i++) {
        for (int c = 0; c < 2; c++) {
            const uint32_t link = plt_node_link(&tree->nodes[slot[i]], c);
            count_link(info, link, (uint32_t)-1);
            if (!plt_link_is_leaf(link)) {
                slot[count++] = plt_link_index(link);
            }
        }
    }
    for (uint32_t i = p->free; i != PLT_SUBTREE_NONE; i = tree->nodes[i].word[0]) {
        slot[count++] = i;
    }
    sort(slot, count);
}

/* From a node in slot `from`, or from nowhere, to one in slot `to`. */
static uint32_t node_link(const plt_tree *tree, uint32_t from, uint32_t to) {
    const int is_inner =
        from == PLT_SUBTREE_NONE || from / tree->treelet_nodes == to / tree->treelet_nodes;
    return plt_link_make(to, is_inner ? 0 : PLT_LINK_OUT);
}

static void put_node(const plt_subtree *p, const plt_tree *tree, const plt_node *from, uint32_t to,
                     const uint32_t *slot, plt_info *info) {
    plt_node node = *from;
    for (int c = 0; c < 2; c++) {
        const uint32_t link = plt_node_link(&node, c), index = plt_link_index(link);
        const uint32_t now = plt_link_is_leaf(link)
                                 ? plt_link_make(p->first + index, link & PLT_LINK_KIND)
                                 : node_link(tree, to, slot[index]);
        plt_node_relink(&node, c, now);
        count_link(info, now, 1);
    }
    ((plt_node *)(uintptr_t)tree->nodes)[to] = node;
}

static void put_root(plt_subtree *p, plt_tree *tree, uint32_t root, plt_info *info) {
    const uint32_t parent = p->parent == PLT_SUBTREE_NONE ? p->parent : p->parent / 2;
    const uint32_t link = node_link(tree, parent, root);
    p->root = root;
    count_link(info, link, 1);
    if (parent == PLT_SUBTREE_NONE) {
        tree->root = link;
    } else {
        plt_node_relink(&((plt_node *)(uintptr_t)tree->nodes)[parent], (int)(p->parent % 2), link);
    }
}

void plt_subtree_put(plt_subtree *p, plt_tree *tree, const plt_node *nodes, uint32_t count,
                     const plt_record *records, const uint32_t *slot, plt_info *info) {
    plt_node *to = (plt_node *)(uintptr_t)tree->nodes;
    memcpy((plt_record *)(uintptr_t)tree->records + p->first, records,
           (size_t)p->count * sizeof *records);
    for (uint32_t i = 0; i < count; i++) {
        put_node(p, tree, &nodes[i], slot[i], slot, info);
    }
    p->free = PLT_SUBTREE_NONE;
    for (uint32_t i = p->slots; i-- > count;) {
        const plt_node none = {{p->free, 0, 0, 0, 0, 0, 0, 0}};
        to[slot[i]] = none;
        p->free = slot[i];
    }
    put_root(p, tree, slot[0], info);
}

#endif
