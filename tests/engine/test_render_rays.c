/* test_render_rays - frames have the colours of the hits that plt_trace finds for their rays
 *
 * Each pixel's ray is traced, and its hit shaded, alone: for cameras anywhere, and views straight
 * down on grids, whose corners and edges lie on pixels, so that no sieve is sure of them. Of every
 * size of packet, of squares that are cropped, too, and of shaders by normals and by triangles.
 * With all that passes the sieve taken for sure (triangle_sieve.h) frames differ; with what is
 * beyond 0 instead of the slack none does: it is for the worst of many roundings at once.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "engine/engine.h"
#include "engine/shade/surface.h"
#include "engine/trace/triangle_ray.h"
#include "tests/reference/frame_scenes.h"
#include "tests/reference/frames.h"
#include "tests/test.h"

#if PLT_WITH_GROUPS && PLT_WITH_BEAMS

enum { SIDE_MOST = 96 };

static plt_ray rays[SIDE_MOST * SIDE_MOST];
static plt_hit hits[SIDE_MOST * SIDE_MOST];
static uint32_t pixels_hit, frames_seen;

static void due_colour(const plt_scene *s, const plt_frame *f, uint32_t pixel, uint8_t rgb[3]) {
    if (hits[pixel].triangle == PLT_MISS) {
        plt_surface_sky(f, pixel / f->width, rgb);
        return;
    }
    float corner[3][3], normal[3];
    plt_surface surface;
    plt_record_corners(frame_scenes_record(s, hits[pixel].triangle), corner);
    plt_hit_normal((const float(*)[3])corner, normal);
    plt_surface_set(&surface, normal);
    plt_surface_colour(&surface, f->shader, hits[pixel].triangle, rays[pixel].dir, rgb);
    pixels_hit++;
}

static void one_frame(const rig *r, const plt_frame *f, const char *what) {
    plt_view view;
    uint32_t wrong = 0;
    if (r->engine == NULL || plt_view_set(&view, f) != PLT_OK) {
        return;
    }
    frame_result got = frame_render(r->engine, f, 1000);
    CHECK(got.status == PLT_OK && got.wrong == 0, "%s: status %d", what, got.status);
    const uint32_t count = (uint32_t)f->width * f->height;
    for (uint32_t i = 0; i < count; i++) {
        memcpy(rays[i].org, view.eye, sizeof rays[i].org);
        plt_view_direction(&view, i % f->width, i / f->width, rays[i].dir);
        rays[i].tmin = 0.0f;
        rays[i].tmax = PLT_VIEW_FAR;
    }
    CHECK(plt_trace(r->engine, rays, hits, count, 0) == PLT_OK, "%s", what);
    for (uint32_t i = 0; i < count; i++) {
        uint8_t due[3];
        due_colour(&r->engine->scene, f, i, due);
        wrong += memcmp(due, &got.rgb[3 * (size_t)i], 3) != 0;
    }
    frames_seen++;
    CHECK(wrong == 0, "%s: %u pixels of %u x %u, shader %u", what, wrong, f->width, f->height,
          f->shader);
    free(got.rgb);
}

static void set_shader(plt_frame *f, random_state *r) {
    f->shader = (uint8_t)random_below(r, 3);
}

static const frame_scenes scenes = {.side_most = SIDE_MOST, .set = set_shader, .each = one_frame};

int main(void) {
    test("frames of cameras anywhere have the colours of their rays' hits");
    frame_scenes_anywhere(&scenes);
    test("so have views straight down on grids");
    frame_scenes_down(&scenes);
    CHECK(frames_seen > (rig_is_tiny() ? 100u : 200u) &&
              pixels_hit > (rig_is_tiny() ? 1000u : 100000u),
          "%u frames, %u pixels that hit", frames_seen, pixels_hit);
    return test_done();
}

#else

int main(void) {
    return test_done();
}

#endif
