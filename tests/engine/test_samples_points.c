/* test_samples_points - samples with lights, and by normals of corners, have their own rays'
 * colours
 *
 * Each sample's ray goes alone, as a packet of one, through lights, mirrors and glass, or is traced
 * by plt_trace and coloured by what its corners have; the mean of these is sought as in
 * test_samples. For cameras along an axis, whose directions are exact, the samples are also those
 * of a frame of one sample whose lines are 4 or 16 times as close, which knows nothing of samples.
 * Pictures are the same of every packet, step, order and image, and on every machine.
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/base/srgb.h"
#include "engine/engine.h"
#include "engine/shade/smooth.h"
#include "engine/shade/surface.h"
#include "engine/whitted/lights.h"
#include "engine/whitted/whitted.h"
#include "tests/reference/frames.h"
#include "tests/reference/lit_rig.h"
#include "tests/reference/random.h"
#include "tests/reference/samples.h"
#include "tests/reference/surface_rig.h"
#include "tests/test.h"

#if PLT_WITH_GROUPS && PLT_WITH_SAMPLES && PLT_WITH_WHITTED && PLT_WITH_SURFACE

enum { BOUNCES = 3, PIXELS_MOST = 32 * 32 };

static const uint8_t all_samples[3] = {PLT_SAMPLES_FOUR, PLT_SAMPLES_SIXTEEN, PLT_SAMPLES_ADAPTIVE};

static uint8_t due[3 * PIXELS_MOST], finer[3 * PIXELS_MOST];
static uint8_t mixed[PIXELS_MOST], unused[PIXELS_MOST];
static uint32_t pixels_seen, pixels_mixed, pixels_refined;

/* ---- a sample alone ------------------------------------------------------------------ */

/* The light that a ray through lights, mirrors and glass brings, the only one of its packet. */
static void lit_colour(plt_engine *e, const plt_frame *f, const float dir[3], uint8_t turn,
                       uint8_t rgb[3]) {
    plt_whitted *w = e->rendering.whitted;
    f4 org[3], along[3];
    int status = PLT_MORE;
    for (uint32_t k = 1; k < w->pixels; k++) {
        plt_whitted_pixel_none(w, k);
    }
    plt_whitted_pixel_set(w, 0, dir, turn);
    plt_packet_begin(&e->packet, w->box, 1, 0);
    plt_packet_want_normals(&e->packet);
    for (int a = 0; a < 3; a++) {
        org[a] = f4_all(f->camera.eye[a]);
        along[a] = f4_all(dir[a]);
    }
    plt_packet_set_group(&e->packet, 0, org, along, f4_zero(), f4_all(PLT_VIEW_FAR), 1);
    plt_packet_finish(&e->packet);
    plt_traversal_begin(&e->traversal, &e->packet, 1);
    plt_whitted_begin(w, &e->packet, 1);
    while (status == PLT_MORE) {
        status = plt_whitted_step(w, &e->traversal, &e->packet, 100000);
    }
    CHECK(status == PLT_OK, "%d", status);
    if (f->has_background && w->pixel[0].ray.is_sky) {
        memcpy(rgb, f->background, 3);
        return;
    }
    for (int c = 0; c < 3; c++) {
        rgb[c] = plt_srgb_byte(w->pixel[0].colour[c]);
    }
}

static void smooth_colour(plt_engine *e, const plt_frame *f, const float dir[3], uint32_t y,
                          uint8_t rgb[3]) {
    plt_ray ray = {.tmax = PLT_VIEW_FAR};
    plt_surface_point point;
    plt_hit hit;
    memcpy(ray.org, f->camera.eye, sizeof ray.org);
    memcpy(ray.dir, dir, sizeof ray.dir);
    CHECK(plt_trace(e, &ray, &hit, 1, 0) == PLT_OK, "a ray");
    if (hit.triangle == PLT_MISS) {
        plt_surface_sky(f, y, rgb);
    } else {
        CHECK(plt_surface_at(e, &hit, &point) == PLT_OK, "a point");
        plt_smooth_colour(&point, dir, rgb);
    }
}

