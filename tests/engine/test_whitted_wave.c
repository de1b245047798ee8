/* test_whitted_wave - rays off surfaces, by the wave and in packets: the same picture
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "tests/reference/frames.h"
#include "tests/reference/lit_rig.h"
#include "tests/test.h"

enum { BOUNCES = 4, WIDTH = 37, HEIGHT = 29, IN_FLIGHT = 32 };
/* Of the small packets. */
enum { SIDE = PLT_PACKET_SIDE_MAX < 4 ? PLT_PACKET_SIDE_MAX : 4 };

static plt_frame view(void) {
    static const float eye[3] = {0.6f, 3.0f, 8.0f}, look[3] = {0, 0.8f, 0};
    return frame_of(eye, look, WIDTH, HEIGHT, PLT_SHADE_WHITTED);
}

static plt_options options_of(uint8_t side, enum plt_rays rays, uint8_t wide) {
    const plt_options o = {.packet_side = side,
                           .rays = (uint8_t)rays,
                           .rays_in_flight = rays == PLT_RAYS_COHERENT ? 0 : IN_FLIGHT,
                           .wide = rays == PLT_RAYS_COHERENT ? 0 : wide,
                           .whitted = 1 + BOUNCES};
    return o;
}

static plt_lighting lights(uint8_t solid) {
    plt_lighting l = lit_lights(BOUNCES);
    l.solid_shadows = solid;
    return l;
}

static frame_result render(rig *r, uint8_t solid, uint32_t visits) {
    const plt_lighting l = lights(solid);
    const plt_frame f = view();
    CHECK(plt_lighting_set(r->engine, &l) == PLT_OK, "lights");
    plt_stats_reset(r->engine);
    const frame_result result = frame_render(r->engine, &f, visits);
    CHECK(result.status == PLT_OK && result.wrong == 0, "%d, %u", result.status, result.wrong);
    free(result.rgb);
    return result;
}

/* 0: this build has no such engine. */
static int open_one(rig *r, const lit_scene *s, enum lit_image kind, const plt_options *o) {
    const int status = lit_pack(&r->image, s, kind) != 0 ? PLT_ERR_LIMIT : lit_open(r, o, 0);
    CHECK(status == PLT_OK || (status == PLT_ERR_LIMIT && rig_is_tiny()), "%s", r->fault.message);
    return status == PLT_OK;
}

static uint64_t wave_rays(const rig *r) {
    plt_stats stats;
    plt_stats_get(r->engine, &stats);
    return stats.wave_rays;
}

static uint64_t due_of(const lit_scene *s, enum lit_image kind, uint8_t solid) {
    rig r = {.engine = NULL};
    const plt_options o = options_of(2, PLT_RAYS_COHERENT, 0);
    uint64_t due = 0;
    if (open_one(&r, s, kind, &o)) {
        due = render(&r, solid, 1000).hash;
        CHECK(wave_rays(&r) == 0, "there is no wave");
    }
    rig_close(&r);
    return due;
}

/* `visits`: per step. A round of the wave visits a node per ray, and the wide form has two. */
static void compare(const lit_scene *s, enum lit_image kind, const plt_options *o, uint8_t solid,
                    uint32_t visits) {
    const uint64_t due = due_of(s, kind, solid);
    rig r = {.engine = NULL};
    if (due != 0 && open_one(&r, s, kind, o)) {
        const frame_result got = render(&r, solid, visits);
        CHECK(got.hash == due, "image %u, side %u, wide %u, solid %u: %016llx not %016llx", kind,
              o->packet_side, o->wide, solid, (unsigned long long)got.hash,
              (unsigned long long)due);
        /* Left to choose, packets of 2x2 are always taken for coherent. */
        CHECK(wave_rays(&r) > 0 || (o->rays == PLT_RAYS_AUTO && o->packet_side < 4),
              "none by the wave");
        CHECK(got.most_visits <= visits + 2u * IN_FLIGHT, "%llu visits",
              (unsigned long long)got.most_visits);
    }
    rig_close(&r);
}

static void same_picture(const lit_scene *s, enum plt_rays rays) {
    for (unsigned i = 0; i < 8; i++) {
        const enum lit_image kind = i % 2 ? LIT_COMPACT : LIT_THESIS;
        const uint8_t side = i / 4 && PLT_PACKET_SIDE_MAX >= 8 ? 8 : SIDE;
        const plt_options o = options_of(side, rays, i / 2 % 2);
        if (kind == LIT_COMPACT && !o.wide && rig_is_tiny()) {
            continue;
        }
        compare(s, kind, &o, 0, i % 3 ? 1 : 100000);
        compare(s, kind, &o, 1, i % 3 ? 100000 : 1);
    }
}

/* Begins a frame and leaves it when rays off surfaces are in flight in the wave, `more` steps after
 * the first of them were handed to it. */
static void leave_in_flight(rig *r, const plt_frame *f, unsigned more) {
    plt_stats_reset(r->engine);
    CHECK(plt_render_begin(r->engine, f) == PLT_OK, "begins");
    while (wave_rays(r) == 0 && plt_render_step(r->engine, 1) > PLT_OK) {
    }
    CHECK(wave_rays(r) > 0, "none by the wave");
    const uint64_t handed = wave_rays(r);
    for (unsigned i = 0; i < more; i++) {
        CHECK(plt_render_step(r->engine, 1) == PLT_MORE, "goes on");
    }
    CHECK(wave_rays(r) == handed, "step %u is past the first of them", more);
}

static void left_in_flight(const lit_scene *s) {
    const plt_options o = options_of(SIDE, PLT_RAYS_INCOHERENT, 0);
    const plt_ray ray = {.org = {0, 3, 0}, .tmin = 0, .dir = {0, -1, 0}, .tmax = 100};
    const plt_frame f = view();
    rig r = {.engine = NULL};
    test("what a frame has left in the wave is dropped by the next, and by other rays");
    if (open_one(&r, s, LIT_THESIS, &o)) {
        const uint64_t due = render(&r, 0, 1000).hash;
        for (unsigned more = 0; more < 8; more++) {
            leave_in_flight(&r, &f, more / 2);
            if (more % 2 != 0) {
                plt_hit hit = {0};
                CHECK(plt_trace(r.engine, &ray, &hit, 1, 0) == PLT_OK && hit.triangle != PLT_MISS,
                      "ray");
            }
            CHECK(frame_hash(r.engine, &f, 7) == due, "after %u steps", more / 2);
        }
    }
    rig_close(&r);
}

int main(void) {
    lit_scene s;
    lit_scene_make(&s);
    test("all rays off surfaces by the wave: a picture is the same, whatever the step");
    same_picture(&s, PLT_RAYS_INCOHERENT);
    test("incoherent ones by the wave: a picture is the same, whatever the step");
    same_picture(&s, PLT_RAYS_AUTO);
    left_in_flight(&s);
    lit_scene_free(&s);
    return test_done();
}
