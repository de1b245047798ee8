/* test_whitted - lights, shadows, mirrors and glass: the arithmetic, and the same picture
 * everywhere
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/base/srgb.h"
#include "engine/whitted/lights.h"
#include "engine/whitted/optics.h"
#include "engine/whitted/state.h"
#include "tests/reference/frames.h"
#include "tests/reference/lit_rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { BOUNCES = 5, WIDTH = 45, HEIGHT = 35 };

/* ---- arithmetic ------------------------------------------------------------------ */

static void powers(void) {
    random_state r = {1};
    test("x^n by squaring is off by at most n 2^-23 of itself, for every exponent there is");
    for (uint32_t n = 1; n <= PLT_EXPONENT_MOST; n++) {
        for (int i = 0; i < 20; i++) {
            const float x = i == 0 ? 1.0f : random_float(&r, 0.5f, 1.0f);
            const double due = pow((double)x, n), got = (double)plt_optics_power(x, n);
            CHECK(fabs(got - due) <= n * 0x1p-23 * due + 0x1p-126, "%.9g^%u: %g not %g", (double)x,
                  n, got, due);
        }
    }
    test("e^-x is off by at most 2^-21, and 0 where x is large or no number");
    for (int i = 0; i < 200000; i++) {
        const float x = (float)i * 0.0005f;
        const double got = (double)plt_optics_fade(x);
        CHECK(fabs(got - exp(-(double)x)) <= 0x1p-21, "%g: %.9g", (double)x, got);
    }
    CHECK(plt_optics_fade(INFINITY) == 0.0f && plt_optics_fade(NAN) == 0.0f, "infinite");
    CHECK(plt_optics_fade(0.0f) == 1.0f, "nothing fades along nothing");
}

static double srgb(double x) {
    return 255.0 * (x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1 / 2.4) - 0.055);
}

static void bytes(void) {
    test("a byte of a picture is that of the sRGB curve, but for 0.027 of a step");
    for (int i = 0; i <= 400000; i++) {
        const float x = (float)i / 400000.0f;
        const double off = fabs(plt_srgb_byte(x) - srgb((double)x));
        CHECK(off <= 0.5 + 0.027, "%.9g: %u not %.3f", (double)x, plt_srgb_byte(x),
              srgb((double)x));
    }
    test("too bright is white, negative and no number black");
    CHECK(plt_srgb_byte(1.0f) == 255 && plt_srgb_byte(1e30f) == 255, "bright");
    CHECK(plt_srgb_byte(INFINITY) == 255, "infinite");
    CHECK(plt_srgb_byte(-1.0f) == 0 && plt_srgb_byte(NAN) == 0, "dark");
}

static void directions(void) {
    random_state r = {2};
    test("reflected and refracted rays have length 1, and obey Snell's law");
    for (int i = 0; i < 20000; i++) {
        float d[3], n[3], to[3], cosine;
        for (int a = 0; a < 3; a++) {
            d[a] = random_float(&r, -1, 1);
            n[a] = random_float(&r, -1, 1);
        }
        if (!plt_normalise(d) || !plt_normalise(n) || plt_optics_dot(d, n) >= -0.001f) {
            continue;
        }
        const float ratio = random_float(&r, 0.4f, 2.0f), c = -plt_optics_dot(d, n);
        plt_optics_reflect(d, n, to);
        CHECK(fabsf(plt_optics_dot(to, n) - c) < 1e-5f, "reflected");
        CHECK(fabsf(plt_optics_dot(to, to) - 1.0f) < 1e-6f, "length");
        const double sine = (double)ratio * sqrt(fmax(0, 1 - (double)c * (double)c));
        const int passes = plt_optics_refract(d, n, ratio, to, &cosine);
        CHECK(passes == (sine < 1) || fabs(sine - 1) < 1e-5, "sine %g", sine);
        if (passes && sine < 0.99) {
            const double along = -(double)plt_optics_dot(to, n);
            CHECK(fabs(sqrt(1 - along * along) - sine) < 2e-4, "Snell: %g", sine);
            CHECK(fabsf((float)along - cosine) < 1e-4f, "cosine");
        }
    }
    test("glass of index 1.5 reflects 4 % face on and all at a grazing angle");
    CHECK(fabsf(plt_optics_glass(1.5f, 1.0f) - 0.04f) < 1e-6f, "face on");
    CHECK(plt_optics_glass(1.5f, 0.0f) == 1.0f, "grazing");
    CHECK(plt_optics_glass(1.0f, 1.0f) == 0.0f, "air");
}