/* ---- a frame of them ------------------------------------------------------------------- */

/* The mean of a pixel, and whether its colours are not alike. */
static uint8_t mean_of(uint32_t samples, const uint8_t (*of)[3], uint8_t rgb[3]) {
    int most = 0;
    for (uint32_t i = 0; i < 3 * samples; i++) {
        for (uint32_t k = 0; k < i / 3; k++) {
            const int apart = abs(of[i / 3][i % 3] - of[k][i % 3]);
            most = apart > most ? apart : most;
        }
    }
    samples_mean(samples, of, rgb);
    return most > PLT_SAMPLES_ALIKE;
}

/* All samples alone; a frame of that kind has been begun. */
static void due_frame(plt_engine *e, const plt_frame *f, uint32_t across, uint8_t *rgb,
                      uint8_t *are_mixed) {
    const uint32_t n = across * across;
    plt_view view;
    plt_view_set(&view, f);
    plt_view_refine(&view, across);
    for (uint32_t i = 0; i < (uint32_t)f->width * f->height; i++) {
        uint8_t of[16][3];
        for (uint32_t k = 0; k < n; k++) {
            const uint32_t x = across * (i % f->width) + k % across;
            const uint32_t y = across * (i / f->width) + k / across;
            float dir[3];
            plt_view_direction(&view, x, y, dir);
            if (f->shader == PLT_SHADE_WHITTED) {
                lit_colour(e, f, dir, plt_light_turn(x, y), of[k]);
            } else {
                smooth_colour(e, f, dir, i / f->width, of[k]);
            }
        }
        are_mixed[i] = mean_of(n, (const uint8_t(*)[3])of, rgb + 3 * i);
    }
}

/* The frame is what `due` is, and where that is `mixed` and it adapts what `finer` is. */
static void same_pixels(const plt_frame *f, const frame_result *got, const char *what) {
    const int adapts = f->samples == PLT_SAMPLES_ADAPTIVE;
    uint32_t wrong = 0;
    for (uint32_t i = 0; i < (uint32_t)f->width * f->height; i++) {
        const int is_finer = adapts && mixed[i];
        wrong += memcmp((is_finer ? finer : due) + 3 * i, got->rgb + 3 * (size_t)i, 3) != 0;
        pixels_mixed += mixed[i];
        pixels_refined += (uint32_t)is_finer;
        pixels_seen++;
    }
    CHECK(got->status == PLT_OK && got->wrong == 0 && wrong == 0,
          "%s: %u pixels of %u x %u, %u samples, shader %u", what, wrong, f->width, f->height,
          f->samples, f->shader);
}

static uint32_t across_of(uint8_t samples) {
    return samples == PLT_SAMPLES_SIXTEEN ? 4 : 2;
}

static int is_refused(const plt_engine *e, uint8_t samples) {
    return plt_packet_side(e) == 2 && samples != PLT_SAMPLES_FOUR;
}

static void alone(plt_engine *e, plt_frame *f, const char *what) {
    for (int i = 0; i < 3; i++) {
        f->samples = all_samples[i];
        if (is_refused(e, f->samples)) {
            CHECK(plt_render_begin(e, f) == PLT_ERR_ARGUMENT, "more samples than a packet has");
            continue;
        }
        frame_result got = frame_render(e, f, i == 0 ? 1 : 1000);
        due_frame(e, f, across_of(f->samples), due, mixed);
        if (f->samples == PLT_SAMPLES_ADAPTIVE) {
            due_frame(e, f, 4, finer, unused);
        }
        same_pixels(f, &got, what);
        free(got.rgb);
    }
}

/* The samples of a frame, of one whose lines are across^2 times as close: sample (i, j) is in its
 * column across * i - j + across - 1 and row across * j + i of the pixel's. */
