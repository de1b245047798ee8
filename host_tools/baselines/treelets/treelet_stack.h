/* treelet_stack - entries that wait: a stack, and by distance a heap
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_TREELET_STACK_H
#define BASELINES_TREELET_STACK_H

#include "engine/base/box.h"
#include "host_tools/baselines/packet/packet_mask.h"

typedef struct treelet_entry {
    plt_box box;
    packet_mask rays; /* that met the box when it was pushed */
    uint32_t link;
    uint8_t parity;  /* of the treelet that it leads into */
    uint8_t crosses; /* into another one */
    float distance;  /* where the first of those rays enters the box */
} treelet_entry;

typedef struct treelet_stack {
    treelet_entry *entry; /* owned */
    uint32_t count, room;
    uint8_t is_short; /* an entry found no memory */
} treelet_stack;

void treelet_stack_free(treelet_stack *s);
void treelet_push(treelet_stack *s, const treelet_entry *e);

static inline treelet_entry treelet_pop(treelet_stack *s) {
    return s->entry[--s->count];
}

/* Entries from `first` on, the nearest on top; `leaf_first`: leaves above nodes. Of equals the one
 * that was pushed first is on top. */
void treelet_sort(treelet_stack *s, uint32_t first, int leaf_first);

/* The same memory as a heap: the nearest comes out. Entries are pushed and popped by these alone.
 */
void treelet_heap_push(treelet_stack *s, const treelet_entry *e);
treelet_entry treelet_heap_pop(treelet_stack *s);

#endif
