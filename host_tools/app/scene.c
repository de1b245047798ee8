/* scene - see scene.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/scene.h"

#include <inttypes.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "host_tools/app/note.h"
#include "host_tools/app/phase.h"
#include "host_tools/base/clock.h"
#include "host_tools/base/files.h"
#include "host_tools/pack/c_array.h"

enum { SMALL_THINGS = 1 << 22 }; /* bytes: buffers of outputs and of the C library */

static const char *const packets[] = {"auto", "2", "4", "8", "16", NULL};
static const char *const orders[] = {"depth", "two-stage", NULL};
static const char *const structures[] = {"tree", "grid", NULL};
static const char *const sources[] = {"map", "read", "dma:LATENCY_US,MB_PER_S[,OUTSTANDING]", NULL};
static const char *const residencies[] = {"resident", "streamed", NULL};
static const char *const schedules[] = {"branch", "batch", "task", NULL};

/* Rules 1 and 2 of SPEC.md: too short for a header, or no header of ours. */
static const char *image_remedy(const plt_fault *fault) {
    const int foreign = fault->kind == 'R' && fault->rule <= 2;
    return foreign ? "is it one? planelet pack makes them from meshes" : "pack the scene again";
}

const char *scene_name(const char *path) {
    return strcmp(path, "-") == 0 ? "standard input" : path;
}

/* The scene needs that much for the worst tree: the one that will be built may take less. */
static int is_worst(const scene *s) {
    plt_info info;
    plt_fault fault;
    return plt_image_info(&s->source, &info, &fault) == PLT_OK && info.build == PLT_BUILD_DEVICE;
}

/* In that order all else that was asked for can be had. */
static int goes_depth_first(const scene *s) {
    plt_info info;
    plt_fault fault;
    plt_options options = s->options;
    options.order = PLT_ORDER_DEPTH_FIRST;
    return plt_image_info(&s->file.source, &info, &fault) == PLT_OK &&
           plt_arena_need(&info, 0, &options) > 0;
}

/* An arena that is too small, that the system does not give, or for which this program is too
 * small. */
static int arena_refused(const scene *s, const char *name, size_t need, fail *f) {
    const size_t most = host_arena_bytes(), enough = need < most ? need : most;
    if (!s->arena_is_missing && s->arena_bytes < enough) {
        return fail_set(f, name, "needs an arena of %zu bytes and has %zu; use --arena %zu", need,
                        s->arena_bytes, enough);
    }
    if (s->arena_is_missing && s->workers > 1) {
        return fail_set(f, name,
                        "this machine has no room for %u arenas of %zu bytes, one per worker; use "
                        "--workers 1",
                        s->workers, s->arena_bytes);
    }
    if (!s->arena_is_missing) {
        return fail_set(f, name,
                        is_worst(s)
                            ? "needs an arena of %zu bytes, this program has at most %zu; pack it "
                              "with --build host or --nodes compact"
                            : "needs an arena of %zu bytes, this program has at most %zu; leave "
                              "out --source read",
                        need, most);
    }
    if (s->arena_bytes > need) {
        return fail_set(f, name,
                        "this machine has no room for an arena of %zu bytes; use --arena %zu",
                        s->arena_bytes, need);
    }
    return fail_set(f, name,
                    is_worst(s)
                        ? "this machine has no room for an arena of %zu bytes; raise the limit "
                          "with ulimit -v, close other programs, or try --arena BYTES with fewer"
                        : "this machine has no room for an arena of %zu bytes; raise the limit "
                          "with ulimit -v, or close other programs",
                    s->arena_bytes);
}

