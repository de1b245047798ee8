/* test_texture_smooth - textures of frames without lights: pixel by pixel what corners, texel and
 * eye light make of them, and the same from mapped images and fetched ones, by packets of any size
 * or by beams, with room for lights or without, on every machine
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "engine/engine.h"
#include "tests/reference/frames.h"
#include "tests/reference/texture_rig.h"
#include "tests/test.h"

enum { WIDTH = 64, HEIGHT = 48 };

static const plt_options textured = {
    .packet_side = 2, .surface = 1, .textures = PLT_TEXTURES_BILINEAR};

static const plt_frame frame = {
    .camera = {.eye = {1, 4, 9}, .look = {0, 0.5f, 0}, .up = {0, 1, 0}, .tan_half_fov = 0.6f},
    .width = WIDTH,
    .height = HEIGHT,
    .shader = PLT_SHADE_SMOOTH};

static plt_engine *open_scene(rig *r, const texture_scene *s, const plt_options *options,
                              int fetched) {
    *r = (rig){.image = s->image};
    CHECK(lit_open(r, options, fetched) == PLT_OK, "%s", r->fault.message);
    return r->engine;
}

static uint64_t hash_of(const texture_scene *s, const plt_options *options, int fetched,
                        const plt_frame *f, plt_texture_stats *stats) {
    rig r;
    plt_engine *e = open_scene(&r, s, options, fetched);
    const uint64_t hash = frame_hash(e, f, 1000);
    plt_texture_stats_get(e, stats);
    free(r.arena);
    return hash;
}

/* ---- all ways ------------------------------------------------------------------------ */

enum { KINDS = 4, PAGED = 3 };

static uint64_t by_all_ways(const texture_scene s[KINDS], uint8_t filter, uint8_t samples) {
    plt_frame f = frame;
    uint64_t first = 0;
    f.samples = samples;
    for (unsigned i = 0; i < 6 * KINDS; i++) {
        const unsigned way = i / KINDS;
        plt_options o = textured;
        plt_texture_stats stats = {0};
        o.residency = i % KINDS == PAGED ? PLT_RESIDENCY_STREAMED : PLT_RESIDENCY_WHOLE;
        o.packet_side = samples > 1 ? 4 : 2;
        o.packet_side = way % 2 && !rig_is_tiny() ? 8 : o.packet_side;
        o.textures = filter;
        o.texture_bytes = way == 3 ? PLT_TEXTURE_LEAST : 0;
        o.whitted = way > 3 ? 2 : 0;
        const int fetched = way > 1 && way < 5;
        const uint64_t hash = hash_of(&s[i % KINDS], &o, fetched, &f, &stats);
        first = i == 0 ? hash : first;
        CHECK(hash == first && hash != 0, "kind %u, way %u: %llx, not %llx", i % KINDS, way,
              (unsigned long long)hash, (unsigned long long)first);
        CHECK((stats.fetched > 0) == fetched, "fetched %llu", (unsigned long long)stats.fetched);
    }
    return first;
}

static void same(void) {
    static const enum lit_image kinds[KINDS] = {LIT_THESIS, LIT_LIST, LIT_COMPACT, LIT_THESIS};
    static const struct {
        uint8_t filter, samples;
        uint64_t hash;
    } golden[4] = {{PLT_TEXTURES_NEAREST, 1, UINT64_C(0xF9AB0DBDE58D1A9C)},
                   {PLT_TEXTURES_BILINEAR, 1, UINT64_C(0x716A9F51666E5AB5)},
                   {PLT_TEXTURES_BILINEAR, PLT_SAMPLES_FOUR, UINT64_C(0x86D8698170EAAEF6)},
                   {PLT_TEXTURES_BILINEAR, PLT_SAMPLES_ADAPTIVE, UINT64_C(0x4A248BBD38AA38C2)}};
    texture_scene s[KINDS];
    test(
        "frames are the same from a tree, streamed or not, a list and blocks, mapped or fetched, "
        "by any packet, "
        "with lights or without, and what they were on other machines");
    for (unsigned i = 0; i < KINDS; i++) {
        texture_scene_make_as(&s[i], PLT_TEXTURE_RGB565, 4, kinds[i],
                              i == PAGED ? TEXTURE_PAGES : TEXTURE_TABLE);
    }
    for (unsigned i = 0; i < 4; i++) {
        if (golden[i].samples == 1 || PLT_PACKET_SIDE_MAX >= 4) {
            const uint64_t hash = by_all_ways(s, golden[i].filter, golden[i].samples);
            CHECK(hash == golden[i].hash || rig_is_tiny(), "%llx, not %llx",
                  (unsigned long long)hash, (unsigned long long)golden[i].hash);
        }
    }
    for (unsigned i = 0; i < KINDS; i++) {
        texture_scene_free(&s[i]);
    }
}

