/* frames_scene - a packed scene, rendered while it is shown, and turned by the display's keys
 *
 * Until a key is pressed the camera's position follows the clock; the frame of a sequence always
 * does, over and over: a slow display shows fewer pictures of the same motion, each the latest.
 * From the first key on the camera is where the keys have brought it: pictures are coarse while it
 * moves (coarse.h), and the last is shown again now and then while nothing happens. A frame of a
 * sequence that cannot be had ends it, and what was shown last stays on the display.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <unistd.h>

#include "host_tools/app/coarse.h"
#include "host_tools/app/frame.h"
#include "host_tools/app/played.h"
#include "host_tools/app/pose.h"
#include "host_tools/app/scene.h"
#include "host_tools/app/view.h"
#include "host_tools/base/clock.h"
#include "host_tools/hid/device/symbols.h"
#include "host_tools/hid/sources/frames_kinds.h"
#include "host_tools/picture/fit.h"

static const double LISTEN = 0.01, LONGEST = 0.5; /* seconds between two looks, two pictures */

typedef struct live {
    scene scene;
    plt_frame frame; /* of the panel's size */
    plt_camera start;
    double began, orbit; /* seconds; orbit 0: the camera stands still */
    uint32_t shown;      /* frame of the image's sequence */
    int is_bare;         /* without symbols */

    int is_steered; /* a key was pressed */
    int is_still;   /* frames do not go on ... */
    double still;   /* ... since this clock */
    pose pose;
    coarse coarse;
    picture fine; /* as rendered, for a camera that is steered; owned */
} live;

/* ---- keys --------------------------------------------------------------------------- */

/* The camera stays where the clock has brought it. */
static void begin_to_steer(live *l) {
    pose_begin(&l->pose, &l->start);
    if (l->orbit > 0.0) {
        pose_turn(&l->pose, 360.0 * (clock_seconds() - l->began) / l->orbit, 0.0);
    }
    l->is_steered = 1;
    l->coarse = (coarse)COARSE_BEGUN;
}

static void stop_or_go_on(live *l) {
    const double now = clock_seconds();
    l->began += l->is_still ? now - l->still : 0.0;
    l->still = now;
    l->is_still = !l->is_still;
}

/* Returns whether there is something new to show. */
static int take_keys(live *l, const frames *s) {
    unsigned count[STEER_ACTIONS] = {0};
    int moved = 0;
    if (s->steer != NULL) {
        s->steer(s->from.context, count);
    }
    for (unsigned action = 0; action < STEER_ACTIONS; action++) {
        for (; count[action] > 0; count[action]--) {
            if (!l->is_steered) {
                begin_to_steer(l);
                moved = 1;
            }
            if (action == STEER_STILL) {
                stop_or_go_on(l);
            }
            moved |= steer(&l->pose, (enum steer_action)action);
        }
    }
    if (moved) {
        coarse_moved(&l->coarse);
    }
    return moved;
}

/* ---- pictures ----------------------------------------------------------------------- */

/* The frame of a sequence that the clock is at. */
static int show_frame(live *l, const char *path, fail *f) {
    const plt_info *info = plt_engine_info(l->scene.engine);
    if (!played_can(&l->scene)) {
        return 0;
    }
    const double now = l->is_still ? l->still : clock_seconds();
    const uint32_t frame =
        (uint32_t)((uint64_t)((now - l->began) * info->frame_rate) % info->frames);
    if (frame == l->shown) {
        return 0;
    }
    l->shown = frame;
    coarse_moved(&l->coarse);
    return played_to(&l->scene, path, frame, f);
}

enum { FAILED = FRAMES_FAILED, STOPPED = FRAMES_END, COMPLETE = FRAMES_ONE, DROPPED = 2 };

/* DROPPED when a key was pressed that makes the picture old; but one that is as coarse as can be is
 * completed, or a key that is held would never let one be seen. */
static int render(live *l, frames *s, const plt_frame *frame, picture *to, fail *f) {
    plt_engine *engine = l->scene.engine;
    const int is_first = l->is_steered && l->coarse.level == l->coarse.first;
    double listened = clock_seconds();
    if (picture_resize(to, frame->width, frame->height, f) != 0) {
        return FAILED;
    }
    if (plt_render_begin(engine, frame) != PLT_OK) {
        return fail_set(f, s->path, "the camera leaves the range of 2^40; change --eye or --look");
    }
    for (int status = PLT_MORE; status != PLT_OK;) {
        status = plt_render_step(engine, FRAME_STEP_VISITS);
        if (status == PLT_TILE) {
            frame_copy_tile(engine, to);
        }
        if (status < PLT_OK) { /* a streamed scene */
            return scene_failed(&l->scene, s->path, status, f);
        }
        if (s->from.tick != NULL && s->from.tick(s->from.context)) {
            return STOPPED;
        }
        if (!is_first && clock_seconds() - listened > LISTEN) {
            listened = clock_seconds();
            if (take_keys(l, s)) {
                return DROPPED;
            }
        }
    }
    return COMPLETE;
}

