/* retrieval_build - makes the tables that the engine looks normals and colours up in
 *
 * SPDX-License-Identifier: MIT */
#ifndef RETRIEVAL_BUILD_H
#define RETRIEVAL_BUILD_H
#include <stddef.h>
#include <stdint.h>

/* A key of three words, and what the table is to give for it. */
typedef struct retrieval_pair {
    uint32_t key[3];
    uint32_t value;
} retrieval_pair;

typedef struct retrieval_table {
    uint32_t *entry; /* 3 * third; owned */
    uint32_t third, seed;
} retrieval_table;

/* Entries of a third of a table of so many keys. */
uint32_t retrieval_third(size_t keys);

/* Keys differ. The same table for the same pairs, on every machine. -1: memory is out. */
int retrieval_build(retrieval_table *t, const retrieval_pair *pair, size_t pairs);
void retrieval_free(retrieval_table *t);

#endif