/* ---- lights ----------------------------------------------------------------------- */

static void samples(void) {
    const plt_light l = {{1, 7, -3}, {1, 1, 1}, 0.5f, PLT_LIGHT_POINT, 16};
    const float point[3] = {4, 1, 2};
    unsigned seen = 0;
    test("samples of a disc lie on it, all of them elsewhere, and it faces the point");
    for (unsigned i = 0; i < 16; i++) {
        for (uint8_t turn = 0; turn < 16; turn++) {
            float to[3], off[3], first[3];
            const float bright = plt_light_towards(&l, i, turn, point, to);
            const float axis[3] = {1 - point[0], 7 - point[1], -3 - point[2]};
            for (int a = 0; a < 3; a++) {
                off[a] = to[a] - axis[a];
            }
            const float r = sqrtf(plt_optics_dot(off, off));
            CHECK(fabsf(r - 0.5f * sqrtf(((float)i + 0.5f) / 16)) < 1e-5f, "%u: %g", i, (double)r);
            CHECK(fabsf(plt_optics_dot(off, axis)) < 1e-4f, "it faces the point");
            CHECK(fabsf(bright * plt_optics_dot(axis, axis) - 1) < 1e-5f, "squared");
            plt_light_towards(&l, i, (uint8_t)(turn ^ 1), point, first);
            CHECK(memcmp(first, to, sizeof to) != 0, "turned");
        }
    }
    test("16 neighbours have 16 angles");
    for (uint32_t k = 0; k < 16; k++) {
        seen |= 1u << plt_light_turn(k % 4 + 8, k / 4 + 4);
    }
    CHECK(seen == 0xFFFF, "%x", seen);
    test("a light at the point itself gives nothing, and one next to it no infinity");
    float to[3];
    const float at[3] = {1, 7, -3}, beside[3] = {1, 7.0001f, -3};
    CHECK(plt_light_towards(&l, 0, 0, at, to) == 0.0f, "at it");
    CHECK(plt_light_towards(&l, 0, 0, beside, to) <= 1048576.0f, "beside it");
}

static void refusals(void) {
    const plt_lighting good = lit_lights(0);
    const float wrong[] = {NAN, INFINITY, -INFINITY, -1.0f, 2.0e12f};
    test("lights that are out of range are refused");
    CHECK(plt_lighting_valid(&good), "these are not");
    for (int i = 0; i < 5; i++) {
        for (int field = 0; field < 6; field++) {
            plt_lighting l = good;
            float *const at[] = {&l.light[1].power[2], &l.light[2].radius, &l.sky[1],
                                 &l.ground[0],         &l.light[0].at[1],  &l.light[1].at[0]};
            *at[field] = wrong[i];
            CHECK(!plt_lighting_valid(&l) || (field > 3 && wrong[i] == -1.0f), "%d %d", i, field);
        }
    }
    plt_lighting l = good;
    l.light[0].samples = 0;
    CHECK(!plt_lighting_valid(&l), "no samples");
    l.light[0].samples = 17;
    CHECK(!plt_lighting_valid(&l), "17 samples");
    l = good;
    l.light[2].kind = 2;
    CHECK(!plt_lighting_valid(&l), "kind");
    l = good;
    memset(l.light[1].at, 0, sizeof l.light[1].at);
    CHECK(!plt_lighting_valid(&l), "a sun from nowhere");
    l.lights = PLT_LIGHTS_MOST + 1;
    CHECK(!plt_lighting_valid(&l), "9 lights");
}

/* ---- frames ----------------------------------------------------------------------- */

static plt_options options_of(uint8_t side, uint8_t bounces) {
    const plt_options o = {.packet_side = side, .whitted = (uint8_t)(1 + bounces)};
    return o;
}

static plt_frame view(void) {
    static const float eye[3] = {0.6f, 3.0f, 8.0f}, look[3] = {0, 0.8f, 0};
    return frame_of(eye, look, WIDTH, HEIGHT, PLT_SHADE_WHITTED);
}