/* A picture from where the clock has brought the camera. */
static int next_by_clock(live *l, frames *s, picture *p, fail *f) {
    if (l->orbit > 0.0) {
        view_orbit(&l->start, (clock_seconds() - l->began) / l->orbit, &l->frame.camera);
    }
    return show_frame(l, s->path, f) != 0 ? FAILED : render(l, s, &l->frame, p, f);
}

/* Waits for something to show; STOPPED, or COMPLETE: also when nothing came for a while. */
static int rest(live *l, frames *s, fail *f) {
    const double end = clock_seconds() + LONGEST;
    while (!l->coarse.is_due && clock_seconds() < end) {
        if (s->from.tick != NULL && s->from.tick(s->from.context)) {
            return STOPPED;
        }
        if (!take_keys(l, s) && show_frame(l, s->path, f) != 0) {
            return FAILED;
        }
        clock_sleep(l->coarse.is_due ? 0.0 : 0.004);
    }
    return COMPLETE;
}

/* A picture from where the keys have brought it. */
static int next_by_keys(live *l, frames *s, picture *p, fail *f) {
    const plt_frame *panel = &l->frame;
    plt_frame frame = *panel;
    int status = rest(l, s, f);
    if (status == COMPLETE && l->coarse.is_due) {
        const double began = clock_seconds();
        frame.width = (uint16_t)coarse_side(&l->coarse, panel->width);
        frame.height = (uint16_t)coarse_side(&l->coarse, panel->height);
        frame.camera = pose_camera(&l->pose);
        status = show_frame(l, s->path, f) != 0 ? FAILED : render(l, s, &frame, &l->fine, f);
        if (status == COMPLETE) {
            coarse_complete(&l->coarse, clock_seconds() - began);
        }
    }
    if (status != COMPLETE) {
        return status;
    }
    if (picture_resize(p, panel->width, panel->height, f) != 0) {
        return FAILED;
    }
    fit_picture(&l->fine, p, FIT_STRETCH);
    return COMPLETE;
}

static int live_next(frames *s, picture *p, fail *f) {
    live *l = s->state;
    int status;
    do {
        take_keys(l, s);
        status = l->is_steered ? next_by_keys(l, s, p, f) : next_by_clock(l, s, p, f);
    } while (status == DROPPED);
    if (status == COMPLETE && !l->is_bare) {
        symbols_draw(p, s->keys);
    }
    return status;
}

static void live_close(frames *s) {
    live *l = s->state;
    if (l != NULL) {
        scene_close(&l->scene);
        picture_free(&l->fine);
        free(l);
    }
}

/* ---- opening ------------------------------------------------------------------------ */

static void read_flags(live *l, args *a) {
    float orbit = 12.0f;
    l->frame.shader = view_shader(a);
    view_background(a, &l->frame);
    if (args_floats(a, "--turn", &orbit, 1) && orbit < 0.0f) {
        args_complain(a, "--turn takes seconds, 0 or more");
    }
    l->orbit = (double)orbit;
    l->is_bare = args_has(a, "--bare");
    l->scene.options.surface = l->frame.shader == PLT_SHADE_SMOOTH;
    l->scene.textures = PLT_TEXTURES_BILINEAR;
}

static void aim_at(live *l, args *a) {
    const int is_whole = l->scene.options.residency == PLT_RESIDENCY_WHOLE;
    const view_subject all = {.info = plt_engine_info(l->scene.engine),
                              .file = &l->scene.file,
                              .resident = is_whole ? l->scene.engine : NULL,
                              .circles = l->orbit > 0.0};
    view_fit(a, &all, l->frame.width, l->frame.height, &l->frame.camera);
}

int frames_scene(frames *s, args *a, unsigned width, unsigned height, fail *f) {
    live *l = calloc(1, sizeof *l);
    s->next = live_next;
    s->close = live_close;
    s->state = l;
    if (l == NULL || s->from.fd == STDIN_FILENO) {
        return fail_set(f, s->path,
                        l == NULL ? "out of memory; close other programs"
                                  : "a scene is a file; name it");
    }
    l->scene.file.file = -1;
    read_flags(l, a);
    if (played_open(&l->scene, a, s->path, f) != 0) {
        return -1;
    }
    l->frame.width = (uint16_t)width;
    l->frame.height = (uint16_t)height;
    aim_at(l, a);
    l->start = l->frame.camera;
    l->began = clock_seconds();
    return a->wrong ? -1 : view_refused(a, &l->frame, 1, f);
}