int scene_refused(const scene *s, const char *path, int status, const plt_fault *fault, fail *f) {
    const char *name = scene_name(path);
    switch (status) {
    case PLT_ERR_ARENA:
        return arena_refused(s, name, fault->need_bytes, f);
    case PLT_ERR_IMAGE:
        if (c_array_is(path)) {
            return fail_set(f, name,
                            "is a C array written by planelet pack; pack the meshes "
                            "with -o SCENE.plt to look at them");
        }
        return fail_set(f, name, "byte %" PRIu32 ": %s (%c%u); %s", fault->offset, fault->message,
                        fault->kind, (unsigned)fault->rule, image_remedy(fault));
    case PLT_ERR_SOURCE:
        return fail_set(f, name, "byte %" PRIu32 ": %s; is the file still whole?", fault->offset,
                        fault->message);
    case PLT_ERR_LIMIT:
        return fail_set(f, name, "%s; build with a larger one (engine/planelet_config.h)",
                        fault->message);
    default:
        if (s->options.records == PLT_RECORDS_NEVER || s->options.beside) {
            return fail_set(f, name, "%s; leave out --records never and --beside", fault->message);
        }
        if (s->options.rebuild && s->options.residency != PLT_RESIDENCY_STREAMED) {
            return fail_set(f, name, "%s; leave out --rebuild", fault->message);
        }
        if (s->options.movable) {
            return fail_set(f, name,
                            s->options.residency == PLT_RESIDENCY_STREAMED
                                ? "%s; pack frames with --nodes compact --stills, or use "
                                  "--residency resident"
                                : "%s; pack it with --nodes thesis, or leave out --moved and "
                                  "--frames",
                            fault->message);
        }
        if (s->options.structure == PLT_STRUCTURE_GRID && s->options.surface) {
            return fail_set(f, name,
                            "%s; pack it with --nodes thesis --surface tables, or leave out "
                            "--structure",
                            fault->message);
        }
        if (s->options.structure == PLT_STRUCTURE_GRID) {
            return fail_set(f, name, "%s; pack it with --nodes thesis, or leave out --structure",
                            fault->message);
        }
        if (s->options.surface) {
            return fail_set(f, name,
                            s->options.residency == PLT_RESIDENCY_STREAMED
                                ? "%s; pack it with --surface pages, and use --schedule branch"
                                : "%s; leave out --shader smooth",
                            fault->message);
        }
        return fail_set(f, name,
                        goes_depth_first(s)
                            ? "%s; leave out --walk two-stage"
                            : "%s; pack it with --nodes compact, or use --residency resident",
                        fault->message);
    }
}

int scene_failed(const scene *s, const char *path, int status, fail *f) {
    plt_fault fault;
    plt_fault_get(s->crew.worker[s->crew.first].engine, &fault);
    return scene_refused(s, path, status, &fault, f);
}

static uint8_t read_packet(args *a) {
    const unsigned chosen = (unsigned)args_choice(a, "--packet", packets, 0);
    const unsigned side = chosen > 0 ? 1u << chosen : 0;
    if (side > PLT_PACKET_SIDE_MAX) {
        args_complain(a, "--packet %u: this build has packets of up to %d", side,
                      PLT_PACKET_SIDE_MAX);
    }
    return (uint8_t)side;
}

/* What stands behind "dma:". */
static void read_board(args *a, const char *text, dma_config *c) {
    int length = 0;
    c->outstanding = DMA_OUTSTANDING_USUAL;
    int read = sscanf(text, "%99lf,%99lf%n", &c->latency_us, &c->mb_per_s, &length);
    if (read == 2 && text[length] == ',') {
        int more = 0;
        read += sscanf(text + length, ",%3u%n", &c->outstanding, &more) - 1;
        length += more;
    }
    /* Not what is a number to scanf alone, as nan. */
    if (read != 2 || text[length] != '\0' || strspn(text, "0123456789.,") != strlen(text) ||
        c->latency_us > 1000 || c->mb_per_s < 0.1 || c->mb_per_s > 10000 || c->outstanding < 1 ||
        c->outstanding > DMA_OUTSTANDING_MOST) {
        args_complain(a,
                      "--source dma:LATENCY_US,MB_PER_S[,OUTSTANDING] takes 0 to 1000, 0.1 to "
                      "10000 and 1 to %d, not 'dma:%s'",
                      DMA_OUTSTANDING_MOST, text);
    }
}

static int read_source(scene *s, args *a) {
    const char *text = args_text(a, "--source", "");
    if (strncmp(text, "dma:", 4) != 0) {
        return args_choice(a, "--source", sources, 0) == 1;
    }
    read_board(a, text + 4, &s->board.config);
    return 1;
}

/* Once order and residency are known. */
static void read_structure(scene *s, args *a) {
    s->options.structure = (uint8_t)args_choice(a, "--structure", structures, PLT_STRUCTURE_TREE);
    if (s->options.structure == PLT_STRUCTURE_GRID) {
        s->options.wide = 0; /* which nobody has asked for */
    }
    if (s->options.structure == PLT_STRUCTURE_GRID &&
        s->options.residency == PLT_RESIDENCY_STREAMED) {
        args_complain(a, "--structure grid is for --residency resident");
    }
    if (s->options.structure == PLT_STRUCTURE_GRID && s->options.order != PLT_ORDER_DEPTH_FIRST) {
        args_complain(a, "--structure grid is for --walk depth");
    }
    if (s->options.structure == PLT_STRUCTURE_GRID && s->options.rebuild) {
        args_complain(a, "--rebuild is for --structure tree: a grid is made anew in any case");
    }
}

