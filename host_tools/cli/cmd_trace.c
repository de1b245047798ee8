/* cmd_trace - planelet trace: a ray file to a hit file
 *
 * Of a scene in motion the hits of each frame are a file of their own.
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/app/crew_tasks.h"
#include "host_tools/app/destination.h"
#include "host_tools/app/frame_times.h"
#include "host_tools/app/moved.h"
#include "host_tools/app/note.h"
#include "host_tools/app/played.h"
#include "host_tools/app/ray_file.h"
#include "host_tools/app/rebuilds.h"
#include "host_tools/app/scene.h"
#include "host_tools/base/output.h"
#include "host_tools/base/progress.h"
#include "host_tools/cli/baseline.h"
#include "host_tools/cli/commands.h"
#include "host_tools/cli/counted.h"

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
    BASELINE_FLAG,
    MOVED_FLAGS,
    REBUILDS_FLAGS,
    {"--repeat", "N",
     "trace all that N times, report the best time, and counts of the last; 1 to 1000000 (default "
     "1)"},
    {"--json", "STATS",
     "write statistics, for which the arena is a bit larger; - is standard output"},
    COUNTED_FLAG,
    SCENE_FLAGS,
    SCENE_WORKERS_FLAGS,
    {NULL, NULL, NULL}};

_Static_assert(sizeof flags / sizeof *flags - 1 <= ARGS_FLAGS_MAX, "each flag has a value");

const arg_command command_trace = {
    .name = "trace",
    .synopsis = "SCENE.plt RAYS HITS",
    .about =
        "Traces a file of rays (org[3] tmin dir[3] tmax, 8 little-endian floats each) and writes a "
        "hit for each: floats t u v and the primitive id; 4294967295 is a miss. The id is "
        "1 or 0 with --any. SCENE.plt or RAYS may be - for standard input, HITS for standard "
        "output. With --moved or --frames a '{}' in RAYS and HITS is the frame's number, 000, 001 "
        "..., and each frame's hits are a file.",
    .flags = flags,
    .files_least = 3,
    .files_most = 3,
    .print_notes = baseline_print_notes};

static const char *const orders[] = {"file", "sorted", NULL};
static const char *const kinds[] = {"auto", "coherent", "incoherent", NULL};

/* Where the arena has room for it, rays that are not coherent go by a wave. */
enum { RAYS_IN_FLIGHT = 32 };

typedef struct tracing {
    scene s;
    const char *scene_path, *rays_path, *hits_path;
    ray_file file;
    int sorts, any;
    unsigned repeat;
    moved moved;
    rebuilds rebuilds;
    output *hits_out; /* NULL: each frame has its own */
    output *stats_out;
    uint64_t traced; /* rays of a run */
    frame_times times;
    crew_times took; /* of the best run */
    baseline built;
    counted counted;
} tracing;

/* A frame's own: of the '{}' in the name. */
static int is_numbered(const tracing *t, const char *path) {
    return moved_is(&t->moved) && frame_range_is_pattern(path);
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
    const int status =
        plt_trace(w->engine, t->file.rays + first, t->file.hits + first, count, t->any);
    crew_done(w, count);
    return status;
}

static int trace_by_tasks(tracing *t, const crew_work *work, crew_times *took) {
    const crew_tasks tasks = {.bar = work->bar, .before = work->before, .items = t->file.count};
    const int status =
        plt_trace_begin(t->s.engine, t->file.rays, t->file.hits, t->file.count, t->any);
    return status == PLT_OK ? crew_do_tasks(&t->s.crew, &tasks, took) : status;
}

/* The rays of the file once, of which `before` shifts of as many were. */
static int trace_file(tracing *t, progress *bar, uint64_t before, crew_times *took, fail *f) {
    const crew_work work = {.items = t->file.count,
                            .run = rays_per_run(&t->s),
                            .work = trace_rays,
                            .context = t,
                            .bar = bar,
                            .before = before * t->file.count};
    const int status = t->s.options.schedule == PLT_SCHEDULE_TASK
                           ? trace_by_tasks(t, &work, took)
                           : crew_do(&t->s.crew, &work, took);
    return status == PLT_OK ? 0 : scene_failed(&t->s, t->scene_path, status, f);
}

