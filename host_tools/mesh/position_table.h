/* position_table - which of many things lie at one place
 *
 * Positions are three words of 32 bits: floats, or coordinates on a lattice. Two of equal words
 * are one position, and 0 and -0 are equal.
 *
 * SPDX-License-Identifier: MIT */
#ifndef POSITION_TABLE_H
#define POSITION_TABLE_H
#include <stddef.h>
#include <stdint.h>

typedef struct position_table {
    const void *positions; /* 12 bytes each; not owned */
    uint32_t *slot;        /* a number + 1; owned */
    uint64_t slots;
} position_table;

/* For at most so many different positions; -1 when memory is out. */
int position_table_begin(position_table *t, const void *positions, size_t most);
/* The number that was the first to be asked for of those at the position of `number`; itself,
 * if none was. */
uint32_t position_table_first(position_table *t, uint32_t number);
void position_table_free(position_table *t);

/* Bytes that a table for so many takes: 6 each. */
uint64_t position_table_bytes(uint64_t most);

#endif