static uint64_t hash_with(rig *r, const plt_lighting *l, uint32_t visits) {
    const plt_frame f = view();
    CHECK(plt_lighting_set(r->engine, l) == PLT_OK, "lights");
    const frame_result result = frame_render(r->engine, &f, visits);
    CHECK(result.status == PLT_OK && result.wrong == 0, "%d, %u", result.status, result.wrong);
    free(result.rgb);
    return result.hash;
}

/* Compact blocks round a box elsewhere, but have the same triangles. */
static void same_everywhere(const lit_scene *s) {
    const plt_lighting l = lit_lights(BOUNCES);
    uint64_t due = 0;
    test("a picture is the same with any packet, step, order and image, mapped or fetched");
    for (unsigned kind = 0; kind < LIT_IMAGES; kind++) {
        for (unsigned i = 0; i < 8; i++) {
            plt_options o = options_of((uint8_t)(2u << i / 2), BOUNCES);
            rig r = {.engine = NULL};
            o.order = kind == LIT_THESIS && i % 2;
            if (o.packet_side > PLT_PACKET_SIDE_MAX || lit_pack(&r.image, s, kind) != 0) {
                rig_close(&r);
                continue;
            }
            const int status = lit_open(&r, &o, i % 2);
            CHECK(status == PLT_OK || (status == PLT_ERR_LIMIT && rig_is_tiny()), "%u %u: %s", kind,
                  i, r.fault.message);
            if (status == PLT_OK) {
                const uint64_t hash = hash_with(&r, &l, i % 2 ? 1 : 1000000);
                due = due == 0 ? hash : due;
                CHECK(hash == due, "image %u, side %u: %016llx not %016llx", kind, o.packet_side,
                      (unsigned long long)hash, (unsigned long long)due);
            }
            rig_close(&r);
        }
    }
    CHECK(due != 0, "some were rendered");
}

static rig opened(const lit_scene *s, uint8_t bounces) {
    rig r = {.engine = NULL};
    const plt_options o = options_of(PLT_PACKET_SIDE_MAX < 4 ? 2 : 4, bounces);
    CHECK(lit_pack(&r.image, s, LIT_LIST) == 0 && lit_open(&r, &o, 0) == PLT_OK, "%s",
          r.fault.message);
    return r;
}

static void bounces_matter(const lit_scene *s) {
    uint64_t hash[PLT_BOUNCES_MOST + 1];
    rig r = opened(s, PLT_BOUNCES_MOST);
    test("each bounce up to the most changes the picture, and room for more does not");
    for (uint8_t i = 0; i <= PLT_BOUNCES_MOST; i++) {
        plt_lighting l = lit_lights(i);
        hash[i] = hash_with(&r, &l, 100000);
        CHECK(i == 0 || i > 4 || hash[i] != hash[i - 1], "%u", i);
        rig tight = opened(s, i);
        CHECK(hash_with(&tight, &l, 100000) == hash[i], "%u", i);
        l.bounces = (uint8_t)(i + 1);
        CHECK(plt_lighting_set(tight.engine, &l) == PLT_ERR_ARGUMENT, "no room for one more");
        rig_close(&tight);
    }
    rig_close(&r);
}

/* Renders view() with these lights, and with a background if there is one. */
static uint8_t *pixels_with(rig *r, const plt_lighting *l, const uint8_t *background) {
    plt_frame f = view();
    if (background != NULL) {
        f.has_background = 1;
        memcpy(f.background, background, sizeof f.background);
    }
    CHECK(plt_lighting_set(r->engine, l) == PLT_OK, "lights");
    const frame_result result = frame_render(r->engine, &f, 1000);
    CHECK(result.status == PLT_OK && result.wrong == 0, "%d", result.status);
    return result.rgb;
}

/* Which pixels' own rays miss another shader says. Mirrors and glass are in view: what they show
 * of the sky stays. */