/* Rays that are the same for all frames have been read. */
static int read_rays(tracing *t, unsigned number, fail *f) {
    char *name = frame_range_file(t->rays_path, number);
    const int status = name == NULL
                           ? fail_set(f, t->rays_path, "out of memory; close other programs")
                           : ray_file_read(&t->file, name, t->sorts, f);
    free(name);
    return status;
}

/* Into a file of frame `number`. */
static int write_frame(const tracing *t, unsigned number, fail *f) {
    char *name = frame_range_file(t->hits_path, number);
    if (name == NULL) {
        return fail_set(f, t->hits_path, "out of memory; close other programs");
    }
    output *o = output_open(name, f);
    free(name);
    if (o == NULL || ray_file_write_hits(&t->file, o, f) != 0) {
        output_abandon(o);
        return -1;
    }
    return output_commit(o, f);
}

/* `index`: of the frame; of a scene that does not move there is one. */
static int trace_frame(tracing *t, progress *bar, unsigned run, unsigned index, crew_times *took,
                       fail *f) {
    const unsigned number = t->moved.range.first + index;
    if (is_numbered(t, t->rays_path) && (run > 0 || index > 0) && read_rays(t, number, f) != 0) {
        return -1;
    }
    if (moved_is(&t->moved)) {
        if (moved_to(&t->moved, &t->s, t->scene_path, index, f) != 0) {
            return -1;
        }
        rebuilds_go_on(&t->rebuilds, &t->s);
    }
    if (trace_file(t, bar, (uint64_t)run * t->moved.range.count + index, took, f) != 0) {
        return -1;
    }
    if (t->counted.engine != NULL && run + 1 == t->repeat &&
        counted_rays(&t->counted, t->file.rays, t->file.hits, t->file.count, t->any, f) != 0) {
        return -1;
    }
    t->traced += run == 0 ? t->file.count : 0;
    return run == 0 && t->hits_out == NULL ? write_frame(t, number, f) : 0;
}

static frame_time time_so_far(const tracing *t, const crew_times *took) {
    return (frame_time){t->moved.move_seconds, t->rebuilds.seconds, took->seconds};
}

static int trace_baseline(tracing *t, fail *f) {
    ray_file *file = &t->file;
    const int done =
        baseline_trace(&t->built, file->rays, file->hits, file->count, t->any, t->repeat, f);
    t->took.seconds = t->built.seconds;
    t->traced = file->count;
    return done;
}

static int trace_all(tracing *t, fail *f) {
    progress bar;
    int status = 0;
    progress_begin(&bar, "tracing", (uint64_t)t->repeat * t->moved.range.count * t->file.count);
    for (unsigned run = 0; run < t->repeat && status == 0; run++) {
        crew_times took = {.seconds = 0.0};
        scene_reset_stats(&t->s);
        for (unsigned i = 0; i < t->moved.range.count && status == 0; i++) {
            const frame_time before = time_so_far(t, &took);
            status = trace_frame(t, &bar, run, i, &took, f);
            const frame_time behind = time_so_far(t, &took);
            frame_times_keep(&t->times, i, &before, &behind, run == 0);
        }
        crew_times_keep(&t->took, &took, run == 0);
    }
    progress_end(&bar);
    return status;
}

static int write_stats(const tracing *t, output *o, fail *f) {
    if (t->built.s != NULL) {
        return baseline_print(&t->built, o, f);
    }
    output_print(o, f, "{\n");
    if (moved_is(&t->moved)) {
        output_print(o, f, "  \"frames\": %u,\n", t->moved.range.count);
        moved_print(o, &t->moved, t->repeat, f);
        frame_times_print(o, &t->times, 1, f);
        rebuilds_print(o, &t->rebuilds, &t->s, t->repeat, f);
    }
    scene_print_stats(o, &t->s, &t->took, f);
    counted_print(&t->counted, o, f);
    return output_print(o, f, "\n}\n");
}

/* The rays before the arena, which is as large as there is room for. Both outputs are opened
 * first: a path that cannot be written fails before the long run. */
