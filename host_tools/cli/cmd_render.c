/* cmd_render - planelet render: a scene to pictures
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "engine/image/bytes.h"
#include "host_tools/base/output.h"
#include "host_tools/base/progress.h"
#include "host_tools/cli/commands.h"
#include "host_tools/cli/scene.h"
#include "host_tools/cli/view.h"
#include "host_tools/picture/picture.h"

static const arg_flag flags[] = {
    {"-o", "OUT", "a picture (.png .ppm) or a film (.y4m)"},
    {"--show", NULL, "draw the picture in the terminal"},
    {"--size", "WxH", "pixels (default 512x512)"},
    VIEW_FLAGS,
    {"--shader", "eyelight|normal|triangle", "colours by angle, by direction, by triangle"},
    {"--orbit", "N", "N frames once around the scene, 25 a second (.y4m)"},
    {"--json", "STATS", "write figures; - is standard output"},
    SCENE_FLAGS,
    {NULL, NULL, NULL}};

const arg_command command_render = {
    "render", "SCENE.plt -o OUT.png|ppm|y4m [--show]",
    "Renders a scene image with the engine that also runs as firmware.", flags, 1, 1};

enum { VISITS_A_STEP = 4096, FRAMES_A_SECOND = 25 };

typedef struct rendering {
    scene s;
    plt_frame frame;
    picture shown;
    unsigned frames;
    const char *out, *json;
    double seconds; /* in the engine */
} rendering;

static double cpu_seconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* 64-bit FNV-1a of the raw RGB bytes. */
static uint64_t frame_hash(const picture *p) {
    uint64_t hash = 0xCBF29CE484222325u;
    for (size_t i = 0; i < 3 * (size_t)p->width * p->height; i++) {
        hash = (hash ^ p->rgb[i]) * 0x100000001B3u;
    }
    return hash;
}

static void take_tile(const plt_engine *engine, picture *p) {
    plt_tile t;
    plt_render_tile(engine, &t);
    for (unsigned y = 0; y < t.height; y++) {
        memcpy(p->rgb + 3 * ((size_t)(t.y + y) * p->width + t.x), t.rgb + 3 * (size_t)y * t.width,
               3 * (size_t)t.width);
    }
}

static int render_frame(rendering *r, progress *bar, unsigned number, fail *f) {
    const double began = cpu_seconds();
    if (plt_render_begin(r->s.engine, &r->frame) != PLT_OK) {
        return fail_set(f, "camera", "eye and look coincide, or up runs along the view; "
                                     "change --eye, --look or --up");
    }
    for (;;) {
        const int status = plt_render_step(r->s.engine, VISITS_A_STEP);
        if (status == PLT_OK) {
            break;
        }
        if (status == PLT_TILE) {
            take_tile(r->s.engine, &r->shown);
            plt_tile t;
            plt_render_tile(r->s.engine, &t);
            progress_show(bar, (uint64_t)number * r->frame.height + t.y);
        }
    }
    r->seconds += cpu_seconds() - began;
    return 0;
}

static int render_frames(rendering *r, output *o, picture_format format, fail *f) {
    const plt_camera start = r->frame.camera;
    progress bar;
    int status = 0;
    progress_begin(&bar, "rendering", (uint64_t)r->frames * r->frame.height);
    for (unsigned i = 0; i < r->frames && status == 0; i++) {
        if (i > 0) {
            view_orbit(&start, (double)i / r->frames, &r->frame.camera);
        }
        status = render_frame(r, &bar, i, f);
        if (status == 0 && o != NULL) {
            status = picture_frame(o, format, &r->shown, f);
        }
    }
    progress_end(&bar);
    return status;
}

