/* bph_tree - see bph_tree.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/bph/bph_tree.h"

#include "host_tools/base/heap.h"

#define NONE 0xFFFFFFFFu

/* A node of the binary tree on its way; `parent` and `child` say which link leads to it. */
typedef struct pending {
    uint32_t from, parent;
    uint32_t child, level; /* nodes above it */
} pending;

typedef struct converting {
    bph_tree *to;
    const binary_tree *from;
    pending *stack;
    uint32_t waiting;
} converting;

static void link_to(bph_tree *t, const pending *p, bph_edge edge) {
    if (p->parent == NONE) {
        t->root = edge;
        return;
    }
    plt_node_relink(&t->node[p->parent], (int)p->child, edge.link);
    if (t->counts != NULL) {
        t->counts[p->parent].of[p->child] = edge.count;
    }
}

/* A list's records, behind those that are there. */
static void put_list(converting *c, const binary_node *list) {
    bph_tree *t = c->to;
    for (uint32_t i = 0; i < list->count; i++) {
        t->record[t->records] = c->from->record[list->first + i];
        plt_record_set_last(&t->record[t->records++], i + 1 == list->count);
    }
}

/* One list, or two adjacent ones whose counts are added. */
static void put_lists(converting *c, const pending *p, const binary_node *a, const binary_node *b) {
    bph_tree *t = c->to;
    const uint32_t kind = PLT_LINK_LEAF | (b != NULL ? PLT_LINK_TWO : 0);
    const uint32_t count = a->count + (b != NULL ? b->count : 0);
    link_to(t, p, (bph_edge){plt_link_make(t->records, kind), t->format.has_counts ? count : 0});
    put_list(c, a);
    if (b != NULL) {
        put_list(c, b);
    }
    t->lists += b == NULL;
    t->intermediates += b != NULL;
}

static void put_node(converting *c, const pending *p, const binary_node *n) {
    bph_tree *t = c->to;
    const uint32_t node = t->nodes++;
    const binary_node *child = &c->from->node[n->first];
    const plt_box box[2] = {child[0].box, child[1].box};
    plt_node_encode(&t->node[node], &n->box, box);
    link_to(t, p, (bph_edge){plt_link_make(node, 0), 0});
    t->levels = p->level + 1 > t->levels ? p->level + 1 : t->levels;
    for (uint32_t i = 2; i-- > 0;) {
        c->stack[c->waiting++] = (pending){n->first + i, node, i, p->level + 1};
    }
}

static void put(converting *c, const pending *p) {
    const binary_node *n = &c->from->node[p->from];
    if (binary_is_leaf(n)) {
        put_lists(c, p, n, NULL);
        return;
    }
    const binary_node *left = &c->from->node[n->first], *right = left + 1;
    if (!c->to->format.is_unmerged && binary_is_leaf(left) && binary_is_leaf(right)) {
        put_lists(c, p, left, right);
    } else {
        put_node(c, p, n);
    }
}

/* How many records there are, or that lists are too long. */
static int measure(const binary_tree *from, const bph_format *format, uint64_t *records,
                   uint32_t *inner) {
    *records = *inner = 0;
    for (uint32_t i = 0; i < from->nodes; i++) {
        const binary_node *n = &from->node[i];
        *records += binary_is_leaf(n) ? n->count : 0;
        *inner += !binary_is_leaf(n);
        if (binary_is_leaf(n) && !format->has_counts && n->count > format->most) {
            return BPH_LONG_LIST;
        }
    }
    return *records > (uint64_t)PLT_INDEX_MAX + 1 ? BPH_TOO_MANY : BPH_CONVERTED;
}

static int make_room(bph_tree *t, converting *c, uint64_t records, uint32_t inner) {
    t->node = heap_get_zeroed((uint64_t)inner * sizeof *t->node + 1);
    t->record = heap_get(records * sizeof *t->record + 1);
    t->counts =
        t->format.has_counts ? heap_get_zeroed((uint64_t)inner * sizeof *t->counts + 1) : NULL;
    c->stack = heap_get((inner + 2ull) * sizeof *c->stack); /* as a chain has it */
    return t->node != NULL && t->record != NULL && c->stack != NULL &&
                   (t->counts != NULL || !t->format.has_counts)
               ? BPH_CONVERTED
               : BPH_NO_MEMORY;
}

int bph_convert(bph_tree *t, const binary_tree *from, const bph_format *format) {
    converting c = {.to = t, .from = from};
    uint64_t count;
    uint32_t inner;
    *t = (bph_tree){.format = *format, .box = from->node[0].box};
    int status = measure(from, format, &count, &inner);
    status = status == BPH_CONVERTED ? make_room(t, &c, count, inner) : status;
    if (status == BPH_CONVERTED) {
        c.stack[c.waiting++] = (pending){0, NONE, 0, 0};
    }
    while (c.waiting > 0) {
        const pending p = c.stack[--c.waiting];
        put(&c, &p);
    }
    heap_drop(c.stack);
    if (status != BPH_CONVERTED) {
        bph_tree_free(t);
    }
    return status;
}

void bph_tree_free(bph_tree *t) {
    heap_drop(t->node);
    heap_drop(t->counts);
    heap_drop(t->record);
    *t = (bph_tree){.node = NULL};
}

uint32_t bph_list_end(const bph_tree *t, uint32_t first) {
    while (!plt_record_is_last(&t->record[first])) {
        first++;
    }
    return first + 1;
}

uint32_t bph_edge_end(const bph_tree *t, const bph_edge *e) {
    const uint32_t first = plt_link_index(e->link);
    if (t->counts != NULL || e->count > 0) {
        return first + e->count;
    }
    const uint32_t end = bph_list_end(t, first);
    return plt_link_lists(e->link) == 1 ? end : bph_list_end(t, end);
}
