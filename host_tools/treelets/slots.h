/* slots - blocks of N slots, and which of them takes a treelet
 *
 * Every block has its free slots at its end. What is asked for is a block with room: where as many
 * are free as are wanted, the one with most, or the newest.
 *
 * SPDX-License-Identifier: MIT */
#ifndef TREELETS_SLOTS_H
#define TREELETS_SLOTS_H

#include "host_tools/treelets/treelet_tree.h"

/* Blocks whose tails are free, by how much is: a chain of each size; or, for the newest, a tree
 * whose leaves are blocks, with the most that is free below each node. */
typedef struct treelet_blocks {
    uint32_t size, most; /* N; blocks at most */
    uint8_t rule;        /* enum treelet_slots */
    uint32_t blocks;
    uint32_t *used; /* of each block */
    uint32_t *head; /* [N] first block with so many free, and ... */
    uint32_t *next; /* ... of each block the next one */
    uint32_t *free; /* [2 * leaves] */
    uint32_t leaves;
    uint32_t largest; /* no chain above it has a block */
} treelet_blocks;

/* -1: no memory. */
int treelet_blocks_make(treelet_blocks *b, uint32_t size, uint8_t rule, uint32_t most);
void treelet_blocks_free(treelet_blocks *b);
/* The block, whose `used` still is where the treelet of so many nodes begins. */
uint32_t treelet_blocks_find(treelet_blocks *b, uint32_t nodes);
/* It is there now. */
void treelet_blocks_fill(treelet_blocks *b, uint32_t block, uint32_t nodes);

#endif
