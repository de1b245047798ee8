/* test_samples - pixels of several samples have the mean of their rays' colours
 *
 * Each sample's ray is traced, and its hit shaded, alone: along the ray through its pixel's middle,
 * as what a triangle's colour in a pixel is does not depend on which samples hit it. The mean of
 * these is sought here among all 256 bytes by whole numbers, from the light of each in double. All
 * of it for cameras anywhere and views straight down on grids, of packets of every size, and
 * cropped. The same picture comes from every format, in any order, and a step at a time.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/engine.h"
#include "engine/shade/light.h"
#include "engine/shade/surface.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/frame_scenes.h"
#include "tests/reference/frames.h"
#include "tests/reference/random.h"
#include "tests/reference/rig.h"
#include "tests/reference/samples.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

#if PLT_WITH_GROUPS && PLT_WITH_SAMPLES

enum { SIDE_MOST = 40, RAYS_MOST = 16 * SIDE_MOST * SIDE_MOST };

static plt_ray rays[RAYS_MOST];
static plt_hit hits[RAYS_MOST];
static uint32_t frames_seen, pixels_mixed, pixels_refined;

/* ---- the mean ------------------------------------------------------------------------ */

static double light_of(int byte) {
    const double x = byte / 255.0;
    return x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4);
}

static void check_light(void) {
    double furthest = 0.0;
    for (int b = 0; b < 256; b++) {
        furthest = fmax(furthest, fabs(plt_linear[b] - 65535.0 * light_of(b)));
        CHECK(b == 0 || plt_linear[b] > plt_linear[b - 1], "byte %d", b);
    }
    CHECK(furthest <= 0.5, "off by %.3f of 65535", furthest);
    CHECK(plt_linear[0] == 0 && plt_linear[255] == 65535, "black and white");
}

static void check_mean(const uint8_t (*of)[3], uint32_t samples) {
    uint8_t due[3], got[3];
    plt_mix m;
    plt_mix_begin(&m, 0);
    for (uint32_t i = 0; i < samples; i++) {
        plt_mix_add(&m, of[i], 1);
    }
    plt_mix_get(&m, samples, got);
    samples_mean(samples, of, due);
    CHECK(memcmp(got, due, 3) == 0, "%u samples: %u %u %u, due %u %u %u", samples, got[0], got[1],
          got[2], due[0], due[1], due[2]);
}

/* Of every pair of bytes, in every proportion that four samples have; and of sixteen at random. */
static void check_means(void) {
    uint8_t of[16][3];
    random_state r = {3};
    for (uint32_t i = 0; i < 256 * 256 * 3; i++) {
        for (uint32_t k = 0; k < 4; k++) {
            memset(of[k], (int)(k <= i % 3 ? i / 3 % 256 : i / 3 / 256), 3);
        }
        check_mean((const uint8_t(*)[3])of, 4);
    }
    for (uint32_t i = 0; i < 2000; i++) {
        for (uint32_t k = 0; k < 48; k++) {
            of[k / 3][k % 3] = (uint8_t)random_below(&r, 256);
        }
        check_mean((const uint8_t(*)[3])of, 16);
    }
    for (int b = 0; b < 256; b++) {
        memset(of, b, sizeof of);
        uint8_t mean[3];
        samples_mean(16, (const uint8_t(*)[3])of, mean);
        CHECK(mean[0] == b, "equal colours have themselves for a mean: %d", b);
        check_mean((const uint8_t(*)[3])of, 16);
    }
}

/* ---- the pattern --------------------------------------------------------------------- */

/* In 1 / across of a pixel's side, no two share a column or a row. */
static void check_pattern(void) {
    for (uint32_t across = 2; across <= 4; across *= 2) {
        const uint32_t n = across * across;
        unsigned columns = 0, rows = 0;
        plt_frame f = {.width = 8, .height = 6, .camera = {.look = {0, 0, -1}, .up = {0, 1, 0}}};
        plt_view v;
        f.camera.tan_half_fov = 0.5f;
        CHECK(plt_view_set(&v, &f) == PLT_OK, "a view");
        const plt_view middle = v;
        plt_view_refine(&v, across);
        for (uint32_t i = 0; i < n; i++) {
            const float x = plt_view_x(&v, i % across, i / across);
            const float y = plt_view_y(&v, i % across, i / across);
            const float half = 0.5f * (float)(n - 1) / (float)across;
            const float at_x = (x - 0.5f * (float)(across - 1) + half) * (float)across;
            const float at_y = (y - 0.5f * (float)(across - 1) + half) * (float)across;
            CHECK(at_x == floorf(at_x) && at_x >= 0 && at_x < (float)n, "column %g", (double)at_x);
            CHECK(at_y == floorf(at_y) && at_y >= 0 && at_y < (float)n, "row %g", (double)at_y);
            columns |= 1u << (unsigned)at_x;
            rows |= 1u << (unsigned)at_y;
        }
        CHECK(columns == (1u << n) - 1 && rows == columns, "%u samples: %x %x", n, columns, rows);
        float mean[3] = {0, 0, 0}, due[3];
        for (uint32_t i = 0; i < n; i++) {
            float dir[3];
            plt_view_direction(&v, 3 * across + i % across, 2 * across + i / across, dir);
            for (int a = 0; a < 3; a++) {
                mean[a] += dir[a] / (float)n;
            }
        }
        plt_view_direction(&middle, 3, 2, due);
        for (int a = 0; a < 3; a++) {
            CHECK(fabsf(mean[a] - due[a]) < 1e-6f, "around the pixel's middle");
        }
    }
}

