/* cmd_trace - planelet trace: a ray file to a hit file
 *
 * Ray file: 32 bytes per ray, little-endian float32: org[3] tmin dir[3] tmax.
 * Hit file: 16 bytes per ray: t u v and the primitive id.
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "engine/base/bytes.h"
#include "host_tools/app/crew_tasks.h"
#include "host_tools/app/destination.h"
#include "host_tools/app/note.h"
#include "host_tools/app/ray_order.h"
#include "host_tools/app/scene.h"
#include "host_tools/base/input.h"
#include "host_tools/base/output.h"
#include "host_tools/base/progress.h"
#include "host_tools/cli/baseline.h"
#include "host_tools/cli/commands.h"

enum { RAY_BYTES = 32, HIT_BYTES = 16 };
/* That a worker takes at once: whole numbers of packets of every size. */
enum { RUN_SHARED = 1024, RUN_ALONE = 65536 };

static const arg_flag flags[] = {
    {"--any", NULL, "whether anything is hit, instead of the nearest hit"},
    {"--rays", "auto|coherent|incoherent",
     "in packets if neighbours point alike, one by one in a wave if not, or as the rays look; "
     "hits are the same (default auto)"},
    {"--order", "file|sorted",
     "rays are traced as they come, or sorted by where they begin and point, so that neighbours "
     "meet the same parts of the scene; hits are written as the rays came (default file)"},
    {"--baseline", "kd|kd-boxes|kd-fast|kd-lazy",
     "through a kd-tree of the scene's triangles instead, one by one: of their parts by the "
     "surface "
     "area heuristic, of their boxes, of boxes by samples of the heuristic, or that as rays come; "
     "hits are the same"},
    {"--repeat", "N",
     "trace N times, report the best time, and counts of the last; 1 to 1000000 (default 1)"},
    {"--json", "STATS",
     "write statistics, for which the arena is a bit larger; - is standard output"},
    SCENE_FLAGS,
    SCENE_WORKERS_FLAGS,
    {NULL, NULL, NULL}};

const arg_command command_trace = {
    .name = "trace",
    .synopsis = "SCENE.plt RAYS HITS",
    .about =
        "Traces a file of rays (org[3] tmin dir[3] tmax, 8 little-endian floats each) and writes a "
        "hit for each: floats t u v and the primitive id; 4294967295 is a miss. The id is "
        "1 or 0 with --any. SCENE.plt or RAYS may be - for standard input, HITS for standard "
        "output.",
    .flags = flags,
    .files_least = 3,
    .files_most = 3};

static const char *const orders[] = {"file", "sorted", NULL};
static const char *const kinds[] = {"auto", "coherent", "incoherent", NULL};

/* Where the arena has room for it, rays that are not coherent go by a wave. */
enum { RAYS_IN_FLIGHT = 32 };

typedef struct tracing {
    scene s;
    output *hits_out, *stats_out;
    plt_ray *rays;
    plt_hit *hits;
    uint32_t count;
    int any;
    uint32_t *order; /* ray i is number order[i] of the file; NULL: number i */
    crew_times took; /* of the best run */
    int baseline;    /* place in baseline_names; below 0: the engine traces */
    baseline built;
} tracing;

/* Decodes the little-endian rays into floats of this machine. */
static int decode_rays(tracing *t, const input *in, const char *name, fail *f) {
    if (in->size % RAY_BYTES != 0) {
        return fail_set(f, name,
                        "byte %zu: the last ray is cut short (a ray has 32 bytes); write it again",
                        in->size - in->size % RAY_BYTES);
    }
    if (in->size / RAY_BYTES > UINT32_MAX) {
        return fail_set(f, name, "more than 2^32 - 1 rays; split the file");
    }
    t->count = (uint32_t)(in->size / RAY_BYTES);
    t->rays = malloc(in->size);
    t->hits = malloc((size_t)t->count * sizeof *t->hits);
    if (t->rays == NULL || t->hits == NULL) {
        return fail_set(f, name, "out of memory for %" PRIu32 " rays; split the file", t->count);
    }
    for (uint32_t i = 0; i < t->count; i++) {
        plt_get_floats(t->rays[i].org, in->bytes + RAY_BYTES * (size_t)i, 8);
    }
    return 0;
}

