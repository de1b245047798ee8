/* cmd_view - planelet view: a scene in the terminal, turned by keys and the mouse
 *
 * A picture is rendered in steps, and between two of them the terminal is listened to: a key begins
 * the next picture at once. How fine it is, coarse.h says.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "host_tools/app/coarse.h"
#include "host_tools/app/frame.h"
#include "host_tools/app/played.h"
#include "host_tools/app/pose.h"
#include "host_tools/app/scene.h"
#include "host_tools/app/steer.h"
#include "host_tools/app/view.h"
#include "host_tools/base/clock.h"
#include "host_tools/cli/commands.h"
#include "host_tools/cli/viewer_screen.h"
#include "host_tools/cli/viewer_signals.h"
#include "host_tools/picture/terminal.h"
#include "host_tools/picture/terminal_mode.h"

static const arg_flag flags[] = {
    {"--graphics", "auto|blocks|kitty|sixel",
     "half blocks, two pixels per cell, or pixel by pixel by kitty's protocol or in sixels; auto "
     "asks the terminal, which has half a second to answer (default auto)"},
    VIEW_FLAGS,
    VIEW_BACKGROUND_FLAG,
    {"--shader", "NAME",
     "eyelight, normal, triangle, or, of scenes with normals or colours (pack --smooth), smooth "
     "(default eyelight)"},
    SCENE_FLAGS,
    {NULL, NULL, NULL}};

static const char notes[] =
    "arrows, or the mouse with its button down: turn\n"
    "+ - or the wheel: nearer, farther\n"
    "r: the first view again    space: stop the frames, go on\n"
    "q or Ctrl-C: end    Ctrl-Z: the shell, until fg\n";

const arg_command command_view = {
    .name = "view",
    .synopsis = "SCENE.plt",
    .about =
        "Shows a scene in the terminal, where keys and the mouse turn it. An image's own "
        "frames are played over and over.",
    .flags = flags,
    .files_least = 1,
    .files_most = 1,
    .notes = notes};

static const double LISTEN = 0.02;             /* seconds between two looks at the terminal */
static const double LONGEST = 0.25;            /* seconds that nothing is looked at */
static const double CELL = 3.0, NEARER = 1.15; /* degrees, a factor */

typedef struct viewing {
    scene s;
    const char *path;
    plt_frame frame;
    pose pose;
    viewer_screen screen;
    picture shown;
    coarse coarse;
    int is_still; /* frames do not go on */
    int ends;
    double played; /* seconds of the sequence that have gone */
    double now;    /* clock, when they had */
    uint32_t at;   /* frame that is shown */
    int drag_x, drag_y;
} viewing;

/* Returns whether the camera has moved. */
static int take_key(viewing *v, int key) {
    switch (key) {
    case TERMINAL_LEFT:
        return steer(&v->pose, STEER_LEFT);
    case TERMINAL_RIGHT:
        return steer(&v->pose, STEER_RIGHT);
    case TERMINAL_UP:
        return steer(&v->pose, STEER_UP);
    case TERMINAL_DOWN:
        return steer(&v->pose, STEER_DOWN);
    case '+':
    case '=':
        return steer(&v->pose, STEER_NEARER);
    case '-':
    case '_':
        return steer(&v->pose, STEER_FARTHER);
    case 'r':
    case 'R':
        return steer(&v->pose, STEER_RESET);
    case ' ':
        v->is_still = !v->is_still;
        return 0;
    case 26: /* Ctrl-Z */
        viewer_signals_stop();
        return 0;
    case 'q':
    case 'Q':
    case 3: /* Ctrl-C */
        v->ends = 1;
        return 0;
    default:
        return 0;
    }
}

/* The scene follows the mouse, so the eye goes the other way. A cell is twice as high as wide. */
static int take_drag(viewing *v, const terminal_event *e) {
    const int x = e->x - v->drag_x, y = e->y - v->drag_y;
    v->drag_x = e->x;
    v->drag_y = e->y;
    return (x != 0 || y != 0) && pose_turn(&v->pose, -CELL * x, 2.0 * CELL * y);
}

