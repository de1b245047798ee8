/* scene - see scene.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/scene.h"

#include <inttypes.h>

#include "host_tools/app/phase.h"
#include "host_tools/pack/c_array.h"

static const char *const packets[] = {"2", "4", "8", "16", NULL};
static const char *const orders[] = {"depth", "two-stage", NULL};
static const char *const sources[] = {"map", "read", NULL};
static const char *const resident[] = {"resident", NULL};
static const char *const branch[] = {"branch", NULL};

/* Rules 1 and 2 of SPEC.md: too short for a header, or no header of ours. */
static const char *image_remedy(const plt_fault *fault) {
    const int foreign = fault->kind == 'R' && fault->rule <= 2;
    return foreign ? "is it one? planelet pack makes them from meshes" : "pack the scene again";
}

int scene_refused(fail *f, const char *path, int status, const plt_fault *fault,
                  size_t arena_bytes) {
    switch (status) {
    case PLT_ERR_ARENA:
        return fail_set(f, path, "needs an arena of %zu bytes and has %zu; use --arena %zu",
                        fault->need_bytes, arena_bytes, fault->need_bytes);
    case PLT_ERR_IMAGE:
        if (c_array_is(path)) {
            return fail_set(f, path,
                            "is a C array written by planelet pack; pack the meshes "
                            "with -o SCENE.plt to look at them");
        }
        return fail_set(f, path, "byte %" PRIu32 ": %s (%c%u); %s", fault->offset, fault->message,
                        fault->kind, (unsigned)fault->rule, image_remedy(fault));
    case PLT_ERR_SOURCE:
        return fail_set(f, path, "byte %" PRIu32 ": %s; is the file still whole?", fault->offset,
                        fault->message);
    case PLT_ERR_LIMIT:
        return fail_set(f, path, "%s; build with a larger one (engine/planelet_config.h)",
                        fault->message);
    default:
        return fail_set(f, path, "%s; see --help for the ranges", fault->message);
    }
}

static uint8_t read_packet(args *a) {
    const unsigned otherwise = PLT_PACKET_SIDE_MAX < 8 ? PLT_PACKET_SIDE_MAX / 4 : 2;
    const unsigned side = 2u << args_choice(a, "--packet", packets, otherwise);
    if (side > PLT_PACKET_SIDE_MAX) {
        args_complain(a, "--packet %u: this build has packets of up to %d", side,
                      PLT_PACKET_SIDE_MAX);
    }
    return (uint8_t)side;
}

static void read_flags(scene *s, args *a, int *fetched) {
    s->options.packet_side = read_packet(a);
    s->options.order = (uint8_t)args_choice(a, "--walk", orders, PLT_ORDER_DEPTH_FIRST);
    *fetched = args_choice(a, "--source", sources, 0) == 1;
    args_choice(a, "--residency", resident, 0);
    args_choice(a, "--schedule", branch, 0);
    args_number(a, "--workers", 1, 1, 1);
    s->arena_bytes = (size_t)args_number(a, "--arena", host_arena_bytes(), 1, host_arena_bytes());
}

int scene_attach(scene *s, args *a, const char *path, fail *f) {
    int fetched = 0;
    read_flags(s, a, &fetched);
    if (a->wrong) {
        return -1;
    }
    if (path[0] == '\0') {
        return fail_set(f, NULL, "the scene has no name; give the file that planelet pack wrote");
    }
    if ((fetched ? host_scene_fetch(&s->file, path) : host_scene_map(&s->file, path)) != 0) {
        return fail_set(f, path, "%s", s->file.why);
    }
    return 0;
}

int scene_start(scene *s, const char *path, plt_fault *fault) {
    phase_begin("opening", path);
    const int status = plt_open(&s->engine, host_arena(s->arena_bytes), s->arena_bytes,
                                &s->file.source, &s->options, fault);
    phase_end();
    return status;
}

int scene_open(scene *s, args *a, const char *path, fail *f) {
    plt_fault fault;
    if (scene_attach(s, a, path, f) != 0) {
        return -1;
    }
    const int status = scene_start(s, path, &fault);
    return status == PLT_OK ? 0 : scene_refused(f, path, status, &fault, s->arena_bytes);
}

void scene_close(scene *s) {
    host_scene_close(&s->file);
}

void scene_print_stats(output *o, const scene *s, double seconds, fail *f) {
    plt_stats q;
    plt_stats_get(s->engine, &q);
    output_print(o, f,
                 "  \"rays\": %" PRIu64
                 ",\n  \"seconds\": %.9f,\n  \"mrays_per_s\": %.3f,\n"
                 "  \"packets\": %" PRIu64 ",\n  \"mixed_packets\": %" PRIu64
                 ",\n"
                 "  \"node_visits\": %" PRIu64 ",\n  \"group_tests\": %" PRIu64
                 ",\n"
                 "  \"triangle_tests\": %" PRIu64 ",\n  \"treelet_fetches\": %" PRIu64
                 ",\n"
                 "  \"bytes_fetched\": %" PRIu64 ",\n  \"bytes_touched_once\": %" PRIu64
                 ",\n"
                 "  \"arena_bytes\": %zu,\n  \"arena_peak_bytes\": %zu",
                 q.rays, seconds, seconds > 0.0 ? (double)q.rays / seconds * 1e-6 : 0.0, q.packets,
                 q.mixed_packets, q.node_visits, q.group_tests, q.triangle_tests, q.treelet_fetches,
                 q.bytes_fetched, q.bytes_touched_once, s->arena_bytes, plt_arena_peak(s->engine));
}