/* Frames into the file, if there is one. */
static int write_pictures(rendering *r, fail *f) {
    picture_format format = PICTURE_PNG;
    if (r->out == NULL) {
        return render_frames(r, NULL, format, f);
    }
    output *o = output_open(r->out, f);
    if (o == NULL) {
        return -1;
    }
    if (strcmp(r->out, "-") == 0) {
        format = r->frames > 1 ? PICTURE_Y4M : PICTURE_PPM;
    } else if (picture_format_of(r->out, &format, f) != 0) {
        output_abandon(o);
        return -1;
    }
    if (picture_begin(o, format, r->frame.width, r->frame.height, FRAMES_A_SECOND, f) != 0 ||
        render_frames(r, o, format, f) != 0) {
        output_abandon(o);
        return -1;
    }
    return output_commit(o, f);
}

/* The camera's floats as bits, for a firmware that shall see the same. */
static void print_bits(output *o, const char *name, const float *v, unsigned count, fail *f) {
    output_print(o, f, "  \"%s\": \"", name);
    for (unsigned i = 0; i < count; i++) {
        unsigned char bytes[4];
        plt_put_float(bytes, v[i]);
        output_print(o, f, "%s0x%08" PRIx32, i > 0 ? "," : "", plt_get_u32(bytes));
    }
    output_print(o, f, "\",\n");
}

static int write_stats(const rendering *r, fail *f) {
    output *o = output_open(r->json, f);
    if (o == NULL) {
        return -1;
    }
    const plt_camera *c = &r->frame.camera;
    output_print(o, f, "{\n  \"frame_hash\": \"%016" PRIx64 "\",\n", frame_hash(&r->shown));
    output_print(o, f, "  \"width\": %u,\n  \"height\": %u,\n  \"frames\": %u,\n", r->frame.width,
                 r->frame.height, r->frames);
    print_bits(o, "eye", c->eye, 3, f);
    print_bits(o, "look", c->look, 3, f);
    print_bits(o, "up", c->up, 3, f);
    print_bits(o, "tan", &c->tan_half_fov, 1, f);
    scene_print_stats(o, &r->s, r->seconds, f);
    if (output_print(o, f, "\n}\n") != 0) {
        output_abandon(o);
        return -1;
    }
    return output_commit(o, f);
}

static int run_all(rendering *r, args *a, fail *f) {
    plt_frame *frame = &r->frame;
    if (scene_open(&r->s, a, a->file[0], f) != 0) {
        return -1;
    }
    view_camera(a, plt_engine_info(r->s.engine), frame->width, frame->height, &frame->camera);
    if (a->wrong || picture_make(&r->shown, frame->width, frame->height, f) != 0 ||
        write_pictures(r, f) != 0) {
        return -1;
    }
    if (args_has(a, "--show")) {
        unsigned columns, rows;
        picture_terminal_size(stdout, &columns, &rows);
        picture_show(stdout, &r->shown, PICTURE_AUTO, columns, rows > 1 ? rows - 1 : 1);
    }
    return r->json == NULL ? 0 : write_stats(r, f);
}

static void read_flags(rendering *r, args *a) {
    static const char *const shaders[] = {"eyelight", "normal", "triangle", NULL};
    unsigned width = 512, height = 512;
    args_size(a, "--size", &width, &height);
    r->frame.width = (uint16_t)width;
    r->frame.height = (uint16_t)height;
    r->frame.shader = (uint8_t)args_choice(a, "--shader", shaders, PLT_SHADE_EYELIGHT);
    r->frames = (unsigned)args_number(a, "--orbit", 1, 1, 100000);
    r->out = args_text(a, "-o", NULL);
    r->json = args_text(a, "--json", NULL);
    if (r->out == NULL && !args_has(a, "--show") && r->json == NULL) {
        args_complain(a, "-o OUT says where the picture goes, --show draws it here");
    }
}

int run_render(args *a) {
    rendering r = {0};
    fail f = {""};
    read_flags(&r, a);
    const int status = a->wrong ? -1 : run_all(&r, a, &f);
    scene_close(&r.s);
    picture_free(&r.shown);
    if (a->wrong) {
        return 2;
    }
    if (status != 0) {
        fprintf(stderr, "%s\n", f.text);
    }
    return status == 0 ? 0 : 1;
}
