/* cmd_serve - planelet serve: a scene to a device that renders it, and the
 * frames that come back
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "host_tools/app/destination.h"
#include "host_tools/app/scene.h"
#include "host_tools/app/view.h"
#include "host_tools/base/input.h"
#include "host_tools/base/output.h"
#include "host_tools/cli/commands.h"
#include "host_tools/link/emulated.h"
#include "host_tools/link/serve.h"
#include "host_tools/picture/terminal.h"

static const arg_flag flags[] = {
    {"--pty", NULL, "the device opens a pseudo terminal, whose name is printed"},
    {"--socket", "PATH", "the device connects to a socket of this name"},
    {"--listen", "PORT", "the device connects to this port of 127.0.0.1, 1 to 65535"},
    {"--emulate", "BYTES",
     "the device is a process of this computer with this much memory, 1024 to 1073741824"},
    {"-o", "OUT",
     "a picture (.png .ppm) or a film (.y4m) of the frames that come; - is standard output"},
    DESTINATION_CHROMA_FLAG,
    {"--show", NULL, "draw them in the terminal"},
    {"--size", "WxH", "pixels, at most 512 tiles of 16x16 (default 320x240)"},
    {"--format", "NAME", "how pixels travel: rgb565, rgb888, grey8, grey4, mono1 (default rgb888)"},
    {"--report", "BYTES", "size of a report, 8 to 1024 (default 64)"},
    {"--orbit", "N", "a film: N frames once around the scene, 1 to 100000 (default 1)"},
    {"--timeout", "SECONDS",
     "give up after so long without a part of a frame, or a request for one of the scene, up to "
     "1000000; 0: never (default 60)"},
    VIEW_FLAGS,
    VIEW_BACKGROUND_FLAG,
    {"--shader", "NAME", "eyelight, normal or triangle (default eyelight)"},
    {"--samples", "1|4|16|adaptive", "rays per pixel, as of render (default 1)"},
    {"--verbose", NULL, "say what the link does, and statistics at the end"},
    {NULL, NULL, NULL}};

const arg_command command_serve = {
    .name = "serve",
    .synopsis = "SCENE.plt --pty|--socket PATH|--listen PORT|--emulate BYTES [-o OUT] [--show]",
    .about =
        "Gives a scene to a device over a link and receives the frames it renders; the "
        "protocol is platform/WIRE.md, reports are separated by COBS. A scene that the device has "
        "no room for is streamed, if its tree is finished, of thesis nodes or of compact blocks "
        "with a lattice: the device asks for parts of it as it needs them. SCENE.plt may be - for "
        "standard input.",
    .flags = flags,
    .files_least = 1,
    .files_most = 1};

enum { FRAMES_PER_SECOND = 25 };

typedef struct serving {
    input scene;
    stream_link link;
    plt_camera first;
    unsigned frames;
    plt_frame wish; /* shader, samples, background */
    unsigned port;
    size_t memory; /* of the emulated device */
    destination to;
    output *out;
} serving;

static uint8_t samples_of(uint8_t samples) {
    return samples == PLT_SAMPLES_FOUR       ? WIRE_SAMPLES_FOUR
           : samples == PLT_SAMPLES_SIXTEEN  ? WIRE_SAMPLES_SIXTEEN
           : samples == PLT_SAMPLES_ADAPTIVE ? WIRE_SAMPLES_ADAPTIVE
                                             : WIRE_SAMPLES_ONE;
}

static void view_of(void *context, unsigned number, wire_view *v) {
    const serving *s = context;
    plt_camera c = s->first;
    if (number > 0) {
        view_orbit(&s->first, (double)number / s->frames, &c);
    }
    memcpy(v->eye, c.eye, sizeof c.eye);
    memcpy(v->look, c.look, sizeof c.look);
    memcpy(v->up, c.up, sizeof c.up);
    v->tan_half_fov = c.tan_half_fov;
    v->shader = s->wish.shader;
    v->samples = samples_of(s->wish.samples);
    v->has_background = s->wish.has_background;
    memcpy(v->background, s->wish.background, sizeof v->background);
}

static int receive_frame(void *context, unsigned number, const picture *p, fail *f) {
    serving *s = context;
    if (s->to.show) {
        unsigned columns, rows;
        if (s->frames > 1 && isatty(STDOUT_FILENO)) { /* each frame of a film over the last */
            fputs(number == 0 ? "\x1b[2J\x1b[H" : "\x1b[H", stdout);
        }
        picture_terminal_size(stdout, &columns, &rows);
        picture_show(stdout, p, PICTURE_AUTO, columns, rows > 1 ? rows - 1 : 1);
    }
    return s->out == NULL ? 0 : picture_frame(s->out, s->to.format, p, f);
}

static int open_link(serving *s, const args *a, unsigned report_bytes, fail *f) {
    if (args_has(a, "--emulate")) {
        return emulated_start(&s->link, report_bytes, s->memory, f);
    }
    return args_has(a, "--pty")      ? link_open_pty(&s->link, f)
           : args_has(a, "--socket") ? link_open_socket(&s->link, args_text(a, "--socket", ""), f)
                                     : link_open_port(&s->link, s->port, f);
}

static int read_scene(serving *s, args *a, serve_job *job, fail *f) {
    plt_info info;
    plt_fault fault;
    plt_frame frame = {.width = (uint16_t)job->width, .height = (uint16_t)job->height};
    if (scene_read(&s->scene, a->file[0], f) != 0) {
        return -1;
    }
    const plt_source source = {.mapped = s->scene.bytes, .bytes = (uint32_t)s->scene.size};
    if (plt_image_info(&source, &info, &fault) != PLT_OK) {
        return fail_set(f, scene_name(a->file[0]), "%s; pack the mesh again", fault.message);
    }
    job->image = s->scene.bytes;
    job->image_bytes = (uint32_t)s->scene.size;
    host_scene held;
    host_scene_hold(&held, s->scene.bytes, (uint32_t)s->scene.size, 0);
    const view_subject all = {.info = &info, .file = &held, .circles = s->frames > 1};
    view_fit(a, &all, job->width, job->height, &frame.camera);
    host_scene_close(&held);
    s->first = frame.camera;
    return a->wrong ? -1 : view_refused(a, &frame, s->frames, f);
}

