/* test_render_rays - frames have the colours of the hits that plt_trace finds for their rays
 *
 * Each pixel's ray is traced, and its hit shaded, alone: for cameras anywhere, and views straight
 * down on grids, whose corners and edges lie on pixels, so that no sieve is sure of them. Of every
 * size of packet, of squares that are cropped, too, and of shaders by normals and by triangles.
 * With all that passes the sieve taken for sure (triangle_sieve.h) frames differ; with what is
 * beyond 0 instead of the slack none does: it is for the worst of many roundings at once.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/engine.h"
#include "engine/shade/surface.h"
#include "engine/trace/triangle_ray.h"
#include "tests/reference/frames.h"
#include "tests/reference/random.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

#if PLT_WITH_GROUPS && PLT_WITH_BEAMS

enum { SIDE_MOST = 96 };

static plt_ray rays[SIDE_MOST * SIDE_MOST];
static plt_hit hits[SIDE_MOST * SIDE_MOST];
static uint32_t pixels_hit, frames_seen;

static const plt_record *record_of(const plt_scene *s, uint32_t id) {
    const plt_record *r = s->format == PLT_FORMAT_LIST ? s->list.records : s->thesis.records;
    while (plt_primitive_id(plt_get_u32(&r->word[9])) != id) {
        r++;
    }
    return r;
}

static void due_colour(const plt_scene *s, const plt_frame *f, uint32_t pixel, uint8_t rgb[3]) {
    if (hits[pixel].triangle == PLT_MISS) {
        plt_surface_sky(f, pixel / f->width, rgb);
        return;
    }
    float corner[3][3], normal[3];
    plt_surface surface;
    plt_record_corners(record_of(s, hits[pixel].triangle), corner);
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

static rig opened(const mesh *m, random_state *r) {
    rig_config config = rig_config_of(1 + random_below(r, 4), 16, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    rig opened;
    config.run.packet_side = (uint8_t)(2u << random_below(r, 4));
    if (config.run.packet_side > PLT_PACKET_SIDE_MAX) {
        config.run.packet_side = PLT_PACKET_SIDE_MAX;
    }
    const int status = rig_open(&opened, m, &config);
    CHECK(status == PLT_OK || (status == PLT_ERR_LIMIT && rig_is_tiny()), "%s",
          opened.fault.message);
    return opened;
}

static void cameras(const mesh *m, uint32_t frames, const char *what) {
    random_state r = {frames};
    for (uint32_t i = 0; i < frames; i++) {
        rig scene = opened(m, &r);
        plt_frame f = {.width = (uint16_t)(1 + random_below(&r, SIDE_MOST)),
                       .height = (uint16_t)(1 + random_below(&r, SIDE_MOST)),
                       .shader = (uint8_t)random_below(&r, 3)};
        const float away = random_below(&r, 3) ? 3.0f : 0.9f; /* outside, or inside */
        for (int a = 0; a < 3; a++) {
            f.camera.eye[a] = away * random_float(&r, -1.0f, 1.0f);
            f.camera.look[a] = random_float(&r, -0.5f, 0.5f);
        }
        f.camera.up[random_below(&r, 3)] = 1.0f;
        f.camera.tan_half_fov = tanf(random_float(&r, 0.05f, 1.2f));
        one_frame(&scene, &f, what);
        rig_close(&scene);
    }
}

static void anywhere(void) {
    mesh m = {0};
    shape_soup(&m, rig_triangles(300, 1), 0.4f, 1);
    cameras(&m, 40, "large triangles");
    mesh_free(&m);
    shape_soup(&m, rig_triangles(3000, 1), 0.04f, 2);
    cameras(&m, 40, "small triangles");
    mesh_free(&m);
    shape_icosphere(&m, rig_is_tiny() ? 1 : 3);
    cameras(&m, 40, "a sphere");
    mesh_free(&m);
    shape_needles(&m, rig_triangles(200, 1) / 4);
    cameras(&m, 40, "slivers");
    mesh_free(&m);
    shape_coincident(&m, 5);
    shape_degenerate(&m);
    cameras(&m, 30, "odd triangles");
    mesh_free(&m);
}

/* Down on two sheets of squares, the upper one moved, that lie on or close above one another. */
static void down(void) {
    static const float apart[4] = {0.0f, 1e-6f, 1e-3f, 0.1f};
    random_state r = {7};
    for (uint32_t i = 0; i < 96; i++) {
        mesh m = {0};
        const float moved = random_below(&r, 2) ? 0.0f : 0.25f;
        shape_sheet(&m, 4, 1);
        shape_transform(&m, 1.0f, moved, apart[i % 4], moved);
        shape_sheet(&m, 4, 1);
        rig scene = opened(&m, &r);
        const float x = 0.25f * (float)random_below(&r, 9) - 1.0f, height = (i & 8) ? 2.0f : -1.37f;
        const plt_frame f = {.width = (uint16_t)(32 + random_below(&r, 33)),
                             .height = (uint16_t)(32 + random_below(&r, 33)),
                             .shader = (uint8_t)(i % 3),
                             .camera = {.eye = {x, height, 0.0f},
                                        .look = {x, 0.0f, 0.0f},
                                        .up = {0, 0, 1},
                                        .tan_half_fov = (i & 16) ? 0.5f : 1.0f}};
        one_frame(&scene, &f, "sheets");
        rig_close(&scene);
        mesh_free(&m);
    }
}

int main(void) {
    test("frames of cameras anywhere have the colours of their rays' hits");
    anywhere();
    test("so have views straight down on grids");
    down();
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