/* Once the order is known. */
static void check_rebuilds(const scene *s, args *a) {
    if (s->options.rebuild_most > 0 && s->options.order != PLT_ORDER_DEPTH_FIRST) {
        args_complain(a, "--rebuild-most is for --walk depth");
    }
}

static void read_flags(scene *s, args *a, int *fetched) {
    s->options.packet_side = read_packet(a);
    s->options.order = (uint8_t)args_choice(a, "--walk", orders, PLT_ORDER_DEPTH_FIRST);
    *fetched = read_source(s, a);
    s->options.residency = (uint8_t)args_choice(a, "--residency", residencies, 0);
    *fetched |= s->options.residency == PLT_RESIDENCY_STREAMED;
    read_structure(s, a);
    check_rebuilds(s, a);
    s->options.store_bytes =
        (uint32_t)args_number(a, "--store", 0, PLT_STORE_LEAST, host_arena_bytes());
    if (args_has(a, "--store") && s->options.residency != PLT_RESIDENCY_STREAMED) {
        args_complain(a, "--store is for --residency streamed");
    }
    s->options.schedule = (uint8_t)args_choice(a, "--schedule", schedules, PLT_SCHEDULE_BRANCH);
    s->options.batch = (uint16_t)args_number(a, "--batch", 0, 1, PLT_BATCH_MOST);
    if (s->options.schedule != PLT_SCHEDULE_BRANCH &&
        s->options.residency != PLT_RESIDENCY_STREAMED) {
        args_complain(a, "--schedule %s is for --residency streamed",
                      schedules[s->options.schedule]);
    }
    if (s->options.schedule == PLT_SCHEDULE_TASK && s->options.movable) {
        args_complain(a, "--schedule task is for one frame that stays; use batch, or branch");
    }
    if (args_has(a, "--batch") && s->options.schedule == PLT_SCHEDULE_BRANCH) {
        args_complain(a, "--batch is for --schedule batch or task");
    }
    if (args_has(a, "--moved") && s->options.residency == PLT_RESIDENCY_STREAMED) {
        args_complain(a, "--moved is for --residency resident");
    }
    s->workers = (unsigned)args_number(a, "--workers", 1, 0, CREW_MOST);
    s->crew.in_turns = args_has(a, "--turns");
    if (s->workers == 0) {
        const unsigned processors = clock_processors();
        s->workers = processors < CREW_MOST ? processors : CREW_MOST;
    }
    s->options.prefetch = (uint8_t)args_number(a, "--prefetch", 0, 0, PLT_PREFETCH_MOST);
    if (args_has(a, "--prefetch") && s->options.residency != PLT_RESIDENCY_STREAMED) {
        args_complain(a, "--prefetch is for --residency streamed");
    }
    if (s->board.config.outstanding > 0 && s->options.residency != PLT_RESIDENCY_STREAMED) {
        args_complain(a, "--source dma is for --residency streamed");
    }
    if (s->board.config.outstanding > 0 && s->workers > 1) {
        args_complain(a, "--source dma is for one worker; leave out --workers");
    }
    s->arena_is_given = args_has(a, "--arena");
    s->arena_bytes = (size_t)args_number(a, "--arena", host_arena_bytes(), 1, host_arena_bytes());
}

static int is_aligned(const void *p) {
    return (uintptr_t)p % PLT_ALIGN == 0;
}

static int fail_large(const char *path, fail *f) {
    return fail_set(f, scene_name(path),
                    "is 4 GiB or larger; a scene image is smaller, is it one?");
}

