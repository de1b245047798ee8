/* shares - work that is split among workers, who take from each other
 *
 * Items are numbered. Each worker begins with a share of consecutive ones and takes a run of them
 * at a time, from the front. One that has none left takes the back half of the largest share. So
 * all end together, and what a worker does is consecutive as long as it can be: its store is filled
 * with what is needed next.
 *
 * Keeps: every item is handed out once. There is no lock; a share is one word of 64 bits, and only
 * its front and its back move.
 *
 * Source: Blumofe, Leiserson, Scheduling Multithreaded Computations by Work Stealing, 1999, in that
 * who has none takes; halves of ranges instead of queues.
 *
 * SPDX-License-Identifier: MIT */
#ifndef SHARES_H
#define SHARES_H
#include <stdatomic.h>
#include <stdint.h>

enum { SHARES_MOST = 64 };

typedef struct shares {
    uint32_t run; /* items handed out at once; but for the last, they begin and end at multiples */
    unsigned count;
    atomic_uint_fast32_t end;               /* of what is handed out */
    atomic_uint_fast64_t left[SHARES_MOST]; /* first << 32 | end, items that nobody has taken */
} shares;

/* `items` for `count` workers (1 .. SHARES_MOST); run > 0. */
void shares_split(shares *s, uint32_t items, uint32_t run, unsigned count);

/* The next run of worker `who`: how many items, from *first on; 0: there are none left. */
uint32_t shares_take(shares *s, unsigned who, uint32_t *first);

/* Nothing from `item` on is handed out any more; what comes before still is. */
void shares_end(shares *s, uint32_t item);

#endif
