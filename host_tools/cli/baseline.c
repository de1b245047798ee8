/* baseline - see baseline.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/baseline.h"

#include <inttypes.h>
#include <string.h>

#include "engine/engine.h"
#include "host_tools/base/clock.h"
#include "host_tools/base/progress.h"

enum { RUN = 16384 }; /* rays between two looks at the clock of the progress */

void baseline_print_notes(FILE *to) {
    fprintf(to, "NAME of --baseline, and its switches, of those joined by | one at most:\n");
    structure_print_kinds(to);
}

void baseline_read(baseline *b, args *a, const char *const *others) {
    fail f = {""};
    if (!args_has(a, "--baseline")) {
        return;
    }
    for (unsigned i = 0; others[i] != NULL; i++) {
        if (args_has(a, others[i])) {
            args_complain(a, "%s is for the engine; leave it or --baseline out", others[i]);
        }
    }
    b->kind = structure_read(args_text(a, "--baseline", ""), "--baseline", &b->options, &f);
    if (b->kind == NULL) {
        args_complain(a, "%s", f.text);
    }
}

const plt_record *baseline_records(const plt_scene *scene) {
    return scene->format == PLT_FORMAT_THESIS ? scene->thesis.records
           : scene->format == PLT_FORMAT_LIST ? scene->list.records
                                              : NULL;
}

enum { UNSET = 0xFF }; /* bytes of a vertex that no triangle has */

/* Corners as they were packed, each triangle with its own. -1: two have the same id, which only a
 * forged image says, and another one none. */
static int fill_mesh(mesh *m, const plt_record *records, uint32_t count) {
    memset(m->triangle, UNSET, 3 * (size_t)count * sizeof *m->triangle);
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t word = plt_get_u32(&records[i].word[9]), id = plt_primitive_id(word);
        float corner[3][3];
        if (m->triangle[3 * (size_t)id] == 3 * id) {
            return -1;
        }
        plt_record_corners(&records[i], corner);
        for (uint32_t c = 0; c < 3; c++) {
            const uint32_t from = (plt_primitive_rotation(word) + c) % 3;
            memcpy(m->vertex + 9 * (size_t)id + 3 * c, corner[from], sizeof corner[from]);
            m->triangle[3 * (size_t)id + c] = 3 * id + c;
        }
    }
    m->triangles = count;
    m->vertices = 3 * (size_t)count;
    return 0;
}

int baseline_open(baseline *b, const plt_engine *engine, const char *name, fail *f) {
    const plt_scene *scene = &engine->scene;
    const plt_record *records = baseline_records(scene);
    mesh m = {0};
    if (scene->info.instances > 0) {
        return fail_set(f, name, "baselines are for one mesh; pack it without --instances");
    }
    if (records == NULL && scene->info.triangles > 0) {
        return fail_set(f, name, "baselines are for float triangles; pack it with --nodes thesis");
    }
    int status = mesh_reserve(&m, 3 * (size_t)scene->info.triangles, scene->info.triangles, f);
    if (status == 0 && fill_mesh(&m, records, scene->info.triangles) != 0) {
        status = fail_set(f, name, "two triangles have the same id; pack it again");
    }
    if (status == 0) {
        const double began = clock_processor_seconds();
        b->s = structure_open(b->kind, &m, &b->options, name, f);
        b->build_seconds = clock_processor_seconds() - began;
    }
    mesh_free(&m);
    return b->s != NULL ? 0 : -1;
}

void baseline_close(baseline *b) {
    structure_close(b->s);
    b->s = NULL;
}

int baseline_trace(baseline *b, const plt_ray *rays, plt_hit *hits, uint32_t count, int any,
                   unsigned repeat, fail *f) {
    progress bar;
    int status = 0;
    b->rays = count;
    progress_begin(&bar, "tracing", (uint64_t)repeat * count);
    for (unsigned i = 0; i < repeat && status == 0; i++) {
        double seconds = 0.0;
        structure_forget(b->s);
        for (uint32_t at = 0; at < count && status == 0; at += RUN) {
            const uint32_t left = count - at, now = left < RUN ? left : RUN;
            const double began = clock_processor_seconds();
            status = structure_trace(b->s, rays + at, hits + at, now, any, f);
            seconds += clock_processor_seconds() - began;
            progress_show(&bar, (uint64_t)i * count + at);
        }
        b->seconds = i == 0 || seconds < b->seconds ? seconds : b->seconds;
    }
    progress_end(&bar);
    return status;
}

