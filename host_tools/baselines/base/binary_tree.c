/* binary_tree - see binary_tree.h
 *
 * A stack of ranges that wait. What a range may be split into is tried on its records, which are
 * permuted by it; a leaf does not mind their order.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/base/binary_tree.h"

#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/baselines/base/binary_halve.h"

typedef struct range {
    uint32_t node, begin, end;
    uint32_t depth; /* inner nodes above */
} range;

typedef struct building {
    plt_split_bins bins;
    range stack[BINARY_DEPTH];
    uint32_t waiting;
} building;

static int reserve(binary_tree *t, uint32_t count) {
    const uint32_t room = count > 0 ? 2 * count - 1 : 1;
    t->count = t->nodes = t->leaves = t->depth = 0;
    if (room <= t->room) {
        return 0;
    }
    binary_tree_free(t);
    t->block = heap_get_aligned(((uint64_t)room + 1) * sizeof *t->node);
    if (t->block == NULL) {
        return -1;
    }
    t->node = (binary_node *)t->block + 1; /* children begin at odd numbers */
    t->room = room;
    return 0;
}

void binary_tree_free(binary_tree *t) {
    const uint64_t work = t->work;
    heap_drop(t->block);
    memset(t, 0, sizeof *t);
    t->work = work;
}

/* Whether both halves cost at least what the whole does (thesis, section 6.4, in tests of
 * triangles). A box without area is met by nothing but flat triangles: any split will do. */
static int is_dearer(const plt_box *whole, const plt_box half[2], uint32_t left, uint32_t count) {
    const float area = plt_box_half_area(whole), right = (float)(int32_t)(count - left);
    const float both =
        plt_box_half_area(&half[0]) * (float)(int32_t)left + plt_box_half_area(&half[1]) * right;
    return both + 2.0f * BINARY_BOX_COST * area >= area * (float)(int32_t)count;
}

static uint16_t axis_between(const plt_box half[2], int *is_swapped) {
    uint16_t axis = 0;
    float most = -1.0f;
    for (uint16_t a = 0; a < 3; a++) {
        const float apart = half[1].lo[a] + half[1].hi[a] - half[0].lo[a] - half[0].hi[a];
        const float size = apart < 0.0f ? -apart : apart;
        if (size > most) {
            most = size;
            axis = a;
            *is_swapped = apart < 0.0f;
        }
    }
    return axis;
}

static void set_leaf(binary_tree *t, const range *r) {
    binary_node *n = &t->node[r->node];
    n->first = r->begin;
    n->count = (uint16_t)(r->end - r->begin);
    n->axis = 0;
    for (uint32_t i = r->begin; i < r->end; i++) {
        plt_record_set_last(&t->record[i], i + 1 == r->end);
    }
    t->leaves++;
    t->depth = r->depth >= t->depth ? r->depth + 1 : t->depth;
}

static void set_inner(binary_tree *t, building *b, const range *r, uint32_t middle,
                      const plt_box half[2]) {
    binary_node *n = &t->node[r->node];
    const uint32_t first = t->nodes;
    int is_swapped = 0;
    n->axis = axis_between(half, &is_swapped);
    n->first = first;
    n->count = 0;
    t->nodes += 2;
    const range left = {first + (uint32_t)is_swapped, r->begin, middle, r->depth + 1};
    const range right = {first + 1 - (uint32_t)is_swapped, middle, r->end, r->depth + 1};
    t->node[left.node].box = half[0];
    t->node[right.node].box = half[1];
    b->stack[b->waiting++] = right;
    b->stack[b->waiting++] = left;
}

static void build_range(binary_tree *t, building *b, const range *r, const binary_options *o) {
    const uint32_t count = r->end - r->begin;
    const int may_stay = count <= o->leaf;
    if (count == 1 || (may_stay && !o->by_cost)) {
        set_leaf(t, r);
        return;
    }
    const plt_split_range how = {r->begin, r->end, r->depth, o->leaf, o->splits};
    plt_record_items items = {t->record, &b->bins};
    plt_box half[2];
    const plt_box *whole = &t->node[r->node].box;
    const uint32_t middle = o->by_grid ? binary_halve(&items, &how, &t->node[0].box, whole, half)
                                       : plt_split_records(&items, &how, whole, half);
    t->work += count;
    if (may_stay && is_dearer(whole, half, middle - r->begin, count)) {
        set_leaf(t, r);
    } else {
        set_inner(t, b, r, middle, half);
    }
}

int binary_tree_build(binary_tree *t, plt_record *record, uint32_t count, const plt_box *box,
                      const binary_options *o) {
    building *b = heap_get(sizeof *b);
    if (b == NULL || reserve(t, count) != 0) {
        heap_drop(b);
        return -1;
    }
    t->record = record;
    t->count = count;
    b->waiting = 0;
    if (count > 0) {
        t->node[0].box = *box;
        t->nodes = 1;
        b->stack[b->waiting++] = (range){0, 0, count, 0};
    }
    while (b->waiting > 0) {
        const range r = b->stack[--b->waiting];
        build_range(t, b, &r, o);
    }
    heap_drop(b);
    return 0;
}