static int open_all(tracing *t, args *a, const char *json, fail *f) {
    plt_fault fault;
    if (scene_attach(&t->s, a, t->scene_path, f) != 0) {
        return -1;
    }
    if ((is_numbered(t, t->rays_path) ? read_rays(t, t->moved.range.first, f)
                                      : ray_file_read(&t->file, t->rays_path, t->sorts, f)) != 0) {
        return -1;
    }
    const int status = scene_start(&t->s, t->scene_path, &fault);
    if (status != PLT_OK) {
        return scene_refused(&t->s, t->scene_path, status, &fault, f);
    }
    if (t->moved.is_played && played_refused(&t->s, t->scene_path, &t->moved.range, f) != 0) {
        return -1;
    }
    if (t->built.kind != NULL &&
        baseline_open(&t->built, t->s.engine, scene_name(t->scene_path), f) != 0) {
        return -1;
    }
    if (counted_start(&t->counted, t->s.engine, scene_name(t->scene_path), f) != 0) {
        return -1;
    }
    if (!is_numbered(t, t->hits_path)) {
        t->hits_out = output_open(t->hits_path, f);
        if (t->hits_out == NULL) {
            return -1;
        }
    }
    t->stats_out = json == NULL ? NULL : output_open_text(json, f);
    if (json == NULL) {
        return 0;
    }
    return t->stats_out == NULL ? -1 : frame_times_make(&t->times, t->moved.range.count, f);
}

static int commit(output **o, fail *f) {
    const int status = *o == NULL ? 0 : output_commit(*o, f);
    *o = NULL;
    return status;
}

static int write_all(tracing *t, fail *f) {
    if ((t->hits_out != NULL && ray_file_write_hits(&t->file, t->hits_out, f) != 0) ||
        (t->stats_out != NULL &&
         (write_stats(t, t->stats_out, f) != 0 || output_finish(t->stats_out, f) != 0))) {
        return -1;
    }
    return commit(&t->hits_out, f) != 0 ? -1 : commit(&t->stats_out, f);
}

static void close_all(tracing *t) {
    output_abandon(t->hits_out);
    output_abandon(t->stats_out);
    baseline_close(&t->built);
    counted_end(&t->counted);
    scene_close(&t->s);
    ray_file_free(&t->file);
    frame_times_free(&t->times);
}

static const char *const for_engine[] = {"--packet",    "--walk",     "--structure", "--rays",
                                         "--residency", "--schedule", "--workers",   "--turns",
                                         "--moved",     "--frames",   "--rebuild",   NULL};

static void read_flags(tracing *t, args *a, const char *json) {
    t->scene_path = a->file[0];
    t->rays_path = a->file[1];
    t->hits_path = a->file[2];
    t->repeat = (unsigned)args_number(a, "--repeat", 1, 1, 1000000);
    t->sorts = args_choice(a, "--order", orders, 0) == 1;
    t->any = args_has(a, "--any");
    baseline_read(&t->built, a, for_engine);
    counted_read(&t->counted, a);
    moved_read(&t->moved, &t->s, a);
    rebuilds_read(&t->rebuilds, &t->s, a, moved_is(&t->moved));
    destination_differ(a, "HITS and --json", t->hits_path, json);
    if (strcmp(t->scene_path, "-") == 0 && strcmp(t->rays_path, "-") == 0) {
        args_complain(a, "SCENE.plt and RAYS are not both on standard input; name a file");
    }
    if (t->moved.range.count > 1 && !frame_range_is_pattern(t->hits_path)) {
        args_complain(a, "several frames need a '{}' in HITS, as in hits_{}");
    }
    t->s.options.count_touched = json != NULL;
    t->s.options.rays = (uint8_t)args_choice(a, "--rays", kinds, PLT_RAYS_AUTO);
    if (t->s.options.rays != PLT_RAYS_COHERENT && t->built.kind == NULL) {
        t->s.options.rays_in_flight = RAYS_IN_FLIGHT;
        t->s.options.wide = !moved_is(&t->moved); /* it would not move along */
    }
}

int run_trace(args *a) {
    const char *json = args_text(a, "--json", NULL);
    tracing t = {.s = SCENE_CLOSED};
    fail f = {""};
    read_flags(&t, a, json);
    int status = a->wrong ? -1 : open_all(&t, a, json, &f);
    status =
        status == 0 ? (t.built.s != NULL ? trace_baseline(&t, &f) : trace_all(&t, &f)) : status;
    status = status == 0 ? write_all(&t, &f) : status;
    close_all(&t);
    if (a->wrong) {
        return 2;
    }
    if (status != 0) {
        fprintf(stderr, "%s\n", f.text);
        return 1;
    }
    note("%s: %" PRIu64 " ray%s, %.3g s", t.hits_path, t.traced, t.traced == 1 ? "" : "s",
         t.took.seconds);
    return 0;
}