/* ---- frames ---------------------------------------------------------------------------- */

#if PLT_WITH_DIAGRAMS
/* By the eye's distances from the box, in double, and rounded as the engine does. */
static void due_depth(const plt_engine *e, const plt_frame *f, uint32_t ray, uint8_t rgb[3]) {
    plt_depths d;
    plt_depths_set(&d, &e->scene.box, f->camera.eye);
    double nearest = 0.0, farthest = 0.0, along = 0.0;
    for (int a = 0; a < 3; a++) {
        const double lo = (double)e->scene.box.lo[a] - (double)f->camera.eye[a];
        const double hi = (double)e->scene.box.hi[a] - (double)f->camera.eye[a];
        nearest += lo > 0.0 ? lo * lo : (hi < 0.0 ? hi * hi : 0.0);
        farthest += fmax(lo * lo, hi * hi);
        along += (double)rays[ray].dir[a] * (double)rays[ray].dir[a];
    }
    CHECK(fabs((double)d.nearest - sqrt(nearest)) <= 1e-6 * sqrt(farthest) &&
              fabs((double)d.farthest - sqrt(farthest)) <= 1e-6 * sqrt(farthest),
          "distances to the box");
    plt_depth_colour(&d, rays[ray].dir, hits[ray].t, rgb);
    const double grey = 255.0 * (sqrt(farthest) - (double)hits[ray].t * sqrt(along)) /
                        (sqrt(farthest) - sqrt(nearest));
    CHECK(fabs((double)rgb[0] - grey) <= 0.51 && rgb[1] == rgb[0] && rgb[2] == rgb[0],
          "grey %u for %.3f", rgb[0], grey);
}
#endif

static void due_colour(const plt_engine *e, const plt_frame *f, const plt_view *middle,
                       uint32_t pixel, uint32_t ray, uint8_t rgb[3]) {
    const uint32_t x = pixel % f->width, y = pixel / f->width;
    const int is_hit = hits[ray].triangle != PLT_MISS;
#if PLT_WITH_DIAGRAMS
    if (f->shader == PLT_SHADE_DEPTH) {
        memset(rgb, 0, 3);
        if (is_hit) {
            due_depth(e, f, ray, rgb);
        }
        return;
    }
#endif
    if (!is_hit) {
        plt_surface_sky(f, y, rgb);
        return;
    }
    float corner[3][3], normal[3], dir[3];
    plt_surface surface;
    plt_record_corners(frame_scenes_record(&e->scene, hits[ray].triangle), corner);
    plt_hit_normal((const float(*)[3])corner, normal);
    plt_view_direction(middle, x, y, dir);
    plt_surface_set(&surface, normal);
    plt_surface_colour(&surface, f->shader, hits[ray].triangle, dir, rgb);
}

/* All samples of a frame, traced alone: the colours of its pixels, and which of them are mixed. */
static void due_frame(plt_engine *e, const plt_frame *f, uint32_t across, uint8_t *rgb,
                      uint8_t *mixed) {
    plt_view middle, view;
    const uint32_t n = across * across, count = (uint32_t)f->width * f->height;
    plt_view_set(&middle, f);
    view = middle;
    plt_view_refine(&view, across);
    for (uint32_t i = 0; i < n * count; i++) {
        const uint32_t x = i / n % f->width, y = i / n / f->width;
        memcpy(rays[i].org, view.eye, sizeof rays[i].org);
        plt_view_direction(&view, across * x + i % n % across, across * y + i % n / across,
                           rays[i].dir);
        rays[i].tmin = 0.0f;
        rays[i].tmax = PLT_VIEW_FAR;
    }
    CHECK(plt_trace(e, rays, hits, n * count, 0) == PLT_OK, "rays of samples");
    for (uint32_t i = 0; i < count; i++) {
        uint8_t of[16][3], most = 0;
        for (uint32_t k = 0; k < n; k++) {
            due_colour(e, f, &middle, i, n * i + k, of[k]);
            for (uint32_t j = 0; j < 3 * k; j++) {
                const int apart = abs(of[j / 3][j % 3] - of[k][j % 3]);
                most = apart > most ? (uint8_t)apart : most;
            }
        }
        mixed[i] = most > PLT_SAMPLES_ALIKE;
        samples_mean(n, (const uint8_t(*)[3])of, rgb + 3 * i);
    }
}