static int read_rays(tracing *t, const char *path, fail *f) {
    input in;
    if (input_read(&in, path, f) != 0) {
        return -1;
    }
    const int status = decode_rays(t, &in, strcmp(path, "-") == 0 ? "standard input" : path, f);
    input_free(&in);
    return status;
}

/* Sorts the rays, and keeps where each was. */
static int sort_rays(tracing *t, const char *name, fail *f) {
    plt_ray *sorted = malloc((size_t)t->count * sizeof *sorted + 1);
    t->order = malloc((size_t)t->count * sizeof *t->order + 1);
    if (sorted == NULL || t->order == NULL || ray_order_sort(t->rays, t->count, t->order) != 0) {
        free(sorted);
        return fail_set(f, name, "out of memory to sort %" PRIu32 " rays; leave out --order sorted",
                        t->count);
    }
    for (uint32_t i = 0; i < t->count; i++) {
        sorted[i] = t->rays[t->order[i]];
    }
    free(t->rays);
    t->rays = sorted;
    return 0;
}

/* Hits in the order of the file; the rays are not needed any more. */
static void unsort_hits(tracing *t) {
    plt_hit *hits = (plt_hit *)(void *)t->rays; /* a ray is larger than a hit */
    for (uint32_t i = 0; i < t->count; i++) {
        hits[t->order[i]] = t->hits[i];
    }
    memcpy(t->hits, hits, (size_t)t->count * sizeof *hits);
}

/* Whole batches, where there are any. */
static uint32_t rays_per_run(const scene *s) {
    const uint32_t side = plt_packet_side(s->engine);
    const uint32_t batch = plt_batch_packets(s->engine) * side * side;
    const uint32_t run = s->crew.count > 1 ? RUN_SHARED : RUN_ALONE;
    return batch > 0 ? (run + batch - 1) / batch * batch : run;
}

static int trace_rays(void *context, crew_worker *w, uint32_t first, uint32_t count) {
    const tracing *t = context;
    const int status = plt_trace(w->engine, t->rays + first, t->hits + first, count, t->any);
    crew_done(w, count);
    return status;
}

static int trace_by_tasks(tracing *t, const crew_work *work, crew_times *took) {
    const crew_tasks tasks = {.bar = work->bar, .before = work->before, .items = t->count};
    const int status = plt_trace_begin(t->s.engine, t->rays, t->hits, t->count, t->any);
    return status == PLT_OK ? crew_do_tasks(&t->s.crew, &tasks, took) : status;
}

static int trace_all(tracing *t, const char *path, unsigned repeat, fail *f) {
    progress bar;
    if (t->built.s != NULL) {
        const int done = baseline_trace(&t->built, t->rays, t->hits, t->count, t->any, repeat, f);
        t->took.seconds = t->built.seconds;
        return done;
    }
    int status = PLT_OK;
    crew_work work = {.items = t->count,
                      .run = rays_per_run(&t->s),
                      .work = trace_rays,
                      .context = t,
                      .bar = &bar};
    progress_begin(&bar, "tracing", (uint64_t)repeat * t->count);
    for (unsigned i = 0; i < repeat && status == PLT_OK; i++) {
        crew_times took = {.seconds = 0.0};
        scene_reset_stats(&t->s);
        status = t->s.options.schedule == PLT_SCHEDULE_TASK ? trace_by_tasks(t, &work, &took)
                                                            : crew_do(&t->s.crew, &work, &took);
        crew_times_keep(&t->took, &took, i == 0);
        work.before += t->count;
    }
    progress_end(&bar);
    return status == PLT_OK ? 0 : scene_failed(&t->s, path, status, f);
}

static int write_hits(const tracing *t, output *o, fail *f) {
    for (uint32_t i = 0; i < t->count; i++) {
        unsigned char bytes[HIT_BYTES];
        const float tuv[3] = {t->hits[i].t, t->hits[i].u, t->hits[i].v};
        plt_put_floats(bytes, tuv, 3);
        plt_put_u32(bytes + 12, t->hits[i].triangle);
        if (output_write(o, bytes, sizeof bytes, f) != 0) {
            return -1;
        }
    }
    return 0;
}

static int write_stats(const tracing *t, output *o, fail *f) {
    if (t->built.s != NULL) {
        return baseline_print(&t->built, o, f);
    }
    output_print(o, f, "{\n");
    scene_print_stats(o, &t->s, &t->took, f);
    return output_print(o, f, "\n}\n");
}

