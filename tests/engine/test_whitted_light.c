/* test_whitted_light - what single pixels show, worked out by hand, and rays that leave a triangle
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/base/srgb.h"
#include "engine/whitted/optics.h"
#include "tests/reference/frames.h"
#include "tests/reference/lit_rig.h"
#include "tests/reference/random.h"
#include "tests/test.h"

static const float up[3] = {0, 8, 0}, down[3] = {0, 0, 0};

/* A square of that height, 2 * `half` wide. */
static void add_square(lit_scene *s, float y, float half, unsigned material) {
    fail f = {""};
    const uint32_t base = (uint32_t)s->m.vertices;
    mesh_add_vertex(&s->m, -half, y, -half, &f);
    mesh_add_vertex(&s->m, half, y, -half, &f);
    mesh_add_vertex(&s->m, half, y, half, &f);
    mesh_add_vertex(&s->m, -half, y, half, &f);
    mesh_add_triangle(&s->m, base, base + 1, base + 2, &f);
    mesh_add_triangle(&s->m, base, base + 2, base + 3, &f);
    lit_scene_is(s, material);
}

static lit_scene begin(void) {
    lit_scene s, empty = {.m = {0}};
    lit_scene_make(&s);
    mesh_free(&s.m);
    s.m = empty.m;
    s.materials.filled = 0;
    return s;
}

/* The pixel in the middle, seen from straight above. */
static void see(const lit_scene *s, const plt_lighting *l, uint8_t rgb[3]) {
    const plt_options o = {.packet_side = 2, .whitted = (uint8_t)(1 + l->bounces)};
    plt_frame f = frame_of(up, down, 3, 3, PLT_SHADE_WHITTED);
    rig r = {.engine = NULL};
    f.camera.up[1] = 0;
    f.camera.up[2] = 1;
    f.camera.tan_half_fov = 0.001f;
    CHECK(lit_pack(&r.image, s, LIT_LIST) == 0 && lit_open(&r, &o, 0) == PLT_OK, "%s",
          r.fault.message);
    CHECK(plt_lighting_set(r.engine, l) == PLT_OK, "lights");
    const frame_result result = frame_render(r.engine, &f, 1000);
    memcpy(rgb, result.rgb + 3 * 4, 3);
    free(result.rgb);
    rig_close(&r);
}

static void shows(const lit_scene *s, const plt_lighting *l, float red, float green, float blue,
                  const char *what) {
    const float due[3] = {red, green, blue};
    uint8_t rgb[3];
    see(s, l, rgb);
    for (int c = 0; c < 3; c++) {
        CHECK(abs(rgb[c] - plt_srgb_byte(due[c])) <= 1, "%s, %d: %u not %u", what, c, rgb[c],
              plt_srgb_byte(due[c]));
    }
}

/* What is above is z here, so that the sky is the same from all sides. */
static plt_lighting even(float sky) {
    const plt_lighting l = {.sky = {sky, sky, sky}, .ground = {sky, sky, sky}, .bounces = 4};
    return l;
}

static void diffuse(void) {
    lit_scene s = begin();
    plt_lighting l = even(0.1f);
    add_square(&s, 0, 5, LIT_FLOOR);
    test("a diffuse floor shows its colour times light around it and from lights that face it");
    shows(&s, &l, 0.05f, 0.05f, 0.04f, "around it");
    l.lights = 1;
    l.light[0] = (plt_light){{0, 3, 0}, {0.8f, 0.4f, 0.2f}, 0, PLT_LIGHT_DISTANT, 1};
    shows(&s, &l, 0.45f, 0.25f, 0.12f, "a sun above it");
    l.light[0].at[0] = 3;
    const float half = sqrtf(0.5f);
    shows(&s, &l, 0.05f + 0.4f * half, 0.05f + 0.2f * half, 0.04f + 0.08f * half, "at 45 degrees");
    l.light[0] = (plt_light){{0, 2, 0}, {2, 2, 2}, 0, PLT_LIGHT_POINT, 1};
    shows(&s, &l, 0.3f, 0.3f, 0.24f, "a point, at a distance of 2");
    l.light[0].at[1] = -2;
    shows(&s, &l, 0.05f, 0.05f, 0.04f, "a point below it");
    test("what is in the way of a light throws a shadow, what is behind it does not");
    add_square(&s, 9, 5, LIT_FLOOR);
    l.light[0].at[1] = 20;
    l.light[0].power[0] = l.light[0].power[1] = l.light[0].power[2] = 200;
    shows(&s, &l, 0.05f, 0.05f, 0.04f, "the light is above the ceiling");
    l.light[0].at[1] = 8.5f;
    shows(&s, &l, 0.05f + 100 / 72.25f, 1, 1, "and below it");
    l.light[0] = (plt_light){{0, 3, 0}, {0.8f, 0.4f, 0.2f}, 0.1f, PLT_LIGHT_DISTANT, 16};
    shows(&s, &l, 0.05f, 0.05f, 0.04f, "the middle of a soft shadow");
    lit_scene_free(&s);
}

