/* played - see played.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/played.h"

#include <inttypes.h>
#include <stdio.h>

int played_refused(const scene *s, const char *path, const frame_range *range, fail *f) {
    const uint32_t frames = plt_engine_info(s->engine)->frames;
    if (frames == 0) {
        return fail_set(f, scene_name(path),
                        "has no frames; pack it with --sequence, or give --moved MESH");
    }
    if (range->first + range->count > frames) {
        return fail_set(f, scene_name(path),
                        "has %" PRIu32 " frame%s; use --frames 0:%" PRIu32 " or less", frames,
                        frames == 1 ? "" : "s", frames);
    }
    return 0;
}

static int failed(const scene *s, const plt_engine *e, const char *path, int status,
                  const plt_fault *fault, fail *f) {
    const uint32_t frame = plt_sequence_failed(e);
    fail why = {""};
    char name[32];
    scene_refused(s, path, status, fault, &why);
    snprintf(name, sizeof name, "frame %" PRIu32, frame);
    return fail_set(f, name, "%s", why.text); /* which names the file */
}

int played_to(const scene *s, const char *path, unsigned frame, fail *f) {
    for (unsigned i = 0; i < s->crew.count; i++) {
        plt_fault fault;
        const int status = plt_sequence_show(s->crew.worker[i].engine, frame, &fault);
        if (status != PLT_OK) {
            return failed(s, s->crew.worker[i].engine, path, status, &fault, f);
        }
    }
    return 0;
}

int played_open(scene *s, args *a, const char *path, fail *f) {
    plt_info info;
    plt_fault fault;
    if (scene_attach(s, a, path, f) != 0) {
        return -1;
    }
    if (s->options.residency == PLT_RESIDENCY_WHOLE &&
        plt_image_info(&s->source, &info, &fault) == PLT_OK) {
        s->options.movable = info.frames > 0 && info.instances == 0 && !s->options.surface;
    }
    const int status = scene_start(s, path, &fault);
    return status == PLT_OK ? 0 : scene_refused(s, path, status, &fault, f);
}

int played_can(const scene *s) {
    const plt_info *info = plt_engine_info(s->engine);
    return info->frames > 0 && (info->instances > 0 || s->options.movable);
}
