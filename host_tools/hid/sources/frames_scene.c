/* frames_scene - a packed scene, rendered while it is shown
 *
 * The camera's position follows the clock, and so does the frame of a sequence, over and over: a
 * slow display shows fewer pictures of the same motion, each the latest. A frame that cannot be
 * had ends it, and what was shown last stays on the display.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <unistd.h>

#include "host_tools/app/frame.h"
#include "host_tools/app/played.h"
#include "host_tools/app/scene.h"
#include "host_tools/app/view.h"
#include "host_tools/base/clock.h"
#include "host_tools/hid/sources/frames_kinds.h"

typedef struct live {
    scene scene;
    plt_frame frame;
    plt_camera start;
    double began, orbit; /* seconds; orbit 0: the camera stands still */
    uint32_t shown;      /* frame of the image's sequence */
} live;

/* The frame of a sequence that the clock is at. */
static int show_frame(live *l, const char *path, fail *f) {
    const plt_info *info = plt_engine_info(l->scene.engine);
    if (!played_can(&l->scene)) {
        return 0;
    }
    const double gone = (clock_seconds() - l->began) * info->frame_rate;
    const uint32_t frame = (uint32_t)((uint64_t)gone % info->frames);
    if (frame == l->shown) {
        return 0;
    }
    l->shown = frame;
    return played_to(&l->scene, path, frame, f);
}

static int live_next(frames *s, picture *p, fail *f) {
    live *l = s->state;
    plt_engine *engine = l->scene.engine;
    if (l->orbit > 0.0) {
        view_orbit(&l->start, (clock_seconds() - l->began) / l->orbit, &l->frame.camera);
    }
    if (picture_resize(p, l->frame.width, l->frame.height, f) != 0) {
        return FRAMES_FAILED;
    }
    if (show_frame(l, s->path, f) != 0) {
        return FRAMES_FAILED;
    }
    if (plt_render_begin(engine, &l->frame) != PLT_OK) {
        return fail_set(f, s->path, "the camera leaves the range of 2^40; change --eye or --look");
    }
    for (int status = PLT_MORE; status != PLT_OK;) {
        status = plt_render_step(engine, FRAME_STEP_VISITS);
        if (status == PLT_TILE) {
            frame_copy_tile(engine, p);
        }
        if (status < PLT_OK) { /* a streamed scene */
            return scene_failed(&l->scene, s->path, status, f);
        }
        if (s->from.tick != NULL && s->from.tick(s->from.context)) {
            return FRAMES_END;
        }
    }
    return FRAMES_ONE;
}

static void live_close(frames *s) {
    live *l = s->state;
    if (l != NULL) {
        scene_close(&l->scene);
        free(l);
    }
}

static void read_flags(live *l, args *a) {
    float orbit = 12.0f;
    l->frame.shader = view_shader(a);
    view_background(a, &l->frame);
    if (args_floats(a, "--turn", &orbit, 1) && orbit < 0.0f) {
        args_complain(a, "--turn takes seconds, 0 or more");
    }
    l->orbit = (double)orbit;
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