static int take_press(viewing *v, const terminal_event *e) {
    v->drag_x = e->x;
    v->drag_y = e->y;
    return e->code == TERMINAL_WHEEL_UP     ? pose_zoom(&v->pose, NEARER)
           : e->code == TERMINAL_WHEEL_DOWN ? pose_zoom(&v->pose, 1.0 / NEARER)
                                            : 0;
}

static void take_input(viewing *v) {
    int moved = 0;
    for (terminal_event e; (e = terminal_input_take(&v->screen.input)).kind != TERMINAL_NOTHING;) {
        moved |= e.kind == TERMINAL_KEY     ? take_key(v, e.code)
                 : e.kind == TERMINAL_DRAG  ? take_drag(v, &e)
                 : e.kind == TERMINAL_PRESS ? take_press(v, &e)
                                            : 0;
    }
    if (moved) {
        coarse_moved(&v->coarse);
    }
    v->ends |= v->screen.is_gone;
}

/* The terminal, and the frame that the clock is at; of a sequence none goes by while the program is
 * stopped. */
static int follow(viewing *v, fail *f) {
    const plt_info *info = plt_engine_info(v->s.engine);
    const int signals = viewer_signals_take();
    if (signals < 0) {
        return fail_set(f, "terminal", "it takes no other mode; use another terminal");
    }
    if (signals > 0) {
        viewer_screen_measure(&v->screen);
        coarse_moved(&v->coarse);
    }
    const double now = clock_seconds();
    v->now = signals > 0 ? now : v->now;
    v->played += v->is_still ? 0.0 : now - v->now;
    v->now = now;
    if (!played_can(&v->s)) {
        return 0;
    }
    const uint32_t at = (uint32_t)((uint64_t)(v->played * info->frame_rate) % info->frames);
    if (at == v->at) {
        return 0;
    }
    v->at = at;
    coarse_moved(&v->coarse);
    return played_to(&v->s, v->path, at, f);
}

enum { FAILED = -1, COMPLETE, DROPPED };

/* Drops the picture when something has happened that makes it old. Frames that go on do not: a slow
 * picture would never be complete. */
static int render(viewing *v, fail *f) {
    double listened = clock_seconds();
    v->frame.width = (uint16_t)coarse_side(&v->coarse, v->screen.width);
    v->frame.height = (uint16_t)coarse_side(&v->coarse, v->screen.height);
    v->frame.camera = pose_camera(&v->pose);
    v->coarse.is_due = 0;
    if (picture_resize(&v->shown, v->frame.width, v->frame.height, f) != 0) {
        return FAILED;
    }
    if (plt_render_begin(v->s.engine, &v->frame) != PLT_OK) {
        return fail_set(f, "camera", "it leaves the range of 2^40; change --eye or --look");
    }
    for (int status = PLT_MORE; status != PLT_OK;) {
        status = plt_render_step(v->s.engine, FRAME_STEP_VISITS);
        if (status < PLT_OK) {
            return scene_failed(&v->s, v->path, status, f);
        }
        if (status == PLT_TILE) {
            frame_copy_tile(v->s.engine, &v->shown);
        }
        if (clock_seconds() - listened > LISTEN) {
            listened = clock_seconds();
            viewer_screen_wait(&v->screen, 0.0);
            take_input(v);
            if (v->ends || v->coarse.is_due || viewer_signals_wait()) {
                return DROPPED;
            }
        }
    }
    return COMPLETE;
}

