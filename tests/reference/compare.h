/* compare - a scene that has moved against one that is as it should be: box, hits and pictures
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_COMPARE_H
#define REFERENCE_COMPARE_H

#include <string.h>

#include "tests/reference/frames.h"
#include "tests/reference/rays.h"
#include "tests/test.h"

enum { COMPARE_RAYS = 256 };

/* Rays around `m`, the nearest hit and any. */
static inline void compare_rays(plt_engine *is, plt_engine *due, const mesh *m, const char *name) {
    static plt_ray rays[COMPARE_RAYS];
    static plt_hit hits[COMPARE_RAYS], due_hits[COMPARE_RAYS];
    random_state r = {m->triangles};
    rays_mixed(rays, COMPARE_RAYS, m, &r);
    for (int any = 0; any < 2; any++) {
        CHECK(plt_trace(is, rays, hits, COMPARE_RAYS, any) == PLT_OK, "%s", name);
        CHECK(plt_trace(due, rays, due_hits, COMPARE_RAYS, any) == PLT_OK, "%s", name);
        CHECK(memcmp(hits, due_hits, sizeof hits) == 0, "%s, any %d: hits", name, any);
    }
}

/* A picture of the whole scene, from so far away as it is wide, and `more`. */
static inline plt_frame compare_view(const plt_engine *e, float more, uint8_t shader) {
    static const float from[3] = {1.0f, 0.8f, 2.2f};
    const plt_info *info = plt_engine_info(e);
    float eye[3], look[3];
    for (int a = 0; a < 3; a++) {
        look[a] = 0.5f * (info->lo[a] + info->hi[a]);
        eye[a] = look[a] + from[a] * (info->hi[0] - info->lo[0] + more);
    }
    return frame_of(eye, look, 37, 29, shader);
}

static inline void compare_scenes(plt_engine *is, plt_engine *due, const mesh *m,
                                  const char *name) {
    const plt_info *now = plt_engine_info(is), *then = plt_engine_info(due);
    for (int a = 0; a < 3; a++) {
        CHECK(now->lo[a] == then->lo[a] && now->hi[a] == then->hi[a], "%s: box", name);
    }
    compare_rays(is, due, m, name);
    const plt_frame f = compare_view(due, 1.0f, PLT_SHADE_TRIANGLE);
    CHECK(frame_hash(is, &f, 500) == frame_hash(due, &f, 500), "%s: picture", name);
}

#endif
