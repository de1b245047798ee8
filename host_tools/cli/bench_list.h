/* bench_list - structures that bench is asked for by a flag, and the packets that each has
 *
 * SPDX-License-Identifier: MIT */
#ifndef BENCH_LIST_H
#define BENCH_LIST_H

#include "host_tools/app/args.h"
#include "host_tools/baselines/structure.h"

enum { BENCH_LIST_MOST = 16, BENCH_NAME = 96, BENCH_SIDES = 4 };

/* One of them. */
typedef struct bench_wanted {
    char name[BENCH_NAME]; /* as it was given */
    const structure_kind *kind;
    structure_options options;
    int has_side; /* a switch says it; of packet_side 0 then rays go one by one */
} bench_wanted;

typedef struct bench_list {
    bench_wanted wanted[BENCH_LIST_MOST];
    unsigned count;
    int has_engine; /* its own word, "engine", was there, where it may be */
} bench_list;

/* Reads a flag that is given: names of structure.h with blanks between, and, where `takes_engine`,
 * the word for the engine's own rows. */
void bench_list_read(bench_list *to, args *a, const char *flag, int takes_engine);

/* What it is opened with for packets of `side`, 0: rays one by one; 0: it has no such packets. */
int bench_wanted_has(const bench_wanted *w, unsigned side);
structure_options bench_wanted_options(const bench_wanted *w, unsigned side);

/* Complains of a structure that has none of the packets of `packets`, a bit for 2x2, 4x4, 8x8 and
 * 16x16; rays one by one are beside packets of `single`, or, if that is 0, have no need of any. */
void bench_list_check(const bench_list *of, args *a, const char *flag, unsigned packets,
                      unsigned single);

#endif
