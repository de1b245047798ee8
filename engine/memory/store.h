/* store - parts of an image in a fixed piece of memory
 *
 * Parts are of any size and lie one behind the other. When there is no room for a new one,
 * the oldest is given up, unless it was found since it was last looked at: then it moves up
 * to those before it and counts as new (second chance). So there are no gaps but in
 * front of a part that is held, which stays where it is, and at the end of the memory.
 *
 * The thesis's software cache in the local store of an SPE (section 4.3) has slots of one
 * size; compact blocks are of many.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MEMORY_STORE_H
#define PLT_MEMORY_STORE_H

#include <stddef.h>
#include <stdint.h>

#include "engine/planelet.h"

#define PLT_STORE_NONE 0xFFFFu

typedef struct plt_store_part {
    uint32_t key;       /* its name; PLT_STORE_NO_KEY: it has none, and is never found */
    uint32_t at, bytes; /* where it lies in `memory`, a multiple of 8; bytes likewise */
    uint16_t next;      /* in the queue, from the oldest on */
    uint16_t chain;     /* in its bucket */
    uint8_t found;      /* since the queue came by */
    uint8_t held;       /* so often; not moved, not given up */
    uint8_t depth;      /* this and what follows are the caller's */
    uint8_t fresh;      /* nobody has validated it yet */
    uint8_t more;
    uint32_t serial, against;
} plt_store_part;

#define PLT_STORE_NO_KEY 0xFFFFFFFFu

typedef struct plt_store {
    unsigned char *memory; /* aligned to 8; 8 bytes behind it may be read */
    uint32_t bytes;        /* of it */
    uint32_t free_at;      /* parts are put here */
    plt_store_part *part;
    uint16_t *bucket;
    uint16_t parts_most, buckets; /* buckets: a power of two */
    uint16_t oldest, newest, unused;
    uint64_t given_up; /* parts, so far */
} plt_store;

/* Lays a store out in `memory`, `bytes` of it, PLT_STORE_LEAST at least, aligned to 8. */
void plt_store_init(plt_store *store, void *memory, uint32_t bytes);

/* The part of that key, or PLT_STORE_NONE. */
uint16_t plt_store_find(plt_store *store, uint32_t key);

/* There is one. */
int plt_store_has(const plt_store *store, uint32_t key);

/* Room for a part of `bytes`, which the caller fills in. PLT_STORE_NONE: parts that are held
 * leave none. Other parts may move or be given up. */
uint16_t plt_store_take(plt_store *store, uint32_t key, uint32_t bytes);

/* It will not be found again: what was to be in it has not come. */
void plt_store_forget(plt_store *store, uint16_t part);

/* What a part of `bytes` takes. */
static inline uint32_t plt_store_rounded(uint32_t bytes) {
    return (bytes + 7u) & ~7u;
}

static inline unsigned char *plt_store_bytes(const plt_store *store, uint16_t part) {
    return store->memory + store->part[part].at;
}

#endif
