/* treelet_stack - see treelet_stack.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/treelets/treelet_stack.h"

#include <string.h>

#include "engine/tree/thesis/link.h"
#include "host_tools/base/heap.h"

void treelet_stack_free(treelet_stack *s) {
    heap_drop(s->entry);
    memset(s, 0, sizeof *s);
}

void treelet_push(treelet_stack *s, const treelet_entry *e) {
    if (s->count == s->room) {
        const uint32_t room = s->room > 0 ? 2 * s->room : 64;
        treelet_entry *more = heap_resize(s->entry, (uint64_t)room * sizeof *more);
        if (more == NULL) {
            s->is_short = 1;
            return;
        }
        s->entry = more;
        s->room = room;
    }
    s->entry[s->count++] = *e;
}

/* Whether `a` is to lie below `b`. */
static int is_below(const treelet_entry *a, const treelet_entry *b, int leaf_first) {
    const int left = plt_link_is_leaf(a->link), right = plt_link_is_leaf(b->link);
    return leaf_first && left != right ? !left : a->distance > b->distance;
}

/* Each in turn is put where it belongs among those before it; of equals below them. */
void treelet_sort(treelet_stack *s, uint32_t first, int leaf_first) {
    for (uint32_t i = first + 1; i < s->count; i++) {
        const treelet_entry moved = s->entry[i];
        uint32_t k = i;
        for (; k > first && !is_below(&s->entry[k - 1], &moved, leaf_first); k--) {
            s->entry[k] = s->entry[k - 1];
        }
        s->entry[k] = moved;
    }
}

static void swap(treelet_stack *s, uint32_t a, uint32_t b) {
    const treelet_entry kept = s->entry[a];
    s->entry[a] = s->entry[b];
    s->entry[b] = kept;
}

static int is_nearer(const treelet_stack *s, uint32_t a, uint32_t b) {
    return s->entry[a].distance < s->entry[b].distance;
}

void treelet_heap_push(treelet_stack *s, const treelet_entry *e) {
    const uint32_t before = s->count;
    treelet_push(s, e);
    for (uint32_t at = before; at > 0 && s->count > before && is_nearer(s, at, (at - 1) / 2);
         at = (at - 1) / 2) {
        swap(s, at, (at - 1) / 2);
    }
}

treelet_entry treelet_heap_pop(treelet_stack *s) {
    swap(s, 0, --s->count);
    for (uint32_t at = 0;;) {
        uint32_t nearest = at;
        for (uint32_t k = 2 * at + 1; k <= 2 * at + 2 && k < s->count; k++) {
            nearest = is_nearer(s, k, nearest) ? k : nearest;
        }
        if (nearest == at) {
            return s->entry[s->count];
        }
        swap(s, at, nearest);
        at = nearest;
    }
}
