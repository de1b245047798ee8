/* cmd_render - planelet render: a scene to pictures
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "board/hash.h"
#include "engine/base/bytes.h"
#include "host_tools/app/crew_tasks.h"
#include "host_tools/app/destination.h"
#include "host_tools/app/frame.h"
#include "host_tools/app/frame_times.h"
#include "host_tools/app/lights.h"
#include "host_tools/app/moved.h"
#include "host_tools/app/note.h"
#include "host_tools/app/played.h"
#include "host_tools/app/rebuilds.h"
#include "host_tools/app/scene.h"
#include "host_tools/app/textures.h"
#include "host_tools/app/vertices.h"
#include "host_tools/app/view.h"
#include "host_tools/base/output.h"
#include "host_tools/base/progress.h"
#include "host_tools/cli/baseline_render.h"
#include "host_tools/cli/commands.h"
#include "host_tools/cli/counted.h"
#include "host_tools/picture/terminal.h"

static const arg_flag flags[] = {
    {"-o", "OUT",
     "a picture (.png .ppm) or a film (.y4m); - is standard output, PPM or with --orbit Y4M; of "
     "several frames a picture each, with its number for a '{}' in the name: 000, 001 ..."},
    {"--show", NULL, "draw the picture (of --orbit the last) in the terminal: " TERMINAL_INK_HELP},
    {"--size", "WxH", "pixels, each side 1 to 32768 (default 512x512)"},
    VIEW_FLAGS,
    VIEW_BACKGROUND_FLAG,
    {"--shader", "NAME",
     "eyelight (grey by the angle), normal (colour by direction), triangle (a colour for each), "
     "smooth (eyelight by the normals and colours that the image has of corners: pack --smooth), "
     "depth (white where the scene's box is nearest, black where it is farthest), heat (node "
     "visits of a packet per pixel: black none, blue 1/64, cyan 1/4, green 4, yellow 64, red 1024, "
     "white 16384) or whitted (lights, shadows, mirrors and glass); default eyelight"},
    {"--samples", "N",
     "rays per pixel: 1, 4, 16 or adaptive (4, and 16 where these differ); their mean is taken in "
     "linear light (default 1)"},
    {"--orbit", "N",
     "a film: N frames once around the scene, 25 per second; 1 to 100000 (default 1)"},
    LIGHTS_FLAGS,
    TEXTURES_FLAGS,
    MOVED_FLAGS,
    REBUILDS_FLAGS,
    VERTICES_FLAGS,
    BASELINE_FLAG,
    {"--repeat", "N",
     "render all that N times, report the best time, and counts of the last; 1 to 1000000 (default "
     "1)"},
    DESTINATION_CHROMA_FLAG,
    {"--json", "STATS",
     "write statistics, for which the arena is a bit larger; - is standard output"},
    COUNTED_FLAG,
    SCENE_FLAGS,
    SCENE_WORKERS_FLAGS,
    {NULL, NULL, NULL}};

_Static_assert(sizeof flags / sizeof *flags - 1 <= ARGS_FLAGS_MAX, "each flag has a value");

const arg_command command_render = {
    .name = "render",
    .synopsis = "SCENE.plt -o OUT.png|ppm|y4m [--show]",
    .about =
        "Renders a scene image with the engine that also runs as firmware. SCENE.plt may be - for "
        "standard input.",
    .flags = flags,
    .files_least = 1,
    .files_most = 1,
    .print_notes = baseline_print_notes};

enum { FRAMES_PER_SECOND = 25 };
/* What writing a PNG takes: the filtered rows, and the packed ones in memory that doubles. */
enum { PNG_PICTURES = 3 };
typedef struct rendering {
    scene s;
    const char *path; /* of the scene */
    plt_frame frame;
    picture shown;
    destination to;
    unsigned frames, repeat;
    moved moved;
    rebuilds rebuilds;
    lights lights;
    baseline baseline; /* kind: NULL: the engine renders */
    baseline_colours colours;
    counted counted;
    output *picture_out, *stats_out;
    plt_camera first; /* of frame 0 */
    uint64_t hash;    /* of the RGB bytes of all frames so far */
    uint64_t *hashes; /* of each frame's alone; NULL: there are no statistics */
    frame_times times;
    crew_times took; /* in the engines, of the best run: from the first ray to the last tile */
} rendering;

/* The tile comes without a seek. Batches want to know where a run ends. */
static int goes_on(const crew_worker *w, uint32_t first) {
    return first == w->next && plt_batch_packets(w->engine) == 0;
}