/* A picture, and the next finer one is due. */
static int show_next(viewing *v, fail *f) {
    char text[256];
    const double began = clock_seconds();
    const int status = render(v, f);
    if (status != COMPLETE) {
        v->coarse.is_due = 1;
        return status == FAILED ? -1 : 0;
    }
    coarse_complete(&v->coarse, clock_seconds() - began);
    snprintf(text, sizeof text, "%s  arrows, mouse: turn  + -: zoom  r: reset%s  q: quit", v->path,
             played_can(&v->s) ? "  space: stop, go on" : "");
    return viewer_screen_draw(&v->screen, &v->shown, text, f);
}

/* Until the next frame is due; a resize that no wait has noticed is, a moment later. */
static double rest(const viewing *v) {
    if (v->coarse.is_due) {
        return 0.0;
    }
    const plt_info *info = plt_engine_info(v->s.engine);
    const double next = (floor(v->played * info->frame_rate) + 1.0) / fmax(info->frame_rate, 1.0);
    const double until = fmax(next - v->played, 0.001);
    return v->is_still || !played_can(&v->s) || until > LONGEST ? LONGEST : until;
}

static int view_until_end(viewing *v, fail *f) {
    viewer_screen_ask(&v->screen);
    v->now = clock_seconds();
    coarse_moved(&v->coarse);
    while (!v->ends) {
        if (follow(v, f) != 0 || (v->coarse.is_due && show_next(v, f) != 0)) {
            return -1;
        }
        if (!viewer_signals_wait()) {
            viewer_screen_wait(&v->screen, rest(v));
        }
        take_input(v);
    }
    return 0;
}

static int open_all(viewing *v, args *a, fail *f) {
    if (!isatty(STDIN_FILENO) || !isatty(STDOUT_FILENO)) {
        return fail_set(f, "terminal", "standard input and output are none; use planelet render");
    }
    if (strcmp(v->path, "-") == 0) {
        return fail_set(f, "standard input", "it is for keys; name a file");
    }
    if (played_open(&v->s, a, v->path, f) != 0) {
        return -1;
    }
    const int is_whole = v->s.options.residency == PLT_RESIDENCY_WHOLE;
    const view_subject all = {.info = plt_engine_info(v->s.engine),
                              .file = &v->s.file,
                              .resident = is_whole ? v->s.engine : NULL};
    unsigned columns, rows;
    picture_terminal_size(stdout, &columns, &rows);
    v->frame.width = (uint16_t)columns;
    v->frame.height = (uint16_t)(rows > 1 ? 2 * (rows - 1) : 2);
    view_fit(a, &all, v->frame.width, v->frame.height, &v->frame.camera);
    if (a->wrong || view_refused(a, &v->frame, 1, f) != 0) {
        return -1;
    }
    pose_begin(&v->pose, &v->frame.camera);
    if (terminal_mode_enter(STDIN_FILENO, STDOUT_FILENO) != 0) {
        return fail_set(f, "terminal", "it takes no other mode; use another terminal");
    }
    return 0;
}

static void read_flags(viewing *v, args *a) {
    static const char *const graphics[] = {"auto", "blocks", "kitty", "sixel", NULL};
    v->screen.graphics = (enum viewer_graphics)args_choice(a, "--graphics", graphics, VIEWER_AUTO);
    v->frame.shader = view_shader(a);
    v->s.options.surface = v->frame.shader == PLT_SHADE_SMOOTH;
    v->s.textures = PLT_TEXTURES_BILINEAR;
    view_background(a, &v->frame);
}

int run_view(args *a) {
    viewing v = {.s = SCENE_CLOSED, .path = a->file[0], .coarse = COARSE_BEGUN};
    fail f = {""};
    read_flags(&v, a);
    viewer_signals_catch();
    const int status = a->wrong ? -1 : open_all(&v, a, &f) != 0 ? -1 : view_until_end(&v, &f);
    viewer_screen_close(&v.screen);
    terminal_mode_leave();
    picture_free(&v.shown);
    scene_close(&v.s);
    if (status != 0 && !a->wrong) {
        fprintf(stderr, "%s\n", f.text);
    }
    return a->wrong ? 2 : status == 0 ? 0 : 1;
}