static void others(void) {
    lit_scene s = begin();
    plt_lighting l = even(0.25f);
    add_square(&s, 0, 5, LIT_LAMP);
    test("a lamp shows its own light");
    shows(&s, &l, 1.5f, 1.2f, 0.25f, "lamp");
    lit_scene_free(&s);
    s = begin();
    add_square(&s, 0, 5, LIT_MIRROR);
    add_square(&s, 9, 5, LIT_LAMP);
    test("a mirror shows what is across, tinted, and without bounces the sky");
    shows(&s, &l, 1.0f, 0.96f + 0.1f * 0.2f * 0.25f, 0.25f * 0.6f + 0.1f * 0.4f * 0.25f, "mirror");
    l.bounces = 0;
    shows(&s, &l, 0.25f * 0.9f + 0.1f * 0.1f * 0.25f, 0.25f * 0.8f + 0.1f * 0.2f * 0.25f,
          0.25f * 0.6f + 0.1f * 0.4f * 0.25f, "no bounces");
    lit_scene_free(&s);
}

static void glass(void) {
    lit_scene s = begin();
    plt_lighting l = even(0.0f);
    material_values *g = &s.materials.material[LIT_GLASS].values;
    memset(g->specular, 0, sizeof g->specular);
    add_square(&s, 0, 5, LIT_LAMP);
    add_square(&s, 1, 5, LIT_GLASS);
    add_square(&s, 3, 5, LIT_GLASS);
    test("light through a slab fades by Beer's law, and twice by what its sides reflect");
    /* 2 units; 0.04 at each side, 0.04^2 of what is reflected within comes back. */
    const float pass = 0.96f * 0.96f;
    shows(&s, &l, pass * 1.5f * expf(-0.2f), pass * 1.2f * expf(-0.8f), pass * 0.25f * expf(-1.2f),
          "slab");
    g->index = 1.0f;
    shows(&s, &l, 1.5f * expf(-0.2f), 1.2f * expf(-0.8f), 0.25f * expf(-1.2f), "of air");
    g->transparency = 0.0f;
    memset(g->diffuse, 0, sizeof g->diffuse);
    shows(&s, &l, 0, 0, 0, "opaque and black");
    lit_scene_free(&s);
}

/* ---- rays that leave a triangle ------------------------------------------------------- */

enum { TRIANGLES = 300, RAYS = 64 };

/* Hits of rays from a surface that go away from it, `lift` above it. */
static unsigned self_hits(plt_engine *e, const float box, random_state *r, float lift) {
    plt_ray in[RAYS], out[RAYS];
    plt_hit hit[RAYS], back[RAYS];
    unsigned wrong = 0, count = 0;
    for (int i = 0; i < RAYS; i++) {
        in[i] = (plt_ray){.tmax = 1e30f};
        for (int a = 0; a < 3; a++) {
            in[i].org[a] = random_float(r, -box, box);
            in[i].dir[a] = random_float(r, -1, 1) - in[i].org[a];
        }
    }
    plt_trace(e, in, hit, RAYS, 0);
    for (int i = 0; i < RAYS; i++) {
        plt_surface_point point;
        if (hit[i].triangle == PLT_MISS || plt_surface_at(e, &hit[i], &point) != PLT_OK) {
            continue;
        }
        plt_ray *o = &out[count++];
        *o = (plt_ray){.tmax = 1e30f};
        const float side = plt_optics_dot(point.flat, in[i].dir) > 0 ? -1.0f : 1.0f;
        float along = 0.0f;
        for (int a = 0; a < 3; a++) {
            o->org[a] = in[i].org[a] + hit[i].t * in[i].dir[a] + side * lift * point.flat[a];
            o->dir[a] = random_float(r, -1, 1);
            along += side * o->dir[a] * point.flat[a];
        }
        for (int a = 0; a < 3 && along < 0; a++) {
            o->dir[a] = -o->dir[a];
        }
    }
    plt_trace(e, out, back, count, 0);
    for (unsigned i = 0; i < count; i++) {
        wrong += back[i].triangle != PLT_MISS;
    }
    return wrong;
}

/* Of triangles that are alone, within a box of a thousand times their size. */
static unsigned all_self_hits(float lift) {
    random_state r = {11};
    unsigned wrong = 0;
    for (int i = 0; i < TRIANGLES; i++) {
        mesh m = {0};
        fail f = {""};
        rig one = {.engine = NULL};
        rig_config config = rig_config_of(1, 1, PLT_BUILD_NONE, PLT_SPLIT_SAH);
        const float box = i % 3 == 0 ? 1.5f : i % 3 == 1 ? 40.0f : 1000.0f;
        config.run.surface = 1;
        for (int k = 0; k < 3; k++) {
            mesh_add_vertex(&m, random_float(&r, -1, 1), random_float(&r, -1, 1),
                            random_float(&r, -1, 1), &f);
        }
        mesh_add_vertex(&m, box, box, box, &f); /* one of no area, which is never hit */
        mesh_add_triangle(&m, 0, 1, 2, &f);
        mesh_add_triangle(&m, 3, 3, 3, &f);
        if (rig_open(&one, &m, &config) == PLT_OK) {
            wrong += self_hits(one.engine, box, &r, lift * box);
        }
        rig_close(&one);
        mesh_free(&m);
    }
    return wrong;
}

static void leaving(void) {
    test(
        "a ray that leaves a triangle from 2^-17 of the largest coordinate above does not meet it");
    const unsigned wrong = all_self_hits(0x1p-17f);
    CHECK(wrong == 0, "%u do", wrong);
    test("and from 2^-24 above some do: the margin is there for a reason");
    CHECK(all_self_hits(0x1p-24f) > 0, "none");
}

int main(void) {
    diffuse();
    others();
    glass();
    leaving();
    return test_done();
}
