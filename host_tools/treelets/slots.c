/* slots - see slots.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/treelets/slots.h"

#include "host_tools/base/heap.h"

#define NONE 0xFFFFFFFFu

static uint32_t larger(uint32_t a, uint32_t b) {
    return a > b ? a : b;
}

static int has_chains(const treelet_blocks *b) {
    return b->rule == TREELET_SLOTS_THESIS || b->rule == TREELET_SLOTS_COME;
}

static int make_chains(treelet_blocks *b) {
    b->head = heap_get((uint64_t)b->size * sizeof *b->head);
    b->next = heap_get((uint64_t)b->most * sizeof *b->next);
    for (uint32_t i = 0; i < b->size && b->head != NULL; i++) {
        b->head[i] = NONE;
    }
    return b->head != NULL && b->next != NULL;
}

static int make_tree(treelet_blocks *b) {
    b->leaves = 1;
    while (b->leaves < b->most) {
        b->leaves *= 2;
    }
    b->free = heap_get_zeroed(2 * (uint64_t)b->leaves * sizeof *b->free);
    return b->free != NULL;
}

int treelet_blocks_make(treelet_blocks *b, uint32_t size, uint8_t rule, uint32_t most) {
    *b = (treelet_blocks){.size = size, .rule = rule, .most = most};
    b->used = heap_get_zeroed((uint64_t)most * sizeof *b->used);
    const int is_made = b->used != NULL && (!has_chains(b) || make_chains(b)) &&
                        (rule != TREELET_SLOTS_NEWEST || make_tree(b));
    if (!is_made) {
        treelet_blocks_free(b);
    }
    return is_made ? 0 : -1;
}

void treelet_blocks_free(treelet_blocks *b) {
    heap_drop(b->used);
    heap_drop(b->head);
    heap_drop(b->next);
    heap_drop(b->free);
    *b = (treelet_blocks){.size = 0};
}

/* Its first block leaves the chain. */
static uint32_t take_first(treelet_blocks *b, uint32_t free_slots) {
    const uint32_t block = b->head[free_slots];
    b->head[free_slots] = b->next[block];
    return block;
}

static uint32_t fit_or_largest(treelet_blocks *b, uint32_t nodes) {
    if (b->head[nodes] != NONE) {
        return take_first(b, nodes);
    }
    while (b->largest > nodes && b->head[b->largest] == NONE) {
        b->largest--;
    }
    return b->largest > nodes ? take_first(b, b->largest) : NONE;
}

static uint32_t newest_with_room(const treelet_blocks *b, uint32_t nodes) {
    uint32_t at = 1;
    if (b->free[at] < nodes) {
        return NONE;
    }
    while (at < b->leaves) {
        at = b->free[2 * at + 1] >= nodes ? 2 * at + 1 : 2 * at;
    }
    return at - b->leaves;
}

uint32_t treelet_blocks_find(treelet_blocks *b, uint32_t nodes) {
    uint32_t block = NONE;
    if (nodes < b->size && has_chains(b)) {
        block = fit_or_largest(b, nodes);
    } else if (nodes < b->size && b->rule == TREELET_SLOTS_NEWEST) {
        block = newest_with_room(b, nodes);
    }
    return block != NONE ? block : b->blocks++;
}

void treelet_blocks_fill(treelet_blocks *b, uint32_t block, uint32_t nodes) {
    b->used[block] += nodes;
    const uint32_t left = b->size - b->used[block];
    if (has_chains(b) && left > 0) {
        b->next[block] = b->head[left];
        b->head[left] = block;
        b->largest = larger(b->largest, left);
    } else if (b->rule == TREELET_SLOTS_NEWEST) {
        uint32_t at = b->leaves + block;
        b->free[at] = left;
        for (at /= 2; at > 0; at /= 2) {
            b->free[at] = larger(b->free[2 * at], b->free[2 * at + 1]);
        }
    }
}