/* Tiles first .. first + count - 1. */
static int render_tiles(void *context, crew_worker *w, uint32_t first, uint32_t count) {
    rendering *r = context;
    int status = goes_on(w, first) ? PLT_OK : plt_render_seek(w->engine, first, count);
    if (status != PLT_OK) {
        return status;
    }
    while (count > 0 && (status = plt_render_step(w->engine, FRAME_STEP_VISITS)) > PLT_OK) {
        if (status == PLT_TILE) {
            frame_copy_tile(w->engine, &r->shown);
            crew_done(w, 1);
            count--;
        }
    }
    return status < PLT_OK ? status : PLT_OK;
}

static void copy_tile(void *context, const plt_engine *dispatcher) {
    rendering *r = context;
    frame_copy_tile(dispatcher, &r->shown);
}

/* Tiles that a worker takes at once: those of whole batches, as an engine begins no others. */
static uint32_t tiles_per_run(const plt_engine *e) {
    const uint32_t across = PLT_TILE_SIDE / plt_packet_side(e), per_tile = across * across;
    const uint32_t batch = plt_batch_packets(e);
    const uint32_t tiles = batch % per_tile == 0 ? batch / per_tile : batch;
    return tiles > 0 ? tiles : 1;
}

static uint64_t tiles_of(const plt_frame *f) {
    const uint64_t columns = (f->width + PLT_TILE_SIDE - 1u) / PLT_TILE_SIDE;
    return columns * ((f->height + PLT_TILE_SIDE - 1u) / PLT_TILE_SIDE);
}

/* A frame by a structure; `before` frames are there already. */
static int render_baseline(rendering *r, progress *bar, uint64_t before, crew_times *took,
                           fail *f) {
    return baseline_render(&r->baseline, &r->colours, &r->frame, &r->shown, &took->seconds, bar,
                           before * tiles_of(&r->frame), f);
}

/* By the engine. */
static int render_frame(rendering *r, progress *bar, uint64_t before, crew_times *took, fail *f) {
    crew *c = &r->s.crew;
    int status = PLT_OK;
    const unsigned beginners = r->s.options.schedule == PLT_SCHEDULE_TASK ? 1 : c->count;
    for (unsigned i = 0; i < beginners && status == PLT_OK; i++) {
        status = plt_render_begin(c->worker[i].engine, &r->frame); /* view_refused has looked */
    }
    if (status != PLT_OK) {
        return fail_set(f, "engine", "status %d; please report this", status);
    }
    const uint32_t tiles = plt_render_tiles(r->s.engine);
    if (r->s.options.schedule == PLT_SCHEDULE_TASK) {
        const crew_tasks tasks = {copy_tile, r, bar, before * tiles, tiles};
        status = crew_do_tasks(c, &tasks, took);
        return status == PLT_OK ? 0 : scene_failed(&r->s, r->path, status, f);
    }
    const crew_work work = {.items = tiles,
                            .run = c->count > 1 ? tiles_per_run(r->s.engine) : tiles,
                            .work = render_tiles,
                            .context = r,
                            .bar = bar,
                            .before = before * tiles};
    status = crew_do(c, &work, took);
    return status == PLT_OK ? 0 : scene_failed(&r->s, r->path, status, f);
}

/* An image with a sequence says how fast its frames follow each other. */
static int begin_picture(const rendering *r, fail *f) {
    const uint32_t rate = r->moved.is_played ? plt_engine_info(r->s.engine)->frame_rate : 0;
    return picture_begin(r->picture_out, r->to.format, r->frame.width, r->frame.height,
                         rate > 0 ? rate : FRAMES_PER_SECOND, f);
}

static int commit_output(output **o, fail *f) {
    const int status = *o == NULL ? 0 : output_commit(*o, f);
    *o = NULL;
    return status;
}

/* A picture of its own for frame `index`, with its number for the '{}' in the name. */
static int keep_numbered(rendering *r, unsigned index, fail *f) {
    char *file = frame_range_file(r->to.out, r->moved.range.first + index);
    if (file == NULL) {
        return fail_set(f, r->to.out, "out of memory; close other programs");
    }
    r->picture_out = output_open(file, f);
    free(file);
    if (r->picture_out == NULL || begin_picture(r, f) != 0 ||
        picture_frame(r->picture_out, r->to.format, &r->shown, f) != 0) {
        return -1;
    }
    return commit_output(&r->picture_out, f);
}

static int keep_frame(rendering *r, unsigned index, fail *f) {
    const size_t bytes = 3 * (size_t)r->shown.width * r->shown.height;
    r->hash = hash_update(r->hash, r->shown.rgb, bytes);
    if (r->hashes != NULL) {
        r->hashes[index] = hash_bytes(r->shown.rgb, bytes);
    }
    if (r->to.is_numbered) {
        return keep_numbered(r, index, f);
    }
    return r->picture_out == NULL ? 0 : picture_frame(r->picture_out, r->to.format, &r->shown, f);
}

