/* bench_against - the engine and a structure of host_tools/baselines by turns, with the same rays
 *
 * A round traces all rays with the engine's packets, depth first, then with the structure. Times
 * are of the processor, the best of all rounds each; what other programs take away hits both alike,
 * and the median of the rounds' ratios says so again. Hits are compared bit for bit.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BENCH_AGAINST_H
#define BENCH_AGAINST_H

#include "host_tools/app/ray_kinds.h"
#include "host_tools/app/scene.h"
#include "host_tools/base/output.h"
#include "host_tools/cli/bench_list.h"

typedef struct against_row {
    const char *scene;
    char name[BENCH_NAME]; /* as it was given */
    uint8_t kind, any;     /* enum ray_kind */
    uint8_t packet_side;
    uint32_t triangles, rays;
    double engine_seconds, seconds, build_seconds;
    double ratio; /* median of the rounds: the structure's time over the engine's */
    structure_statistics engine, counts;
} against_row;

typedef struct against {
    bench_list list; /* empty: it was not asked for */
    unsigned kinds, hits, packets, repeat;
    against_row *row; /* owned */
    unsigned rows, room;
} against;

#define AGAINST_FLAG                                                                               \
    {                                                                                              \
        "--against", "LIST",                                                                       \
            "the engine's packets, depth first, against structures as listed below, with blanks "  \
            "between, by turns; nothing else is measured"                                          \
    }

/* Reads the flag, when what else chooses is set: complains of a structure that goes by none of the
 * packets that are asked for. */
void against_read(against *to, args *a);
void against_free(against *a);

/* Every structure with every packet, kind of ray and question, through an image that is attached.
 */
int against_measure(against *a, scene *s, const char *path, const ray_kinds *rays, fail *f);

/* Rows from `first` on as a table; all rows as a list of JSON. */
int against_print(const against *a, unsigned first, output *o, fail *f);
int against_json(const against *a, output *o, fail *f);

#endif