/* ---- pixel by pixel ------------------------------------------------------------------ */

/* Along what a pixel of a frame that has been rendered is seen. */
static void direction(const plt_frame *f, uint32_t x, uint32_t y, float dir[3]) {
    plt_view view;
    CHECK(plt_view_set(&view, f) == PLT_OK, "a view");
    plt_view_direction(&view, x, y, dir);
}

static double dot(const float a[3], const float b[3]) {
    return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
}

static double length(const float v[3]) {
    return sqrt(dot(v, v));
}

static double byte_of(double light) {
    return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * pow(light, 1 / 2.4) - 0.055);
}

/* The bytes that a pixel is to have, in double precision but for its texel (test_texture has
 * those). 0: nothing is hit. */
static int due_colour(plt_engine *e, const plt_frame *f, uint32_t x, uint32_t y, double due[3]) {
    plt_ray ray = {.org = {f->camera.eye[0], f->camera.eye[1], f->camera.eye[2]},
                   .tmax = PLT_VIEW_FAR};
    plt_surface_point p;
    plt_hit hit;
    float texel[3];
    direction(f, x, y, ray.dir);
    CHECK(plt_trace(e, &ray, &hit, 1, 0) == PLT_OK, "a ray");
    if (hit.triangle == PLT_MISS) {
        return 0;
    }
    CHECK(plt_surface_at(e, &hit, &p) == PLT_OK && p.has_texcoord, "a point");
    const plt_smooth_paint *paint = &e->rendering.paint;
    CHECK(plt_texture_sample(paint->textures, plt_materials_find(&paint->materials, hit.triangle),
                             p.texcoord, 0.0f, texel) == PLT_OK,
          "a texel");
    const double facing = fabs(dot(p.normal, ray.dir)) / (length(p.normal) * length(ray.dir));
    for (int c = 0; c < 3; c++) {
        const double tint = p.has_colour ? texture_reference_light(255 * (double)p.colour[c]) : 1.0;
        due[c] = facing * byte_of(tint * (double)texel[c]);
    }
    return 1;
}

/* Near enough for texels to be larger than pixels: then they are of the largest level. */
static void compare(const texture_scene *s, const float look[3]) {
    plt_frame f = frame;
    rig r;
    uint32_t hits = 0, wrong = 0;
    plt_engine *e = open_scene(&r, s, &textured, 0);
    for (int a = 0; a < 3; a++) {
        f.camera.look[a] = look[a];
    }
    f.camera.tan_half_fov = 0.01f;
    frame_result got = frame_render(e, &f, 1000);
    CHECK(got.status == PLT_OK && got.wrong == 0, "rendered");
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        double due[3];
        if (due_colour(e, &f, i % WIDTH, i / WIDTH, due)) {
            hits++;
            for (int c = 0; c < 3; c++) {
                wrong += fabs(due[c] - got.rgb[3 * (size_t)i + (unsigned)c]) > 1.01;
            }
        }
    }
    CHECK(hits > WIDTH * HEIGHT / 2 && wrong == 0, "%u of %u are wrong", (unsigned)wrong,
          (unsigned)hits);
    free(got.rgb);
    free(r.arena);
}