/* Triangles or camera of frame `index`. */
static int prepare_frame(rendering *r, unsigned index, fail *f) {
    r->frame.camera = r->first;
    if (moved_is(&r->moved)) {
        const int status = moved_to(&r->moved, &r->s, r->path, index, f);
        if (status == 0) { /* else the last frame may not have ended, and a rebuild waits */
            rebuilds_go_on(&r->rebuilds, &r->s);
        }
        return status;
    }
    if (index > 0) {
        view_orbit(&r->first, (double)index / r->frames, &r->frame.camera);
    }
    return 0;
}

static frame_time time_so_far(const rendering *r, const crew_times *took) {
    return (frame_time){r->moved.move_seconds, r->rebuilds.seconds, took->seconds};
}

/* All frames once: the first run's are kept. */
static int render_run(rendering *r, progress *bar, unsigned run, fail *f) {
    crew_times took = {.seconds = 0.0};
    int status = 0;
    scene_reset_stats(&r->s);
    if (r->baseline.s != NULL) {
        structure_forget(r->baseline.s);
    }
    for (unsigned i = 0; i < r->frames && status == 0; i++) {
        const frame_time before = time_so_far(r, &took);
        status = prepare_frame(r, i, f);
        if (status == 0) {
            const uint64_t done = (uint64_t)run * r->frames + i;
            status = r->baseline.s != NULL ? render_baseline(r, bar, done, &took, f)
                                           : render_frame(r, bar, done, &took, f);
        }
        const frame_time behind = time_so_far(r, &took);
        frame_times_keep(&r->times, i, &before, &behind, run == 0);
        if (status == 0 && run == 0) {
            status = keep_frame(r, i, f);
        }
        if (status == 0 && r->counted.engine != NULL && run + 1 == r->repeat) {
            status = counted_frame(&r->counted, &r->frame, f);
        }
    }
    crew_times_keep(&r->took, &took, run == 0);
    return status;
}

static int render_frames(rendering *r, fail *f) {
    progress bar;
    int status = 0;
    progress_begin(&bar, "rendering", (uint64_t)r->repeat * r->frames * tiles_of(&r->frame));
    for (unsigned i = 0; i < r->repeat && status == 0; i++) {
        status = render_run(r, &bar, i, f);
    }
    progress_end(&bar);
    return status;
}

/* The camera's floats as bits, for a firmware to render the same picture. */
static void print_bits(output *o, const char *name, const float *v, unsigned count, fail *f) {
    output_print(o, f, "  \"%s\": \"", name);
    for (unsigned i = 0; i < count; i++) {
        unsigned char bytes[4];
        plt_put_float(bytes, v[i]);
        output_print(o, f, "%s0x%08" PRIx32, i > 0 ? "," : "", plt_get_u32(bytes));
    }
    output_print(o, f, "\",\n");
}

static void print_hashes(output *o, const rendering *r, fail *f) {
    output_print(o, f, "  \"frame_hashes\": [");
    for (unsigned i = 0; i < r->frames; i++) {
        output_print(o, f, "%s\"%016" PRIx64 "\"", i > 0 ? ", " : "", r->hashes[i]);
    }
    output_print(o, f, "],\n");
}

/* How many, and what the colours of node visits stand for. */
static void print_samples(output *o, const rendering *r, fail *f) {
    if (r->frame.samples == PLT_SAMPLES_ADAPTIVE) {
        output_print(o, f, "  \"samples\": \"adaptive\",\n");
    } else {
        output_print(o, f, "  \"samples\": %u,\n", r->frame.samples);
    }
    if (r->frame.shader == PLT_SHADE_HEAT) {
        output_print(o, f,
                     "  \"heat_visits_per_pixel\": {\"black\": 0, \"blue\": 0.015625, "
                     "\"cyan\": 0.25, \"green\": 4, \"yellow\": 64, \"red\": 1024, "
                     "\"white\": 16384},\n");
    }
}