int scene_read(input *in, const char *path, fail *f) {
    struct stat about;
    *in = (input){.path = path};
    if (stat(path, &about) == 0 && S_ISREG(about.st_mode) && (uint64_t)about.st_size > UINT32_MAX) {
        return fail_large(path, f); /* without reading it */
    }
    if (input_read(in, path, f) != 0) {
        return -1;
    }
    if (in->size > UINT32_MAX) {
        input_free(in);
        return fail_large(path, f);
    }
    if (!is_aligned(in->bytes)) { /* malloc of a machine whose largest type is smaller */
        const size_t room = (in->size + PLT_ALIGN) / PLT_ALIGN * PLT_ALIGN;
        unsigned char *bytes = aligned_alloc(PLT_ALIGN, room);
        if (bytes == NULL) {
            input_free(in);
            return fail_set(f, scene_name(path), "out of memory; close other programs");
        }
        memcpy(bytes, in->bytes, in->size);
        free(in->bytes);
        in->bytes = bytes;
    }
    return 0;
}

static int attach_stream(scene *s, int fetched, fail *f) {
    if (scene_read(&s->stream, "-", f) != 0) {
        return -1;
    }
    host_scene_hold(&s->file, s->stream.bytes, (uint32_t)s->stream.size, fetched);
    return 0;
}

static int attach_file(scene *s, const char *path, int fetched, fail *f) {
    if ((fetched ? host_scene_fetch(&s->file, path) : host_scene_map(&s->file, path)) != 0) {
        return fail_set(f, path, "%s", s->file.why);
    }
    return files_read(s->file.file, path, f);
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
    const int status =
        strcmp(path, "-") == 0 ? attach_stream(s, fetched, f) : attach_file(s, path, fetched, f);
    const dma_config board = s->board.config;
    s->source = s->file.source;
    if (board.outstanding > 0) {
        s->source = dma_source(&s->board, &s->file.source, &board);
    }
    return status;
}

/* All of host_arena_bytes for each, if what the command takes later fits beside them; else NULL. */
static void *get_most(const scene *s) {
    const uint64_t stacks = (uint64_t)(s->workers - 1) * CREW_STACK_BYTES;
    const uint64_t spare_bytes = s->spare_bytes + SMALL_THINGS + stacks;
    void *volatile spare = spare_bytes < SIZE_MAX ? malloc((size_t)spare_bytes) : NULL;
    void *arena = spare != NULL ? host_arenas(s->workers, s->arena_bytes) : NULL;
    free(spare);
    return arena;
}

/* With packets of the usual size, where none was asked for. */
static size_t need_of(const scene *s, const plt_info *info) {
    plt_options o = s->options;
    o.packet_side = o.packet_side > 0 ? o.packet_side : SCENE_USUAL_PACKET;
    return plt_arena_need(info, s->source.mapped != NULL, &o);
}

/* Does without the wide form, or without the wave. 0: it does without both already. */
static int do_without(scene *s) {
    const int had = s->options.rays_in_flight > 0;
    s->options.rays_in_flight = s->options.wide ? s->options.rays_in_flight : 0;
    s->options.wide = 0;
    return had;
}

/* Room that was not asked for must not be what makes a run fail: where there is too little for
 * all of it, the arena is just what the scene needs, and where that is too much, too, it is
 * what the scene needs without a wide form or a wave. */
static void *get_arena(scene *s, const plt_info *info) {
    while (need_of(s, info) > s->arena_bytes && do_without(s)) {
    }
    void *arena = s->arena_is_given ? host_arenas(s->workers, s->arena_bytes) : get_most(s);
    while (arena == NULL && !s->arena_is_given) {
        const size_t need = need_of(s, info);
        s->arena_bytes = need > 0 ? need : 1; /* 0: plt_open says why */
        arena = host_arenas(s->workers, s->arena_bytes);
        if (arena != NULL || !do_without(s)) {
            break;
        }
    }
    s->arena_is_missing = arena == NULL;
    return arena;
}

/* What the first refuses, none needs to try. */
static int open_engines(scene *s, void *arenas, plt_fault *fault) {
    int status = plt_open(&s->engine, arenas, s->arena_bytes, &s->source, &s->options, fault);
    if (status == PLT_OK) {
        status = crew_open(&s->crew, s->workers, s->engine, &s->file, &s->options, arenas,
                           s->arena_bytes);
        if (status != PLT_OK) {
            *fault = s->crew.worker[s->crew.first].fault;
        }
    }
    return status;
}

/* Lights fall on normals and colours of the image, if it has any that can be had; of
 * streamed scenes those cannot that are in tables (textures_say). */