static void before_a_background(const lit_scene *s) {
    static const uint8_t orange[3] = {255, 128, 1};
    rig r = opened(s, BOUNCES);
    const plt_lighting l = lit_lights(BOUNCES);
    plt_frame flat_view = view();
    flat_view.shader = PLT_SHADE_TRIANGLE;
    flat_view.has_background = 1;
    memcpy(flat_view.background, orange, sizeof orange);
    const frame_result flat = frame_render(r.engine, &flat_view, 1000);
    uint8_t *plain = pixels_with(&r, &l, NULL), *before = pixels_with(&r, &l, orange);
    unsigned missed = 0;
    test("the eye's rays that miss show the background, byte for byte; all others what they did");
    for (size_t i = 0; i < 3 * WIDTH * HEIGHT; i += 3) {
        const int misses = memcmp(flat.rgb + i, orange, 3) == 0;
        const uint8_t *due = misses ? orange : plain + i;
        missed += misses;
        CHECK(memcmp(before + i, due, 3) == 0, "pixel %zu: %u %u %u", i / 3, before[i],
              before[i + 1], before[i + 2]);
    }
    CHECK(missed > 50 && missed < WIDTH * HEIGHT - 500, "%u pixels miss", missed);
    free(flat.rgb);
    free(plain);
    free(before);
    rig_close(&r);
}

static void without_room(const lit_scene *s) {
    rig r = {.engine = NULL};
    const plt_options none = {.packet_side = 2}, many = {.packet_side = 2, .whitted = 10};
    const plt_options batch = {.packet_side = 2,
                               .whitted = 1,
                               .residency = PLT_RESIDENCY_STREAMED,
                               .schedule = PLT_SCHEDULE_BATCH};
    const plt_lighting l = lit_lights(0);
    const plt_frame f = view();
    test("an engine without room for it refuses lights and such a frame");
    CHECK(lit_pack(&r.image, s, LIT_LIST) == 0 && lit_open(&r, &none, 0) == PLT_OK, "%s",
          r.fault.message);
    CHECK(plt_lighting_set(r.engine, &l) == PLT_ERR_ARGUMENT, "lights");
    CHECK(plt_render_begin(r.engine, &f) == PLT_ERR_ARGUMENT, "frame");
    CHECK(plt_arena_need(&r.image.info, 1, &many) == 0, "9 bounces");
    CHECK(plt_arena_need(&r.image.info, 1, &batch) == 0, "a batch");
    rig_close(&r);
}

/* A light within a ball, at a corner, on the floor; coordinates as large as they may be. */
static void odd_lights(const lit_scene *s) {
    static const float at[][3] = {
        {2.2f, 1, 0.5f}, {-6, 0, -6}, {0, 0, 0}, {0, -1, 0}, {1e12f, 0, 0}};
    rig r = opened(s, 2);
    test("a light in a wall, on a surface, in a corner or very far away does no harm");
    for (int i = 0; i < 5; i++) {
        plt_lighting l = lit_lights(2);
        memcpy(l.light[0].at, at[i], sizeof at[i]);
        l.light[0].power[0] = 1.0e12f;
        l.light[2].radius = 1.0e12f;
        hash_with(&r, &l, 1000);
    }
    rig_close(&r);
}

static void steps_are_bounded(const lit_scene *s) {
    const plt_lighting l = lit_lights(BOUNCES);
    const plt_frame f = view();
    rig r = {.engine = NULL};
    const plt_options o = options_of(2, BOUNCES);
    test("no step visits more than a treelet or a list beyond what it was given");
    if (lit_pack(&r.image, s, LIT_THESIS) != 0 || lit_open(&r, &o, 0) != PLT_OK) {
        CHECK(rig_is_tiny(), "%s", r.fault.message);
    } else {
        plt_lighting_set(r.engine, &l);
        const frame_result result = frame_render(r.engine, &f, 10);
        CHECK(result.status == PLT_OK && result.most_visits <= 10 + 8, "%llu",
              (unsigned long long)result.most_visits);
        free(result.rgb);
    }
    rig_close(&r);
}

int main(void) {
    lit_scene s;
    lit_scene_make(&s);
    powers();
    bytes();
    directions();
    samples();
    refusals();
    same_everywhere(&s);
    bounces_matter(&s);
    before_a_background(&s);
    without_room(&s);
    odd_lights(&s);
    steps_are_bounded(&s);
    lit_scene_free(&s);
    return test_done();
}
