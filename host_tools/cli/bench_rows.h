/* bench_rows - what planelet bench has measured, a row for each kind of ray and mode
 *
 * SPDX-License-Identifier: MIT */
#ifndef BENCH_ROWS_H
#define BENCH_ROWS_H

#include "engine/planelet.h"
#include "host_tools/app/ray_kinds.h"
#include "host_tools/base/counters.h"
#include "host_tools/base/output.h"
#include "host_tools/baselines/base/structure_types.h"

/* Orders of packets, and the wave over the nodes of the image or over its wide form. */
enum bench_walk { BENCH_DEPTH, BENCH_TWO_STAGE, BENCH_WAVE, BENCH_WIDE, BENCH_WALKS };

typedef struct bench_row {
    /* What was traced. */
    const char *scene;
    const char *structure; /* as it was asked for; NULL: the engine */
    uint8_t nodes;         /* enum plt_nodes, of the engine, as is the walk */
    uint8_t walk;          /* enum bench_walk */
    uint8_t kind;          /* enum ray_kind */
    uint8_t any;
    uint8_t packet_side; /* 0: rays go one by one, or in a wave */
    uint32_t triangles, rays;
    /* What came of it. */
    uint64_t hits;              /* rays that hit something */
    uint64_t hash;              /* of all hits */
    double least, median, most; /* rays per second */
    uint64_t counted[COUNTERS]; /* of one pass; where it was not granted 0 */
    structure_statistics stats; /* of one pass */
    size_t arena_bytes;         /* needed; of the engine */
    double build_seconds;       /* of the processor; of other structures */
} bench_row;

typedef struct bench_rows {
    bench_row *row; /* owned */
    unsigned count, room;
} bench_rows;

extern const char *const bench_nodes_names[], *const bench_any_names[], *const bench_walk_names[];

/* A zero row behind the others; NULL when memory is out. */
bench_row *bench_rows_add(bench_rows *rows);
void bench_rows_free(bench_rows *rows);

/* The rows from `first` on as a table, kinds of rays one after the other; the column of nodes names
 * other structures, too. Of the rows that differ in their packets and walks alone, the one with the
 * best median has a star. */
int bench_rows_print(const bench_rows *rows, unsigned first, const counters *c, output *o, fail *f);

/* All rows as a list of JSON, with whole counts per pass and whole rays per second. */
int bench_rows_json(const bench_rows *rows, const counters *c, output *o, fail *f);

#endif