static void choose_surface(scene *s, const plt_info *info) {
    if (s->options.whitted > 0 && (info->normal_bytes > 0 || info->colour_bytes > 0 ||
                                   info->texcoord_bytes > 0 || info->page_bytes > 0)) {
        s->options.surface = 1;
        s->options.surface = plt_arena_need(info, 0, &s->options) > 0;
    }
    const int has_textures = s->options.surface && info->texture_bytes > 0;
    s->options.textures = has_textures ? s->textures : (uint8_t)PLT_TEXTURES_NONE;
    s->options.texture_bytes = s->options.textures != PLT_TEXTURES_NONE ? s->texture_bytes : 0;
}

int scene_start(scene *s, const char *path, plt_fault *fault) {
    plt_info info;
    s->workers = s->workers > 0 ? s->workers : 1;
    const int status = plt_image_info(&s->source, &info, fault);
    if (status != PLT_OK) {
        return status;
    }
    if (info.instances > 0) {
        s->options.movable = 0; /* matrices move them, and no triangle */
        if (s->options.rebuild) {
            *fault = (plt_fault){.message = "bodies of instances have trees that never change"};
            return PLT_ERR_ARGUMENT;
        }
    }
    choose_surface(s, &info);
    void *arena = get_arena(s, &info);
    if (arena == NULL) {
        *fault = (plt_fault){.need_bytes = need_of(s, &info), .message = "there is no arena"};
        return PLT_ERR_ARENA;
    }
    crew_close(&s->crew);
    phase_begin("opening", scene_name(path));
    const int opened = open_engines(s, arena, fault);
    phase_end();
    if (opened == PLT_OK && s->board.config.outstanding > 0) {
        dma_reset(&s->board, s->engine);
    }
    return opened;
}

int scene_open(scene *s, args *a, const char *path, fail *f) {
    plt_fault fault;
    if (scene_attach(s, a, path, f) != 0) {
        return -1;
    }
    const int status = scene_start(s, path, &fault);
    return status == PLT_OK ? 0 : scene_refused(s, path, status, &fault, f);
}

/* For a person; --json has it for scripts. */
static void note_board(const dma *board) {
    dma d = *board;
    dma_settle(&d);
    const double cycles = (double)(d.worked + d.stalled);
    note("the board of --source dma: %.3g million cycles at %d MHz, %.2f %% of them stalled",
         1e-6 * cycles, DMA_CLOCK_MHZ, cycles > 0 ? 100.0 * (double)d.stalled / cycles : 0.0);
}

void scene_close(scene *s) {
    if (s->engine != NULL && s->board.config.outstanding > 0) {
        note_board(&s->board);
    }
    crew_close(&s->crew);
    host_scene_close(&s->file);
    input_free(&s->stream);
}

static size_t peak_of(const crew *c) {
    size_t most = 0;
    for (unsigned i = 0; i < c->count; i++) {
        const size_t peak = plt_arena_peak(c->worker[i].engine);
        most = peak > most ? peak : most;
    }
    return most;
}

static void print_own(output *o, const crew *c, const char *name, size_t at, fail *f) {
    output_print(o, f, ",\n  \"%s\": [", name);
    for (unsigned i = 0; i < c->count; i++) {
        plt_stats q;
        uint64_t number;
        plt_stats_get(c->worker[i].engine, &q);
        memcpy(&number, (const char *)&q + at, sizeof number);
        output_print(o, f, "%s%" PRIu64, i > 0 ? ", " : "", number);
    }
    output_print(o, f, "]");
}

/* Of each worker; and how much faster crews would be if every node visit took equally long. */
static void print_crew(output *o, const scene *s, const crew_times *took, fail *f) {
    const crew *c = &s->crew;
    output_print(o, f, ",\n  \"workers\": %u,\n  \"elapsed_seconds\": %.9f", c->count,
                 took->elapsed);
    print_own(o, c, "worker_rays", offsetof(plt_stats, rays), f);
    print_own(o, c, "worker_node_visits", offsetof(plt_stats, node_visits), f);
    print_own(o, c, "worker_bytes_fetched", offsetof(plt_stats, bytes_fetched), f);
    output_print(o, f, ",\n  \"worker_seconds\": [");
    for (unsigned i = 0; i < c->count; i++) {
        output_print(o, f, "%s%.9f", i > 0 ? ", " : "", took->worker[i]);
    }
    output_print(o, f, "]");
    if (took->visits > 0 && s->options.schedule == PLT_SCHEDULE_TASK) {
        output_print(o, f, ",\n  \"simulated_workers\": [%u],\n  \"simulated_speedup\": [%.3f]",
                     c->count, (double)took->visits / (double)took->longest[0]);
    } else if (took->visits > 0) {
        output_print(o, f, ",\n  \"simulated_workers\": [1, 2, 4, 8],\n  \"simulated_speedup\": [");
        for (unsigned i = 0; i < CREW_MODELS; i++) {
            output_print(o, f, "%s%.3f", i > 0 ? ", " : "",
                         (double)took->visits / (double)took->longest[i]);
        }
        output_print(o, f, "]");
    }
}