static void pick(const plt_frame *f, const uint8_t *close, uint32_t across, uint8_t *rgb,
                 uint8_t *are_mixed) {
    const uint32_t n = across * across, width = n * f->width;
    for (uint32_t i = 0; i < (uint32_t)f->width * f->height; i++) {
        uint8_t of[16][3];
        for (uint32_t k = 0; k < n; k++) {
            const uint32_t column = across * (k % across) + across - 1 - k / across;
            const uint32_t row = across * (k / across) + k % across;
            const size_t at = (size_t)(n * (i / f->width) + row) * width + n * (i % f->width);
            memcpy(of[k], close + 3 * (at + column), 3);
        }
        are_mixed[i] = mean_of(n, (const uint8_t(*)[3])of, rgb + 3 * i);
    }
}

static void from_close_lines(plt_engine *e, const plt_frame *f, uint32_t across, uint8_t *rgb,
                             uint8_t *are_mixed) {
    plt_frame close = *f;
    close.width = (uint16_t)(across * across * f->width);
    close.height = (uint16_t)(across * across * f->height);
    close.samples = PLT_SAMPLES_ONE;
    frame_result lines = frame_render(e, &close, 1000);
    CHECK(lines.status == PLT_OK && lines.wrong == 0, "a frame of close lines");
    pick(f, lines.rgb, across, rgb, are_mixed);
    free(lines.rgb);
}

static void among_lines(plt_engine *e, plt_frame *f, const char *what) {
    for (int i = 0; i < 3; i++) {
        f->samples = all_samples[i];
        if (is_refused(e, f->samples)) {
            continue;
        }
        frame_result got = frame_render(e, f, 1000);
        from_close_lines(e, f, across_of(f->samples), due, mixed);
        if (f->samples == PLT_SAMPLES_ADAPTIVE) {
            from_close_lines(e, f, 4, finer, unused);
        }
        same_pixels(f, &got, what);
        free(got.rgb);
    }
}

/* Directions of sums of few powers of 2: a side that is one, and a tangent of one half. */
static plt_frame axis_frame(uint8_t shader, int axis, float sign, const float eye[3]) {
    const uint16_t side = shader == PLT_SHADE_WHITTED ? 8 : 16;
    plt_frame f = frame_of(eye, eye, side, side, shader);
    f.camera.look[axis] += sign;
    f.camera.up[0] = f.camera.up[1] = f.camera.up[2] = 0.0f;
    f.camera.up[axis == 1 ? 2 : 1] = 1.0f;
    f.camera.tan_half_fov = 0.5f;
    return f;
}

/* ---- scenes ------------------------------------------------------------------------------ */

static rig lit_opened(const lit_scene *s, enum lit_image kind, uint8_t side, uint8_t order,
                      int fetched) {
    rig r = {.engine = NULL};
    const plt_options o = {.packet_side = side, .order = order, .whitted = 1 + BOUNCES};
    const int packs = lit_pack(&r.image, s, kind) == 0;
    CHECK(packs || rig_is_tiny(), "image %u", kind);
    if (packs) {
        const int status = lit_open(&r, &o, fetched);
        CHECK(status == PLT_OK || (status == PLT_ERR_LIMIT && rig_is_tiny()), "%s",
              r.fault.message);
        r.engine = status == PLT_OK ? r.engine : NULL;
    }
    return r;
}

static rig smooth_opened(const mesh *m, const mesh_corners *c, uint8_t build, uint8_t side,
                         uint8_t order, uint8_t structure) {
    const rig_config config = rig_config_of(2, 8, build, PLT_SPLIT_SAH);
    const plt_options o = {
        .packet_side = side, .order = order, .structure = structure, .surface = 1};
    rig r;
    const packed image = surface_rig_image(m, c, &config.pack);
    const plt_source source = rig_source(&image);
    const int status = surface_rig_open(&r, image, &source, &o);
    CHECK(status == PLT_OK || (status == PLT_ERR_LIMIT && rig_is_tiny()), "%s", r.fault.message);
    r.engine = status == PLT_OK ? r.engine : NULL;
    return r;
}

static uint8_t side_of(int i) {
    const unsigned side = 2u << i % 4;
    return (uint8_t)(side > PLT_PACKET_SIDE_MAX ? PLT_PACKET_SIDE_MAX : side);
}