static uint8_t due[3 * SIDE_MOST * SIDE_MOST], finer[3 * SIDE_MOST * SIDE_MOST];
static uint8_t mixed[SIDE_MOST * SIDE_MOST], unused[SIDE_MOST * SIDE_MOST];

/* Whether each pixel of a frame has its colour. */
static void one_frame(const rig *r, const plt_frame *f, const char *what) {
    plt_view view;
    if (r->engine == NULL || plt_view_set(&view, f) != PLT_OK) {
        return;
    }
    const uint32_t side = plt_packet_side(r->engine), count = (uint32_t)f->width * f->height;
    const int adapts = f->samples == PLT_SAMPLES_ADAPTIVE;
    frame_result got = frame_render(r->engine, f, 1 + frames_seen % 50);
    if (side == 2 && (adapts || f->samples == 16)) {
        CHECK(got.status == PLT_ERR_ARGUMENT, "%s: more samples than a packet has", what);
        free(got.rgb);
        return;
    }
    CHECK(got.status == PLT_OK && got.wrong == 0, "%s: status %d", what, got.status);
    due_frame(r->engine, f, f->samples == 16 ? 4 : 2, due, mixed);
    if (adapts) {
        due_frame(r->engine, f, 4, finer, unused);
    }
    uint32_t wrong = 0;
    for (uint32_t i = 0; i < count; i++) {
        const int is_finer = adapts && mixed[i];
        wrong += memcmp(is_finer ? finer + 3 * i : due + 3 * i, &got.rgb[3 * (size_t)i], 3) != 0;
        pixels_mixed += mixed[i];
        pixels_refined += (uint32_t)is_finer;
    }
    frames_seen++;
    CHECK(wrong == 0, "%s: %u pixels of %u x %u, %u samples, shader %u, packets of %u", what, wrong,
          f->width, f->height, f->samples, f->shader, side);
    free(got.rgb);
}

static void set_samples(plt_frame *f, random_state *r) {
    static const uint8_t samples[3] = {4, 16, PLT_SAMPLES_ADAPTIVE};
    const uint32_t shader = random_below(r, PLT_WITH_DIAGRAMS ? 4 : 3);
    f->shader = (uint8_t)(shader == 3 ? PLT_SHADE_DEPTH : shader);
    f->samples = samples[random_below(r, 3)];
#if PLT_WITH_BACKGROUND
    static const uint8_t pink[3] = {250, 3, 77};
    f->has_background = (uint8_t)random_below(r, 2);
    memcpy(f->background, pink, sizeof pink);
#endif
}

static const frame_scenes scenes = {.side_most = SIDE_MOST, .set = set_samples, .each = one_frame};

/* ---- formats and orders -------------------------------------------------------------------- */

static plt_frame sphere_frame(uint8_t samples, uint8_t shader) {
    const plt_frame f = {.width = 45,
                         .height = 38,
                         .shader = shader,
                         .samples = samples,
                         .camera = {.eye = {0.4f, 0.9f, 2.6f},
                                    .look = {0.1f, 0.0f, 0.0f},
                                    .up = {0, 1, 0},
                                    .tan_half_fov = 0.45f}};
    return f;
}

/* The hash of a frame; PLT_ERR_ARGUMENT where there can be none. */
static void same_hash(const rig *r, const plt_frame *f, uint64_t wanted, const char *what) {
    if (r->engine != NULL) {
        const uint64_t got = frame_hash(r->engine, f, 3);
        CHECK(got == wanted, "%s: %u samples, shader %u", what, f->samples, f->shader);
        frames_seen++;
    }
}

