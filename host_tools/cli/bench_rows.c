/* bench_rows - see bench_rows.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/bench_rows.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/app/json_string.h"

const char *const bench_nodes_names[] = {"thesis", "compact", NULL};
const char *const bench_any_names[] = {"closest", "any", NULL};
const char *const bench_walk_names[] = {"depth", "two-stage", "wave", "wide", NULL};

static const char *const counter_titles[COUNTERS] = {"instr", "cycles", "misses"};
static const char *const counter_keys[COUNTERS] = {"instructions", "cycles", "branch_misses"};

bench_row *bench_rows_add(bench_rows *rows) {
    if (rows->count == rows->room) {
        const unsigned room = 2 * rows->room + 64;
        bench_row *row = realloc(rows->row, room * sizeof *row);
        if (row == NULL) {
            return NULL;
        }
        rows->row = row;
        rows->room = room;
    }
    bench_row *added = &rows->row[rows->count++];
    memset(added, 0, sizeof *added);
    return added;
}

void bench_rows_free(bench_rows *rows) {
    free(rows->row);
    *rows = (bench_rows){NULL, 0, 0};
}

/* What the column of nodes has. */
static const char *nodes_of(const bench_row *r) {
    return r->structure != NULL ? r->structure : bench_nodes_names[r->nodes];
}

/* Of one scene, structure and question: they differ in packets and walks alone. */
static int is_alike(const bench_row *a, const bench_row *b) {
    return a->kind == b->kind && a->any == b->any && strcmp(nodes_of(a), nodes_of(b)) == 0;
}

static int is_best(const bench_rows *rows, unsigned first, const bench_row *row) {
    for (unsigned i = first; i < rows->count; i++) {
        if (is_alike(&rows->row[i], row) && rows->row[i].median > row->median) {
            return 0;
        }
    }
    return 1;
}

static int print_title(int width, output *o, const counters *c, fail *f) {
    output_print(o, f, "%-8s %-8s %-*s %-6s %-9s %8s  %7s %7s", "rays", "hits", width, "nodes",
                 "packet", "walk", "Mray/s", "least", "spread");
    for (int i = 0; i < COUNTERS; i++) {
        if (c->file[i] >= 0) {
            output_print(o, f, " %7s", counter_titles[i]);
        }
    }
    return output_print(o, f, " %7s %7s %7s\n", "visits", "groups", "tests");
}

/* Counts are per ray. */
static int print_row(const bench_row *r, int width, int best, output *o, const counters *c,
                     fail *f) {
    const double rays = (double)r->rays;
    char packet[8] = "-";
    if (r->packet_side > 0) {
        snprintf(packet, sizeof packet, "%ux%u", r->packet_side, r->packet_side);
    }
    output_print(o, f, "%-8s %-8s %-*s %-6s %-9s %8.3f%c %7.3f %5.1f %%", ray_kind_names[r->kind],
                 bench_any_names[r->any], width, nodes_of(r), packet,
                 r->structure != NULL ? "-" : bench_walk_names[r->walk], 1e-6 * r->median,
                 best ? '*' : ' ', 1e-6 * r->least, 100.0 * (r->most - r->least) / r->median);
    for (int i = 0; i < COUNTERS; i++) {
        if (c->file[i] >= 0) {
            output_print(o, f, i == COUNTER_BRANCH_MISSES ? " %7.2f" : " %7.0f",
                         (double)r->counted[i] / rays);
        }
    }
    return output_print(o, f, " %7.3f %7.3f %7.3f\n", (double)r->stats.node_visits / rays,
                        (double)r->stats.box_tests / rays, (double)r->stats.triangle_tests / rays);
}

int bench_rows_print(const bench_rows *rows, unsigned first, const counters *c, output *o,
                     fail *f) {
    int width = 8;
    for (unsigned i = first; i < rows->count; i++) {
        const int length = (int)strlen(nodes_of(&rows->row[i]));
        width = length > width ? length : width;
    }
    int status = print_title(width, o, c, f);
    for (unsigned kind = 0; kind < 2 * RAY_KINDS; kind++) {
        for (unsigned i = first; i < rows->count && status == 0; i++) {
            const bench_row *r = &rows->row[i];
            if (r->kind == kind / 2 && r->any == kind % 2) {
                status = print_row(r, width, is_best(rows, first, r), o, c, f);
            }
        }
    }
    return status;
}

static int json_row(const bench_row *r, output *o, const counters *c, fail *f) {
    output_print(o, f, "    {\"scene\": ");
    json_write_string(o, r->scene, f);
    output_print(o, f, ", \"triangles\": %" PRIu32 ", \"structure\": \"%s\"", r->triangles,
                 r->structure != NULL ? r->structure : "engine");
    if (r->structure == NULL) {
        output_print(o, f, ", \"nodes\": \"%s\"", bench_nodes_names[r->nodes]);
    }
    output_print(o, f, ", \"kind\": \"%s\", \"hit\": \"%s\", \"packet\": %u",
                 ray_kind_names[r->kind], bench_any_names[r->any], r->packet_side);
    if (r->structure == NULL) {
        output_print(o, f, ", \"walk\": \"%s\"", bench_walk_names[r->walk]);
    }
    output_print(
        o, f, ", \"rays\": %" PRIu32 ", \"hits\": %" PRIu64 ", \"hits_hash\": \"%016" PRIx64 "\"",
        r->rays, r->hits, r->hash);
    output_print(o, f,
                 ", \"least_rays_per_s\": %.0f, \"median_rays_per_s\": %.0f, "
                 "\"most_rays_per_s\": %.0f",
                 r->least, r->median, r->most);
    for (int i = 0; i < COUNTERS; i++) {
        if (c->file[i] >= 0) {
            output_print(o, f, ", \"%s\": %" PRIu64, counter_keys[i], r->counted[i]);
        }
    }
    output_print(o, f,
                 ", \"node_visits\": %" PRIu64 ", \"group_tests\": %" PRIu64
                 ", \"triangle_tests\": %" PRIu64 ", \"structure_bytes\": %" PRIu64,
                 r->stats.node_visits, r->stats.box_tests, r->stats.triangle_tests, r->stats.bytes);
    return r->structure != NULL
               ? output_print(o, f, ", \"build_seconds\": %.9f}", r->build_seconds)
               : output_print(o, f, ", \"arena_bytes_needed\": %zu}", r->arena_bytes);
}

int bench_rows_json(const bench_rows *rows, const counters *c, output *o, fail *f) {
    int status = output_print(o, f, "  \"rows\": [\n");
    for (unsigned i = 0; i < rows->count && status == 0; i++) {
        json_row(&rows->row[i], o, c, f);
        status = output_print(o, f, i + 1 < rows->count ? ",\n" : "\n");
    }
    return status == 0 ? output_print(o, f, "  ]") : -1;
}
