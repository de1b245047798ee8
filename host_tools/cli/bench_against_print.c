/* bench_against_print - see bench_against.h
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>

#include "host_tools/app/json_string.h"
#include "host_tools/cli/bench_against.h"

static double over(uint64_t part, uint64_t whole) {
    return whole > 0 ? (double)part / (double)whole : 0.0;
}

static double rate(uint32_t rays, double seconds) {
    return 1e-6 * rays / seconds;
}

/* Per packet of as many rays, whether or not it is traced as one. */
static double per_packet(const against_row *r, uint64_t count) {
    return over(count * r->packet_side * r->packet_side, r->rays);
}

static int print_row(const against_row *r, output *o, fail *f) {
    const structure_statistics *s = &r->counts;
    output_print(o, f, "%-8s %-7s %2ux%-2u %-24s %7.2f %7.2f %6.2f %6.2f", ray_kind_names[r->kind],
                 r->any ? "any" : "closest", r->packet_side, r->packet_side, r->name,
                 rate(r->rays, r->engine_seconds), rate(r->rays, r->seconds),
                 r->seconds / r->engine_seconds, r->ratio);
    return output_print(o, f, " %7.1f %7.1f %7.3f %7.3f %5.1f %5.1f\n",
                        per_packet(r, r->engine.node_visits), per_packet(r, s->node_visits),
                        over(r->engine.triangle_tests, r->rays), over(s->triangle_tests, r->rays),
                        over(r->engine.bytes, r->triangles), over(s->bytes, r->triangles));
}

int against_print(const against *a, unsigned first, output *o, fail *f) {
    int status =
        output_print(o, f, "%-8s %-7s %-5s %-24s %7s %7s %6s %6s %7s %7s %7s %7s %5s %5s\n", "rays",
                     "hits", "side", "engine against", "Mray/s", "its", "ratio", "median", "visits",
                     "its", "tests", "its", "B/tri", "its");
    for (unsigned i = first; i < a->rows && status == 0; i++) {
        status = print_row(&a->row[i], o, f);
    }
    return status;
}

static int json_row(const against_row *r, output *o, fail *f) {
    const structure_statistics *s = &r->counts;
    output_print(o, f, "    {\"scene\": ");
    json_write_string(o, r->scene, f);
    output_print(o, f,
                 ", \"triangles\": %" PRIu32
                 ", \"against\": \"%s\", \"kind\": \"%s\", \"hit\": \"%s\", \"packet\": %u, "
                 "\"rays\": %" PRIu32
                 ", \"engine_seconds\": %.9f, \"seconds\": %.9f, "
                 "\"ratio\": %.4f, \"ratio_median\": %.4f, \"build_seconds\": %.9f",
                 r->triangles, r->name, ray_kind_names[r->kind], r->any ? "any" : "closest",
                 r->packet_side, r->rays, r->engine_seconds, r->seconds,
                 r->seconds / r->engine_seconds, r->ratio, r->build_seconds);
    output_print(o, f,
                 ", \"engine_node_visits\": %" PRIu64 ", \"engine_group_tests\": %" PRIu64
                 ", \"engine_triangle_tests\": %" PRIu64 ", \"engine_node_bytes\": %" PRIu64,
                 r->engine.node_visits, r->engine.box_tests, r->engine.triangle_tests,
                 r->engine.bytes);
    return output_print(o, f,
                        ", \"node_visits\": %" PRIu64 ", \"box_tests\": %" PRIu64
                        ", \"triangle_tests\": %" PRIu64
                        ", \"packet_triangle_intersections\": %" PRIu64 ", \"early_hits\": %" PRIu64
                        ", \"frustum_misses\": %" PRIu64 ", \"structure_bytes\": %" PRIu64
                        ", \"thesis_bytes\": %" PRIu64 "}",
                        s->node_visits, s->box_tests, s->triangle_tests, s->packet_triangles,
                        s->early_hits, s->frustum_misses, s->bytes, s->thesis_bytes);
}

int against_json(const against *a, output *o, fail *f) {
    int status = output_print(o, f, "  \"against\": [\n");
    for (unsigned i = 0; i < a->rows && status == 0; i++) {
        json_row(&a->row[i], o, f);
        status = output_print(o, f, i + 1 < a->rows ? ",\n" : "\n");
    }
    return status == 0 ? output_print(o, f, "  ]") : -1;
}