static int write_stats(const rendering *r, output *o, fail *f) {
    output_print(o, f, "{\n  \"frame_hash\": \"%016" PRIx64 "\",\n", r->hash);
    output_print(o, f, "  \"width\": %u,\n  \"height\": %u,\n  \"frames\": %u,\n", r->frame.width,
                 r->frame.height, r->frames);
    print_samples(o, r, f);
    print_hashes(o, r, f);
    frame_times_print(o, &r->times, moved_is(&r->moved), f);
    print_bits(o, "eye", r->first.eye, 3, f);
    print_bits(o, "look", r->first.look, 3, f);
    print_bits(o, "up", r->first.up, 3, f);
    print_bits(o, "tan", &r->first.tan_half_fov, 1, f);
    if (moved_is(&r->moved)) {
        moved_print(o, &r->moved, r->repeat, f);
        rebuilds_print(o, &r->rebuilds, &r->s, r->repeat, f);
        vertices_print(o, &r->s, f);
    }
    if (r->baseline.s != NULL) {
        baseline_print_rays(o, (uint64_t)r->frames * r->frame.width * r->frame.height,
                            r->took.seconds, f);
        baseline_print_counts(&r->baseline, o, f);
    } else {
        textures_print(o, &r->s, f);
        scene_print_stats(o, &r->s, &r->took, f);
        counted_print(&r->counted, o, f);
    }
    return output_print(o, f, "\n}\n");
}

/* All outputs are opened first: one that cannot be written fails before the long run. */
static int open_outputs(rendering *r, fail *f) {
    if (r->to.show && output_print_standard(f) != 0) {
        return -1;
    }
    const int is_one = r->to.out != NULL && !r->to.is_numbered;
    r->picture_out = is_one ? output_open(r->to.out, f) : NULL;
    if (is_one && r->picture_out == NULL) {
        return -1;
    }
    if (r->to.json == NULL) {
        return 0;
    }
    r->hashes = calloc(r->frames, sizeof *r->hashes);
    if (r->hashes == NULL) {
        return fail_set(f, r->to.json, "out of memory; close other programs");
    }
    r->stats_out = output_open_text(r->to.json, f);
    return r->stats_out == NULL ? -1 : frame_times_make(&r->times, r->frames, f);
}

/* All samples of a pixel are of one packet. */
static int samples_fit(const rendering *r, fail *f) {
    if (plt_packet_side(r->s.engine) > 2 || r->frame.samples < PLT_SAMPLES_SIXTEEN) {
        return 0;
    }
    return fail_set(
        f, r->path,
        "packets of 2x2 rays have no room for 16 samples; use --samples 4 or --packet 4");
}

/* What moves may come to be anywhere in its box. */
static void aim_at(rendering *r, args *a) {
    const int is_whole = r->s.options.residency == PLT_RESIDENCY_WHOLE;
    const view_subject all = {.info = plt_engine_info(r->s.engine),
                              .file = moved_is(&r->moved) ? NULL : &r->s.file,
                              .resident = is_whole ? r->s.engine : NULL,
                              .circles = r->frames > 1 && !moved_is(&r->moved)};
    view_fit(a, &all, r->frame.width, r->frame.height, &r->frame.camera);
}

static int open_all(rendering *r, args *a, fail *f) {
    plt_frame *frame = &r->frame;
    r->path = a->file[0];
    if (scene_open(&r->s, a, a->file[0], f) != 0 ||
        (r->moved.is_played && played_refused(&r->s, r->path, &r->moved.range, f) != 0)) {
        return -1;
    }
    textures_say(&r->s, r->path);
    if (r->baseline.kind != NULL &&
        (baseline_open(&r->baseline, r->s.engine, scene_name(r->path), f) != 0 ||
         baseline_colours_make(&r->colours, r->s.engine, scene_name(r->path), f) != 0)) {
        return -1;
    }
    if (samples_fit(r, f) != 0) {
        return -1;
    }
    aim_at(r, a);
    r->first = frame->camera;
    if (counted_start(&r->counted, r->s.engine, scene_name(r->path), f) != 0) {
        return -1;
    }
    lights_set(&r->lights, &r->first, &r->s.crew);
    if (a->wrong || view_refused(a, frame, moved_is(&r->moved) ? 1 : r->frames, f) != 0 ||
        picture_make(&r->shown, frame->width, frame->height, f) != 0 || open_outputs(r, f) != 0) {
        return -1;
    }
    return r->picture_out == NULL ? 0 : begin_picture(r, f);
}

static int show(const picture *p, fail *f) {
    unsigned columns, rows;
    picture_terminal_size(stdout, &columns, &rows);
    if (picture_show(stdout, p, PICTURE_AUTO, columns, rows > 1 ? rows - 1 : 1) != 0 ||
        fflush(stdout) != 0) {
        return fail_set(f, "standard output", "the picture cannot be drawn; is the disk full?");
    }
    return 0;
}

/* Statistics are finished before the picture gets its name; on standard output they come behind
 * the drawing. */