static void lights_alone(const lit_scene *s) {
    static const float eye[3] = {0.6f, 3.0f, 8.0f}, look[3] = {0, 0.8f, 0};
    const plt_lighting l = lit_lights(BOUNCES);
    test("samples with soft shadows, mirrors and glass are the mean of rays that go alone");
    for (int i = 0; i < 4; i++) {
        plt_frame f = frame_of(eye, look, 13, 11, PLT_SHADE_WHITTED);
        rig r = lit_opened(s, LIT_LIST, side_of(i), 0, 0);
        if (i % 2) {
            f.has_background = 1;
            f.background[0] = 200;
        }
        f.camera.eye[0] += (float)i;
        CHECK(plt_lighting_set(r.engine, &l) == PLT_OK, "lights");
        alone(r.engine, &f, "with lights");
        rig_close(&r);
    }
}

static void lights_among_lines(const lit_scene *s) {
    static const float eyes[3][3] = {{0.25f, 1.5f, 6.0f}, {-0.5f, 7.0f, 0.25f}, {6, 1.25f, 0.5f}};
    static const int axis[3] = {2, 1, 0};
    plt_lighting l = lit_lights(BOUNCES);
    test("... and the pixels of a frame whose lines are closer");
    for (uint32_t i = 0; i < l.lights; i++) { /* not turned from pixel to pixel */
        l.light[i].radius = 0.0f;
        l.light[i].samples = 1;
    }
    for (int i = 0; i < (rig_is_tiny() ? 1 : 3); i++) {
        plt_frame f = axis_frame(PLT_SHADE_WHITTED, axis[i], -1.0f, eyes[i]);
        rig r = lit_opened(s, LIT_LIST, side_of(i + 1), 0, 0);
        CHECK(plt_lighting_set(r.engine, &l) == PLT_OK, "lights");
        among_lines(r.engine, &f, "close lines with lights");
        rig_close(&r);
    }
}

static void smooth_mesh(mesh *m, mesh_corners *c) {
    shape_icosphere(m, rig_is_tiny() ? 1 : 2);
    shape_cube(m);
    CHECK(mesh_smooth(m, 40, c) == 0, "no memory");
    surface_rig_colour(m, c, 4);
}

static void smooth_alone(const mesh *m, const mesh_corners *c) {
    static const float eye[3] = {2, 1.5f, 3}, look[3] = {0, 0, 0};
    test("samples by normals and colours of corners are the mean of rays that go alone");
    for (int i = 0; i < 8; i++) {
        plt_frame f = frame_of(eye, look, 31, 29, PLT_SHADE_SMOOTH);
        rig r = smooth_opened(m, c, i % 2 ? PLT_BUILD_HOST : PLT_BUILD_NONE, side_of(i),
                              (uint8_t)(i % 2), 0);
        f.camera.eye[1] += 0.5f * (float)i;
        if (r.engine != NULL) {
            alone(r.engine, &f, "smooth");
        }
        rig_close(&r);
    }
}

static void smooth_among_lines(const mesh *m, const mesh_corners *c) {
    static const float eyes[3][3] = {{0.25f, 0.125f, 2}, {0.125f, 2, -0.25f}, {-2, 0.25f, 0.5f}};
    test("... and the pixels of a frame whose lines are closer");
    for (int i = 0; i < 3; i++) {
        plt_frame f =
            axis_frame(PLT_SHADE_SMOOTH, (int[]){2, 1, 0}[i], i == 2 ? 1.0f : -1.0f, eyes[i]);
        f.has_background = 1; /* the sky is of rows of pixels */
        rig r = smooth_opened(m, c, PLT_BUILD_NONE, side_of(i + 1), (uint8_t)(i == 2), 0);
        if (r.engine != NULL) {
            among_lines(r.engine, &f, "close lines, smooth");
        }
        rig_close(&r);
    }
}

/* ---- the same everywhere -------------------------------------------------------------------- */

/* Of every machine, in the order of all_samples. */
static const uint64_t LIT_GOLDEN[3] = {UINT64_C(0xa1a4a033b1d7517b), UINT64_C(0xa613a61aa7500c76),
                                       UINT64_C(0x19eec7b1daff3ffc)};