static void pixels(void) {
    static const float looks[3][3] = {{1, 0, 5}, {2.2f, 1.05f, 1.4f}, {0, 1.05f, -0.6f}};
    texture_scene s;
    test("pixels of the floor, of paint and of a mirror are their texels by eye light");
    texture_scene_make(&s, PLT_TEXTURE_RGB565, 4);
    for (unsigned i = 0; i < 3; i++) {
        compare(&s, looks[i]);
    }
    texture_scene_free(&s);
}

/* ---- what differs -------------------------------------------------------------------- */

static uint64_t tiles_of(const texture_scene *s, uint32_t across, uint8_t samples) {
    plt_options o = textured;
    plt_texture_stats stats = {0};
    plt_frame f = frame;
    f.width = (uint16_t)(20 * across);
    f.height = (uint16_t)(15 * across);
    f.samples = samples;
    f.camera.tan_half_fov = 0.2f;
    o.packet_side = 4;
    o.texture_bytes = 4096 * PLT_TEXTURE_LEAST;
    hash_of(s, &o, 1, &f, &stats);
    return stats.fetched;
}

static void differ(void) {
    texture_scene s;
    plt_options o = textured;
    plt_texture_stats stats;
    test("without textures, nearest and bilinear are three pictures");
    texture_scene_make(&s, PLT_TEXTURE_RGB565, 4);
    uint64_t hash[3];
    for (unsigned i = 0; i < 3; i++) {
        o.textures = (uint8_t)i;
        hash[i] = hash_of(&s, &o, 0, &frame, &stats);
    }
    CHECK(hash[0] != hash[1] && hash[1] != hash[2] && hash[2] != hash[0], "they differ");
    if (PLT_PACKET_SIDE_MAX >= 4) {
        test("samples have the levels of textures that pixels as small as they have");
        const uint64_t coarse = tiles_of(&s, 1, PLT_SAMPLES_ONE), fine = tiles_of(&s, 4, 1),
                       mixed = tiles_of(&s, 1, PLT_SAMPLES_SIXTEEN);
        CHECK(4 * coarse < 3 * fine && 8 * mixed > 7 * fine && 7 * mixed < 8 * fine,
              "%u tiles, of small pixels %u, of large ones %u", (unsigned)mixed, (unsigned)fine,
              (unsigned)coarse);
    }
    texture_scene_free(&s);
}

static int render(plt_engine *e) {
    int status = plt_render_begin(e, &frame);
    while (status >= PLT_OK) {
        status = plt_render_step(e, 1000);
        if (status == PLT_OK) {
            break;
        }
    }
    return status;
}

static void damaged(void) {
    texture_scene s;
    rig r;
    plt_fault fault;
    plt_texture_stats stats;
    test("a tile that is damaged ends the frame, which says so, and not the next one");
    texture_scene_make(&s, PLT_TEXTURE_RGB565, 4);
    const uint64_t good = hash_of(&s, &textured, 1, &frame, &stats);
    texture_scene_flip_tiles(&s);
    plt_engine *e = open_scene(&r, &s, &textured, 1);
    const int status = render(e);
    plt_fault_get(e, &fault);
    CHECK(status == PLT_ERR_IMAGE && fault.kind == 'I' && fault.rule == 30 &&
              fault.offset >= s.tiles_at && (fault.offset - s.tiles_at) % 132 == 0,
          "%d: %c%u at %u", status, fault.kind, fault.rule, fault.offset);
    texture_scene_flip_tiles(&s);
    CHECK(frame_hash(e, &frame, 1000) == good, "the next frame");
    plt_fault_get(e, &fault);
    CHECK(fault.rule == 0, "%s", fault.message);
    free(r.arena);
    texture_scene_free(&s);
}

int main(void) {
    same();
    pixels();
    differ();
    damaged();
    return test_done();
}