/* The rays before the arena, which is as large as there is room for. Both outputs are opened
 * first: a path that cannot be written fails before the long run. */
static int open_all(tracing *t, args *a, const char *json, int sorts, fail *f) {
    plt_fault fault;
    const char *rays = strcmp(a->file[1], "-") == 0 ? "standard input" : a->file[1];
    if (scene_attach(&t->s, a, a->file[0], f) != 0 || read_rays(t, a->file[1], f) != 0 ||
        (sorts && sort_rays(t, rays, f) != 0)) {
        return -1;
    }
    const int status = scene_start(&t->s, a->file[0], &fault);
    if (status != PLT_OK) {
        return scene_refused(&t->s, a->file[0], status, &fault, f);
    }
    t->hits_out = output_open(a->file[2], f);
    if (t->hits_out == NULL ||
        (t->baseline >= 0 && baseline_open(&t->built, (unsigned)t->baseline, t->s.engine,
                                           scene_name(a->file[0]), f) != 0)) {
        return -1;
    }
    t->stats_out = json == NULL ? NULL : output_open_text(json, f);
    return json != NULL && t->stats_out == NULL ? -1 : 0;
}

static int write_all(tracing *t, fail *f) {
    if (t->order != NULL) {
        unsort_hits(t);
    }
    if (write_hits(t, t->hits_out, f) != 0 ||
        (t->stats_out != NULL &&
         (write_stats(t, t->stats_out, f) != 0 || output_finish(t->stats_out, f) != 0))) {
        return -1;
    }
    const int hits = output_commit(t->hits_out, f);
    t->hits_out = NULL;
    if (hits != 0 || t->stats_out == NULL) {
        return hits;
    }
    const int stats = output_commit(t->stats_out, f);
    t->stats_out = NULL;
    return stats;
}

static void close_all(tracing *t) {
    output_abandon(t->hits_out);
    output_abandon(t->stats_out);
    baseline_close(&t->built);
    scene_close(&t->s);
    free(t->rays);
    free(t->hits);
    free(t->order);
}

/* Below 0: the engine traces. */
static int read_baseline(args *a) {
    static const char *const others[] = {"--packet",    "--walk",    "--structure", "--rays",
                                         "--residency", "--workers", "--turns",     NULL};
    if (!args_has(a, "--baseline")) {
        return -1;
    }
    for (unsigned i = 0; others[i] != NULL; i++) {
        if (args_has(a, others[i])) {
            args_complain(a, "%s is for the engine; leave it or --baseline out", others[i]);
        }
    }
    return (int)args_choice(a, "--baseline", baseline_names, 0);
}

int run_trace(args *a) {
    const unsigned repeat = (unsigned)args_number(a, "--repeat", 1, 1, 1000000);
    const char *json = args_text(a, "--json", NULL);
    const int sorts = args_choice(a, "--order", orders, 0) == 1;
    destination_differ(a, "HITS and --json", a->file[2], json);
    if (strcmp(a->file[0], "-") == 0 && strcmp(a->file[1], "-") == 0) {
        args_complain(a, "SCENE.plt and RAYS are not both on standard input; name a file");
    }
    tracing t = {.s = SCENE_CLOSED, .baseline = read_baseline(a)};
    t.s.options.count_touched = json != NULL;
    t.s.options.rays = (uint8_t)args_choice(a, "--rays", kinds, PLT_RAYS_AUTO);
    if (t.s.options.rays != PLT_RAYS_COHERENT && t.baseline < 0) {
        t.s.options.rays_in_flight = RAYS_IN_FLIGHT;
        t.s.options.wide = 1;
    }
    fail f = {""};
    int status = a->wrong ? -1 : open_all(&t, a, json, sorts, &f);
    if (status == 0) {
        t.any = args_has(a, "--any");
        status = trace_all(&t, a->file[0], repeat, &f);
    }
    status = status == 0 ? write_all(&t, &f) : status;
    close_all(&t);
    if (a->wrong) {
        return 2;
    }
    if (status != 0) {
        fprintf(stderr, "%s\n", f.text);
        return 1;
    }
    note("%s: %" PRIu32 " ray%s, %.3g s", a->file[2], t.count, t.count == 1 ? "" : "s",
         t.took.seconds);
    return 0;
}