static double share(uint64_t part, uint64_t whole) {
    return whole > 0 ? (double)part / (double)whole : 0.0;
}

int baseline_print_intersections(const structure_statistics *s, output *o, fail *f) {
    output_print(o, f,
                 "  \"packet_node_intersections\": %" PRIu64
                 ",\n  \"packet_triangle_intersections\": %" PRIu64 ",\n",
                 s->packet_nodes, s->packet_triangles);
    output_print(o, f,
                 "  \"nodes_per_packet\": %.6f,\n  \"triangles_per_packet\": %.6f,\n"
                 "  \"nodes_per_ray\": %.6f,\n  \"triangles_per_ray\": %.6f,\n",
                 share(s->packet_nodes, s->packets), share(s->packet_triangles, s->packets),
                 share(s->packet_nodes, s->rays), share(s->packet_triangles, s->rays));
    return output_print(o, f,
                        "  \"masked_out_at_nodes\": %.6f,\n  \"masked_out_at_triangles\": %.6f,\n"
                        "  \"masked_out\": %.6f",
                        share(s->masked_at_nodes, s->rays_at_nodes),
                        share(s->masked_at_triangles, s->rays_at_triangles),
                        share(s->masked_at_nodes + s->masked_at_triangles,
                              s->rays_at_nodes + s->rays_at_triangles));
}

static void print_packets(const structure_statistics *s, output *o, fail *f) {
    output_print(o, f, "  \"packets\": %" PRIu64 ",\n  \"one_sign_packets\": %" PRIu64 ",\n",
                 s->packets, s->one_sign);
    baseline_print_intersections(s, o, f);
    output_print(o, f, ",\n  \"early_hits\": %" PRIu64 ",\n  \"frustum_misses\": %" PRIu64 ",\n",
                 s->early_hits, s->frustum_misses);
}

/* What its switches save, or take. */
static void print_bph(const structure_statistics *s, output *o, fail *f) {
    output_print(o, f,
                 "  \"early_tests\": %" PRIu64 ",\n  \"frustum_tests\": %" PRIu64
                 ",\n  \"reconstructions\": %" PRIu64 ",\n  \"recomputed_boxes\": %" PRIu64
                 ",\n  \"plane_matches\": %" PRIu64 ",\n  \"intermediates\": %" PRIu32 ",\n",
                 s->early_tests, s->frustum_tests, s->reconstructions, s->recomputed,
                 s->plane_matches, s->intermediates);
}

int baseline_print_counts(const baseline *b, output *o, fail *f) {
    const structure_statistics s = structure_count(b->s);
    output_print(o, f, "  \"structure\": \"%s\",\n  \"build_seconds\": %.9f,\n",
                 structure_name(b->kind), b->build_seconds);
    output_print(o, f,
                 "  \"node_visits\": %" PRIu64 ",\n  \"plane_tests\": %" PRIu64
                 ",\n  \"triangle_tests\": %" PRIu64 ",\n  \"strays_sieved\": %" PRIu64
                 ",\n  \"build_work\": %" PRIu64 ",\n",
                 s.node_visits, s.box_tests, s.triangle_tests, s.sieved, s.build_work);
    if (s.packets > 0) {
        print_packets(&s, o, f);
    }
    if (s.plane_matches > 0) {
        print_bph(&s, o, f);
    }
    return output_print(o, f,
                        "  \"nodes\": %" PRIu32 ",\n  \"leaves\": %" PRIu32
                        ",\n  \"unsplit\": %" PRIu32 ",\n  \"references\": %" PRIu32
                        ",\n  \"strays\": %" PRIu32 ",\n  \"structure_bytes\": %" PRIu64
                        ",\n  \"thesis_bytes\": %" PRIu64 ",\n  \"triangle_bytes\": %" PRIu64,
                        s.nodes, s.leaves, s.unsplit, s.references, s.strays, s.bytes,
                        s.thesis_bytes, s.triangle_bytes);
}

void baseline_print_rays(output *o, uint64_t rays, double seconds, fail *f) {
    const double at_least = seconds > 1e-9 ? seconds : 1e-9;
    output_print(o, f, "  \"rays\": %" PRIu64 ",\n  \"seconds\": %.9f,\n  \"mrays_per_s\": %.3f,\n",
                 rays, seconds, 1e-6 * (double)rays / at_least);
}

int baseline_print(const baseline *b, output *o, fail *f) {
    output_print(o, f, "{\n");
    baseline_print_rays(o, b->rays, b->seconds, f);
    baseline_print_counts(b, o, f);
    return output_print(o, f, "\n}\n");
}