static const uint64_t SMOOTH_GOLDEN[3] = {
    UINT64_C(0xeebd3093e07a19ee), UINT64_C(0xe6f564553ebf2544), UINT64_C(0x491609aadfe3f701)};

static unsigned hashes(plt_engine *e, plt_frame *f, uint32_t visits, const uint64_t golden[3],
                       const char *what) {
    unsigned compared = 0;
    for (int i = 0; i < 3; i++) {
        f->samples = all_samples[i];
        if (!is_refused(e, f->samples)) {
            const uint64_t hash = frame_hash(e, f, visits);
            CHECK(hash == golden[i] || rig_is_tiny(), "%s, %u samples: %016" PRIx64, what,
                  f->samples, hash);
            compared++;
        }
    }
    return compared;
}

static void lights_everywhere(const lit_scene *s) {
    static const float eye[3] = {0.6f, 3.0f, 8.0f}, look[3] = {0, 0.8f, 0};
    const plt_lighting l = lit_lights(BOUNCES);
    unsigned compared = 0;
    test("pictures with lights are the same of any packet, step, order and image, mapped or not");
    for (unsigned i = 0; i < 4 * LIT_IMAGES; i++) {
        const enum lit_image kind = (enum lit_image)(i % LIT_IMAGES);
        plt_frame f = frame_of(eye, look, 25, 19, PLT_SHADE_WHITTED);
        rig r = lit_opened(s, kind, side_of((int)(i / LIT_IMAGES)),
                           kind == LIT_THESIS && i / LIT_IMAGES % 2, i % 3 == 0);
        if (r.engine != NULL && plt_lighting_set(r.engine, &l) == PLT_OK) {
            compared += hashes(r.engine, &f, i % 4 == 1 ? 1 : 100000, LIT_GOLDEN, "with lights");
        }
        rig_close(&r);
    }
    CHECK(compared >= (rig_is_tiny() ? 2u : 36u), "%u frames", compared);
}

static void smooth_everywhere(const mesh *m, const mesh_corners *c) {
    static const float eye[3] = {2, 1.5f, 3}, look[3] = {0, 0, 0};
    unsigned compared = 0;
    test("smooth pictures are the same of any packet, step, order, build and structure");
    for (unsigned i = 0; i < 3 * 4 * 2; i++) {
        const uint8_t build = rig_is_tiny() ? PLT_BUILD_NONE : (uint8_t)(i % 3);
        const uint8_t structure = (uint8_t)(i % 8 == 5);
        plt_frame f = frame_of(eye, look, 33, 37, PLT_SHADE_SMOOTH);
        rig r = smooth_opened(m, c, build, side_of((int)(i / 3)), (uint8_t)(structure ? 0 : i / 12),
                              structure);
        if (r.engine != NULL) {
            compared += hashes(r.engine, &f, i % 2 ? 1 : 100000, SMOOTH_GOLDEN, "smooth");
        }
        rig_close(&r);
    }
    CHECK(compared >= (rig_is_tiny() ? 2u : 60u), "%u frames", compared);
}

int main(void) {
    lit_scene s;
    mesh m = {0};
    mesh_corners c = {0};
    lit_scene_make(&s);
    smooth_mesh(&m, &c);
    lights_alone(&s);
    lights_among_lines(&s);
    smooth_alone(&m, &c);
    smooth_among_lines(&m, &c);
    lights_everywhere(&s);
    smooth_everywhere(&m, &c);
    const int has_few = PLT_PACKET_SIDE_MAX < 4;
    CHECK(pixels_seen > 1000 && pixels_mixed > 500 && (has_few || pixels_refined > 1000),
          "%u pixels, %u mixed, %u of 16 samples for that", pixels_seen, pixels_mixed,
          pixels_refined);
    corners_free(&c);
    mesh_free(&m);
    lit_scene_free(&s);
    return test_done();
}

#else

int main(void) {
    return test_done();
}

#endif