static void compact(const mesh *m, const plt_frame *f) {
    compact_config config = compact_config_of(2, 21, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    rig resident, other;
    if (compact_open(&resident, m, &config) != PLT_OK) {
        CHECK(rig_is_tiny(), "%s", resident.fault.message);
        rig_close(&resident);
        return;
    }
    const uint64_t wanted = frame_hash(resident.engine, f, 7);
    config.run.residency = PLT_RESIDENCY_STREAMED;
    config.run.store_bytes = PLT_STORE_LEAST;
    compact_open(&other, m, &config);
    same_hash(&other, f, wanted, "streamed");
    rig_close(&other);
    config.run.schedule = PLT_SCHEDULE_BATCH;
    config.run.batch = 5;
    config.run.packet_side = PLT_PACKET_SIDE_MAX < 8 ? PLT_PACKET_SIDE_MAX : 8;
    compact_open(&other, m, &config);
    if (f->samples != PLT_SAMPLES_ADAPTIVE) {
        same_hash(&other, f, wanted, "in batches");
    } else if (other.engine != NULL) {
        CHECK(plt_render_begin(other.engine, f) == PLT_ERR_ARGUMENT, "batches do not adapt");
    }
    rig_close(&other);
    config.run.schedule = PLT_SCHEDULE_TASK;
    compact_open(&other, m, &config);
    if (f->samples != PLT_SAMPLES_ADAPTIVE) {
        same_hash(&other, f, wanted, "by tasks");
    } else if (other.engine != NULL) {
        CHECK(plt_render_begin(other.engine, f) == PLT_ERR_ARGUMENT, "tasks do not adapt");
    }
    rig_close(&other);
    rig_close(&resident);
}

static void thesis(const mesh *m, const plt_frame *f) {
    rig_config config = rig_config_of(2, 16, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    rig first, other;
    if (rig_open(&first, m, &config) != PLT_OK) {
        CHECK(rig_is_tiny(), "%s", first.fault.message);
        rig_close(&first);
        return;
    }
    const uint64_t wanted = frame_hash(first.engine, f, 1000);
    config.run.structure = PLT_STRUCTURE_GRID;
    rig_open_spare(&other, m, &config, 100000);
    same_hash(&other, f, wanted, "a grid");
    rig_close(&other);
    config.run.structure = PLT_STRUCTURE_TREE;
    config.run.order = PLT_ORDER_TWO_STAGE;
    config.run.packet_side = PLT_PACKET_SIDE_MAX < 4 ? PLT_PACKET_SIDE_MAX : 4;
    rig_open(&other, m, &config);
    same_hash(&other, f, wanted, "two stages");
    rig_close(&other);
    rig_close(&first);
}

static void everywhere(void) {
    static const uint8_t samples[3] = {4, 16, PLT_SAMPLES_ADAPTIVE};
    CHECK(PLT_PACKET_SIDE_MAX >= 4 || rig_is_tiny(), "packets of 4 x 4 rays");
    if (PLT_PACKET_SIDE_MAX < 4) {
        return;
    }
    mesh m = {0};
    shape_icosphere(&m, rig_is_tiny() ? 1 : 2);
    for (unsigned i = 0; i < 6; i++) {
        const plt_frame f =
            sphere_frame(samples[i % 3], i < 3 ? PLT_SHADE_EYELIGHT : PLT_SHADE_DEPTH);
        if (PLT_WITH_DIAGRAMS || f.shader == 0) {
            compact(&m, &f);
            thesis(&m, &f);
        }
    }
    mesh_free(&m);
}

/* ---- one sample, and none -------------------------------------------------------------------- */

static void one_sample(void) {
    mesh m = {0};
    shape_icosphere(&m, rig_is_tiny() ? 1 : 2);
    const rig_config config = rig_config_of(2, 16, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    rig r;
    if (rig_open(&r, &m, &config) == PLT_OK) {
        plt_frame f = sphere_frame(0, PLT_SHADE_EYELIGHT);
        const uint64_t none = frame_hash(r.engine, &f, 9);
        f.samples = PLT_SAMPLES_ONE;
        CHECK(frame_hash(r.engine, &f, 9) == none, "0 and 1 are the same");
        for (unsigned n = 2; n < 256; n++) {
            f.samples = (uint8_t)n;
            const int is_known = n == 4 || ((n == 16 || n == 255) && PLT_PACKET_SIDE_MAX >= 4);
            CHECK(plt_render_begin(r.engine, &f) == (is_known ? PLT_OK : PLT_ERR_ARGUMENT),
                  "%u samples", n);
        }
    }
    rig_close(&r);
    mesh_free(&m);
}

int main(void) {
    test("the light of a byte is that of sRGB, to half of a 65,535th");
    check_light();
    test("the mean is the byte whose light is nearest to the mean of theirs");
    check_means();
    test("no two samples of a pixel share a row or a column, and their middle is the pixel's");
    check_pattern();
    test("frames of cameras anywhere have the mean of their samples' hits");
    frame_scenes_anywhere(&scenes);
    test("so have views straight down on grids");
    frame_scenes_down(&scenes);
    test("every format, order and schedule gives the same pictures");
    everywhere();
    test("one sample is what 0 is, and other numbers are refused");
    one_sample();
    const int has_few = PLT_PACKET_SIDE_MAX < 4;
    CHECK(frames_seen > (has_few ? 20u : 100u) && pixels_mixed > (rig_is_tiny() ? 100u : 10000u) &&
              (has_few || pixels_refined > 500),
          "%u frames, %u pixels mixed, %u of 16 samples for that", frames_seen, pixels_mixed,
          pixels_refined);
    return test_done();
}

#else

int main(void) {
    return test_done();
}

#endif