static int open_output(serving *s, const serve_job *job, fail *f) {
    if (s->to.show && output_print_standard(f) != 0) {
        return -1;
    }
    if (s->to.out == NULL) {
        return 0;
    }
    s->out = output_open(s->to.out, f);
    return s->out == NULL
               ? -1
               : picture_begin(s->out, s->to.format, job->width, job->height, FRAMES_PER_SECOND, f);
}

static void print_stats(const serve_result *r, uint32_t image_bytes) {
    const wire_stats *h = &r->host;
    const double seconds = r->ms > 0 ? r->ms / 1000.0 : 0.001;
    fprintf(
        stderr,
        "serve: %u frames in %.2f s, image of %u bytes; reports %u out, %u in, %u lost, %u late, "
        "%u bad; %u bytes of tiles, %u tiles, %u sessions\n",
        r->frames, seconds, image_bytes, h->reports_out, h->reports_in, h->reports_lost,
        h->reports_late, h->reports_bad, h->payload_in, h->tiles_in, h->sessions);
}

/* A scene that the device had no room for. */
static void print_blocks(const serve_result *r, uint32_t image_bytes) {
    if (r->blocks > 0) {
        fprintf(stderr, "serve: streamed %llu bytes for %u requests (the image has %u)\n",
                (unsigned long long)r->block_bytes, r->blocks, image_bytes);
    }
}

static void read_size(args *a, serve_job *job) {
    job->width = 320, job->height = 240;
    if (args_size(a, "--size", PICTURE_SIDE_MAX, &job->width, &job->height) &&
        (job->width + 15) / 16 * ((job->height + 15) / 16) > WIRE_TILES_MAX) {
        args_complain(a, "--size %ux%u has more than %d tiles of 16x16, which is the most",
                      job->width, job->height, WIRE_TILES_MAX);
    }
}

static void read_link(serving *s, args *a) {
    const int links = args_has(a, "--pty") + args_has(a, "--socket") + args_has(a, "--listen") +
                      args_has(a, "--emulate");
    if (links != 1) {
        args_complain(a, "one of --pty, --socket, --listen and --emulate says where the device is");
    }
    if (args_text(a, "--socket", "x")[0] == '\0') { /* to the system no path, but any address */
        args_complain(a, "--socket takes a path, not ''");
    }
    s->port = (unsigned)args_number(a, "--listen", 0, 1, 65535);
    s->memory = (size_t)args_number(a, "--emulate", 0, 1024, (uint64_t)1 << 30);
}

static void read_flags(serving *s, args *a, serve_job *job) {
    static const char *const formats[] = {"rgb565", "rgb888", "grey8", "grey4", "mono1", NULL};
    read_size(a, job);
    read_link(s, a);
    job->format = args_choice(a, "--format", formats, WIRE_RGB888);
    job->report_bytes = (unsigned)args_number(a, "--report", 64, 8, 1024);
    job->frames = s->frames = (unsigned)args_number(a, "--orbit", 1, 1, 100000);
    job->patience_ms = 1000 * (uint32_t)args_number(a, "--timeout", 60, 0, 1000000);
    job->verbose = args_has(a, "--verbose");
    s->wish.shader = view_shader_of_triangles(a);
    s->wish.samples = view_samples(a);
    view_background(a, &s->wish);
    destination_read(&s->to, a, s->frames, 1, job->verbose);
    if (s->to.out != NULL && strcmp(s->to.out, "-") != 0) {
        destination_differ(a, "--socket and -o", args_text(a, "--socket", NULL), s->to.out);
    }
}

/* The link before the output: a socket takes a name that nothing has. */
static int open_all(serving *s, args *a, serve_job *job, fail *f) {
    return read_scene(s, a, job, f) == 0 && open_link(s, a, job->report_bytes, f) == 0 &&
                   open_output(s, job, f) == 0
               ? 0
               : -1;
}

static int serve(serving *s, args *a, serve_job *job, fail *f) {
    serve_result result = {.frames = 0};
    if (open_all(s, a, job, f) != 0) {
        output_abandon(s->out);
        return -1;
    }
    if (!args_has(a, "--emulate")) {
        fprintf(stderr, "serve: waiting for a device at %s\n", s->link.name);
    }
    const transport t = link_transport(&s->link);
    const int status = serve_run(job, &t, &result, f);
    if (status == 0) {
        print_blocks(&result, job->image_bytes);
    }
    if (job->verbose) {
        print_stats(&result, job->image_bytes);
    }
    if (s->out != NULL && status == 0) {
        return output_commit(s->out, f);
    }
    output_abandon(s->out);
    return status;
}

int run_serve(args *a) {
    serving s = {.link = {.listener = -1, .peer = -1}};
    serve_job job = {.view = view_of, .frame = receive_frame, .context = &s};
    fail f = {""};
    read_flags(&s, a, &job);
    const int status = a->wrong ? -1 : serve(&s, a, &job, &f);
    link_close(&s.link);
    input_free(&s.scene);
    if (a->wrong) {
        return 2;
    }
    if (status != 0) {
        fprintf(stderr, "%s\n", f.text);
    } else {
        destination_note(&s.to, job.width, job.height);
    }
    return status == 0 ? 0 : 1;
}
