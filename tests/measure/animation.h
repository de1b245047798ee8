/* animation - the frames that a measuring program is given, and cameras that look at them
 *
 * FILE:FRAMES or FILE:FRAMES:EVERY, of which then every so-many-th frame is taken. FILE is a recipe
 * with sequences, or a name with a '{}' for the frame's number, or marbles or city.
 *
 * SPDX-License-Identifier: MIT */
#ifndef MEASURE_ANIMATION_H
#define MEASURE_ANIMATION_H

#include <math.h>

#include "host_tools/mesh/mesh.h"
#include "host_tools/scenes/cos_sin.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/frames.h"
#include "tests/reference/rays.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

typedef struct animation {
    char file[512];
    unsigned frames, every;
} animation;

/* -1: it is none, or has more than `most` frames; a test that failed. */
static inline int animation_argument(animation *s, const char *text, unsigned most) {
    *s = (animation){.frames = 0, .every = 1};
    const int n = sscanf(text, "%511[^:]:%u:%u", s->file, &s->frames, &s->every);
    const int is_one = n >= 2 && s->frames >= 2 && s->frames <= most && s->every > 0;
    CHECK(is_one, "%s: write FILE:FRAMES[:EVERY], 2 to %u frames", text, most);
    return is_one ? 0 : -1;
}

static inline int animation_frame(mesh *m, const animation *s, unsigned frame) {
    const unsigned number = frame * s->every;
    mesh_report report = {0};
    fail f = {""};
    char name[600];
    const char *at = strstr(s->file, "{}");
    int status;
    if (strcmp(s->file, "marbles") == 0) {
        status = scene_marbles(m, SCENE_MARBLES_MOST, number, &f);
    } else if (strcmp(s->file, "city") == 0) {
        status = scene_city(m, number, &f);
    } else if (at != NULL) {
        snprintf(name, sizeof name, "%.*s%03u%s", (int)(at - s->file), s->file, number, at + 2);
        status = mesh_read(m, name, 0, &report, &f);
    } else {
        status = mesh_read(m, s->file, number, &report, &f);
    }
    CHECK(status == 0, "%s", f.text);
    return status;
}

/* Calls `run` with each animation that the command line names; without one with the marbles, so
 * that a run of all tests measures, too, but for small limits. What main returns. */
static inline int animations_run(int argc, char **argv, const char *sentence, unsigned most,
                                 void (*run)(const animation *s)) {
    test(sentence);
    for (int i = 1; i < argc || i == 1; i++) {
        animation s;
        const int is_right = animation_argument(&s, i < argc ? argv[i] : "marbles:4:40", most) == 0;
        if (is_right && (i < argc || !rig_is_tiny())) {
            run(&s);
        }
    }
    return test_done();
}

/* Cameras: one stands, one goes around, one comes near; two views of each. `time`: 0 to 1. */
static inline plt_frame animation_view(const float lo[3], const float hi[3], double time,
                                       unsigned camera, unsigned which, uint16_t side) {
    const double circles = (camera == 1 ? time : 0.0) + 0.13 + 0.41 * which;
    const cos_sin c = cos_sin_of((uint64_t)(1000000.0 * circles), 1000000);
    float eye[3], look[3], size = 0;
    for (int a = 0; a < 3; a++) {
        look[a] = 0.5f * (lo[a] + hi[a]);
        size = hi[a] - lo[a] > size ? hi[a] - lo[a] : size;
    }
    const float near = camera == 2 ? 1.6f - 1.2f * (float)time : 1.0f;
    const float far = (which ? 0.7f : 1.3f) * near;
    eye[0] = look[0] + far * size * (float)c.cosine;
    eye[1] = look[1] + 0.4f * far * size;
    eye[2] = look[2] + far * size * (float)c.sine;
    return frame_of(eye, look, side, side, PLT_SHADE_EYELIGHT);
}

/* Of the vertices that triangles use. */
static inline void animation_box(const mesh *m, float lo[3], float hi[3]) {
    for (int a = 0; a < 3; a++) {
        lo[a] = INFINITY;
        hi[a] = -INFINITY;
        for (size_t i = 0; i < 3 * m->triangles; i++) {
            lo[a] = fminf(lo[a], m->vertex[3 * (size_t)m->triangle[i] + (size_t)a]);
            hi[a] = fmaxf(hi[a], m->vertex[3 * (size_t)m->triangle[i] + (size_t)a]);
        }
    }
}

/* From a point of a triangle, in any direction. */
static inline plt_ray animation_ray(const mesh *m, random_state *r) {
    const uint32_t triangle = random_below(r, (uint32_t)m->triangles);
    const float u = random_float(r, 0.0f, 0.5f), v = random_float(r, 0.0f, 0.5f);
    float org[3], dir[3], length;
    for (int a = 0; a < 3; a++) {
        org[a] = (1.0f - u - v) * shape_corner(m, triangle, 0)[a] +
                 u * shape_corner(m, triangle, 1)[a] + v * shape_corner(m, triangle, 2)[a];
    }
    do { /* all directions alike */
        length = 0.0f;
        for (int a = 0; a < 3; a++) {
            dir[a] = random_float(r, -1.0f, 1.0f);
            length += dir[a] * dir[a];
        }
    } while (length > 1.0f || length < 0.01f);
    return ray_make(org, dir, 0.0f, RAYS_FAR);
}

#endif
