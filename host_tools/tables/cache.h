/* cache - figures of earlier runs, in a file of the output folder
 *
 * A line of text for each: the key, the figures, a checksum. Lines are appended whole, so that a
 * run that is ended keeps what it has measured. Nothing in the file is trusted: a line that is not
 * whole, of another length or sum, or with a number that no measurement gives, is as if it were
 * not there; a file that does not begin as a cache does is refused and stays as it is.
 *
 * SPDX-License-Identifier: MIT */
#ifndef CACHE_H
#define CACHE_H
#include <stdint.h>

#include "host_tools/base/fail.h"
#include "host_tools/tables/figures.h"

#define CACHE_NAME "tables.cache"

typedef struct cache_entry {
    uint64_t key;
    figures what;
} cache_entry;

typedef struct cache {
    cache_entry *entry; /* owned; of one key the last counts */
    unsigned entries, room;
    char path[4200];
    int file;         /* open for appending; -1: none */
    unsigned refused; /* lines that were not taken */
} cache;

/* Reads the file, if there is one, and opens it for more. -1: `c` is closed. */
int cache_open(cache *c, const char *folder, fail *f);
void cache_close(cache *c);

/* 1: it was measured before. */
int cache_find(const cache *c, uint64_t key, figures *what);
int cache_add(cache *c, uint64_t key, const figures *what, fail *f);

/* Of this program: its own bytes where the system shows them, else its version. */
uint64_t cache_program(void);

#endif