/* Each task goes out and comes back. */
static void print_tasks(output *o, const plt_engine *dispatcher, fail *f) {
    plt_task_stats q;
    plt_task_stats_get(dispatcher, &q);
    output_print(o, f,
                 ",\n  \"tasks\": %" PRIu64 ",\n  \"task_messages\": %" PRIu64
                 ",\n  \"task_edges\": %" PRIu64 ",\n  \"task_packets_moved\": %" PRIu64
                 ",\n  \"task_bytes_out\": %" PRIu64 ",\n  \"task_bytes_back\": %" PRIu64,
                 q.tasks, 2 * q.tasks, q.edges, q.packets_moved, q.bytes_out, q.bytes_back);
}

void scene_reset_stats(scene *s) {
    crew_stats_reset(&s->crew);
    if (s->board.config.outstanding > 0) {
        dma_reset(&s->board, s->engine);
    }
}

/* All of it has been counted: after the last call of the engine nothing is left. */
static void print_board(output *o, const dma *board, fail *f) {
    dma d = *board;
    dma_settle(&d);
    const uint64_t cycles = d.worked + d.stalled;
    output_print(o, f,
                 ",\n  \"dma_cycles_worked\": %" PRIu64 ",\n  \"dma_cycles_stalled\": %" PRIu64
                 ",\n  \"dma_share_stalled\": %.4f,\n  \"dma_transfers\": %" PRIu64
                 ",\n  \"dma_bytes\": %" PRIu64,
                 d.worked, d.stalled, cycles > 0 ? (double)d.stalled / (double)cycles : 0.0,
                 d.transfers, d.bytes);
}

void scene_print_stats(output *o, const scene *s, const crew_times *took, fail *f) {
    plt_stats q;
    const double seconds = took->seconds;
    crew_stats(&s->crew, &q);
    output_print(o, f,
                 "  \"rays\": %" PRIu64
                 ",\n  \"seconds\": %.9f,\n  \"mrays_per_s\": %.3f,\n"
                 "  \"wave_rays\": %" PRIu64 ",\n  \"packet_side\": %u,\n  \"packets\": %" PRIu64
                 ",\n  \"mixed_packets\": %" PRIu64
                 ",\n"
                 "  \"node_visits\": %" PRIu64 ",\n  \"group_tests\": %" PRIu64
                 ",\n"
                 "  \"triangle_tests\": %" PRIu64 ",\n  \"treelet_fetches\": %" PRIu64
                 ",\n"
                 "  \"bytes_fetched\": %" PRIu64 ",\n  \"bytes_touched_once\": %" PRIu64
                 ",\n"
                 "  \"store_evictions\": %" PRIu64 ",\n  \"fetch_retries\": %" PRIu64
                 ",\n"
                 "  \"bytes_validated\": %" PRIu64
                 ",\n"
                 "  \"schedule\": \"%s\",\n  \"batch\": %u,\n"
                 "  \"arena_bytes\": %zu,\n  \"arena_peak_bytes\": %zu",
                 q.rays, seconds, seconds > 0.0 ? (double)q.rays / seconds * 1e-6 : 0.0,
                 q.wave_rays, plt_packet_side(s->engine), q.packets, q.mixed_packets, q.node_visits,
                 q.group_tests, q.triangle_tests, q.treelet_fetches, q.bytes_fetched,
                 q.bytes_touched_once, q.store_evictions, q.fetch_retries, q.bytes_validated,
                 schedules[s->options.schedule], plt_batch_packets(s->engine), s->arena_bytes,
                 peak_of(&s->crew));
    print_crew(o, s, took, f);
    if (s->options.schedule == PLT_SCHEDULE_TASK) {
        print_tasks(o, s->engine, f);
    }
    if (s->board.config.outstanding > 0) {
        print_board(o, &s->board, f);
    }
}