static int write_all(rendering *r, fail *f) {
    const int has_stats = r->stats_out != NULL;
    if ((has_stats && write_stats(r, r->stats_out, f) != 0) ||
        (has_stats && strcmp(r->to.json, "-") != 0 && output_finish(r->stats_out, f) != 0)) {
        return -1;
    }
    return commit_output(&r->picture_out, f);
}

static int run_all(rendering *r, args *a, fail *f) {
    if (open_all(r, a, f) != 0 || render_frames(r, f) != 0 || write_all(r, f) != 0) {
        return -1;
    }
    if (r->to.show && show(&r->shown, f) != 0) {
        return -1;
    }
    return commit_output(&r->stats_out, f);
}

static const char *const for_engine[] = {"--packet",   "--walk",    "--structure", "--residency",
                                         "--schedule", "--workers", "--turns",     "--moved",
                                         "--frames",   "--rebuild", "--samples",   NULL};

/* What the engine would refuse. */
static void refuse_samples(const rendering *r, args *a) {
    const plt_frame *f = &r->frame;
    const int is_branch = strcmp(args_text(a, "--schedule", "branch"), "branch") == 0;
    if (args_has(a, "--baseline") &&
        (f->shader == PLT_SHADE_DEPTH || f->shader == PLT_SHADE_HEAT)) {
        args_complain(a, "--shader depth and heat are for the engine; leave out --baseline");
    }
    if (!is_branch && f->samples == PLT_SAMPLES_ADAPTIVE) {
        args_complain(a, "--samples adaptive is for --schedule branch; leave out --schedule");
    }
    if (!is_branch && f->shader == PLT_SHADE_HEAT) {
        args_complain(a, "--shader heat is for --schedule branch; leave out --schedule");
    }
}

static void read_flags(rendering *r, args *a) {
    unsigned width = 512, height = 512;
    args_size(a, "--size", PICTURE_SIDE_MAX, &width, &height);
    r->frame.width = (uint16_t)width;
    r->frame.height = (uint16_t)height;
    r->frame.shader = lights_shader(a);
    view_background(a, &r->frame);
    r->frame.samples = view_samples(a);
    r->frames = (unsigned)args_number(a, "--orbit", 1, 1, 100000);
    moved_read(&r->moved, &r->s, a);
    if (moved_is(&r->moved)) {
        r->frames = r->moved.range.count;
    }
    rebuilds_read(&r->rebuilds, &r->s, a, moved_is(&r->moved));
    vertices_read(&r->s, a, r->moved.is_played);
    baseline_read(&r->baseline, a, for_engine);
    counted_read(&r->counted, a);
    if (r->frame.shader == PLT_SHADE_SMOOTH && args_has(a, "--baseline")) {
        args_complain(a, "--shader smooth is not for --baseline, which knows triangles alone");
    }
    refuse_samples(r, a);
    r->repeat = (unsigned)args_number(a, "--repeat", 1, 1, 1000000);
    destination_read(&r->to, a, r->frames, 0, 0);
    r->s.options.count_touched = r->to.json != NULL;
    lights_read(&r->lights, a, r->frame.shader, &r->s.options);
    r->s.options.wide &= !moved_is(&r->moved); /* it would not move along */
    textures_read(&r->s, a, r->frame.shader);
    r->s.options.surface = r->frame.shader == PLT_SHADE_SMOOTH;
    r->s.spare_bytes =
        (uint64_t)(r->to.format == PICTURE_PNG ? 1 + PNG_PICTURES : 1) * 3 * width * height;
}

static void say_done(const rendering *r) {
    if (r->to.out != NULL) {
        note("%s: %u frame%s of %u x %u, %.3g s", r->to.out, r->frames, r->frames == 1 ? "" : "s",
             r->frame.width, r->frame.height, r->took.seconds);
    }
    destination_note(&r->to, r->frame.width, r->frame.height);
}

int run_render(args *a) {
    rendering r = {.s = SCENE_CLOSED, .hash = HASH_BASIS};
    fail f = {""};
    read_flags(&r, a);
    const int status = a->wrong ? -1 : run_all(&r, a, &f);
    output_abandon(r.picture_out);
    output_abandon(r.stats_out);
    baseline_close(&r.baseline);
    counted_end(&r.counted);
    baseline_colours_free(&r.colours);
    scene_close(&r.s);
    picture_free(&r.shown);
    free(r.hashes);
    frame_times_free(&r.times);
    if (a->wrong) {
        return 2;
    }
    if (status != 0) {
        fprintf(stderr, "%s\n", f.text);
        return 1;
    }
    say_done(&r);
    return 0;
}
