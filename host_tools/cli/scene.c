/* scene - see scene.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/scene.h"

#include <inttypes.h>

#include "host_tools/base/output.h"

static const char *const packets[] = {"2", "4", "8", "16", NULL};
static const char *const walks[] = {"depth", "two-stage", NULL};
static const char *const sources[] = {"map", "read", NULL};
static const char *const resident[] = {"resident", NULL};
static const char *const branch[] = {"branch", NULL};

static int say_fault(fail *f, const char *path, int status, const plt_fault *fault,
                     size_t arena_bytes) {
    switch (status) {
    case PLT_ERR_ARENA:
        return fail_set(f, path, "needs an arena of %zu bytes and has %zu; use --arena %zu",
                        fault->need_bytes, arena_bytes, fault->need_bytes);
    case PLT_ERR_IMAGE:
        return fail_set(f, path, "byte %" PRIu32 ": %s (%c%u); pack the scene anew", fault->offset,
                        fault->message, fault->kind, (unsigned)fault->rule);
    case PLT_ERR_SOURCE:
        return fail_set(f, path, "byte %" PRIu32 ": %s; is the file still whole?", fault->offset,
                        fault->message);
    case PLT_ERR_LIMIT:
        return fail_set(f, path, "%s; build with a larger one (engine/planelet_config.h)",
                        fault->message);
    default:
        return fail_set(f, path, "%s is out of range; see --help", fault->message);
    }
}

int scene_open(scene *s, args *a, const char *path, fail *f) {
    plt_options options = {0};
    plt_fault fault;
    s->engine = NULL;
    options.packet_side = (uint8_t)(2u << args_choice(a, "--packet", packets, 2));
    options.walk = (uint8_t)args_choice(a, "--walk", walks, PLT_WALK_DEPTH_FIRST);
    const int fetched = args_choice(a, "--source", sources, 0) == 1;
    args_choice(a, "--residency", resident, 0);
    args_choice(a, "--schedule", branch, 0);
    args_number(a, "--workers", 1, 1, 1);
    s->arena_bytes = (size_t)args_number(a, "--arena", host_arena_bytes(), 1, host_arena_bytes());
    if (a->wrong) {
        return -1;
    }
    if ((fetched ? host_scene_fetch(&s->file, path) : host_scene_map(&s->file, path)) != 0) {
        return fail_set(f, path, "%s", s->file.why);
    }
    const int status = plt_open(&s->engine, host_arena(s->arena_bytes), s->arena_bytes,
                                &s->file.source, &options, &fault);
    return status == PLT_OK ? 0 : say_fault(f, path, status, &fault, s->arena_bytes);
}

void scene_close(scene *s) {
    host_scene_close(&s->file);
}

void scene_print_stats(void *output_handle, const scene *s, double seconds, fail *f) {
    output *o = output_handle;
    plt_stats q;
    plt_stats_get(s->engine, &q);
    output_print(o, f,
                 "  \"rays\": %" PRIu64 ",\n  \"seconds\": %.6f,\n  \"mrays_per_s\": %.3f,\n"
                 "  \"packets\": %" PRIu64 ",\n  \"mixed_packets\": %" PRIu64 ",\n"
                 "  \"node_visits\": %" PRIu64 ",\n  \"group_tests\": %" PRIu64 ",\n"
                 "  \"triangle_tests\": %" PRIu64 ",\n  \"treelet_fetches\": %" PRIu64 ",\n"
                 "  \"bytes_fetched\": %" PRIu64 ",\n  \"bytes_touched_once\": %" PRIu64 ",\n"
                 "  \"arena_bytes\": %zu,\n  \"arena_peak_bytes\": %zu",
                 q.rays, seconds, seconds > 0.0 ? (double)q.rays / seconds * 1e-6 : 0.0, q.packets,
                 q.mixed_packets, q.node_visits, q.group_tests, q.triangle_tests,
                 q.treelet_fetches, q.bytes_fetched, q.bytes_touched_once, s->arena_bytes,
                 plt_arena_peak(s->engine));
}
