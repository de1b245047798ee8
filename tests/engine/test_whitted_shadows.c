/* test_whitted_shadows - light that comes through glass: what a floor shows below it, worked out by
 * hand
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/base/srgb.h"
#include "engine/whitted/shadows.h"
#include "tests/reference/frames.h"
#include "tests/reference/lit_rig.h"
#include "tests/test.h"

/* Of the floor, (0.5, 0.5, 0.4), and of the glass, index 1.5. */
static const float floor_of[3] = {0.5f, 0.5f, 0.4f}, absorbs[3] = {0.1f, 0.4f, 0.6f};

/* A square of that height around x, 2 * `half` wide. */
static void add_square(lit_scene *s, float x, float y, float half, unsigned material) {
    fail f = {""};
    const uint32_t base = (uint32_t)s->m.vertices;
    mesh_add_vertex(&s->m, x - half, y, -half, &f);
    mesh_add_vertex(&s->m, x + half, y, -half, &f);
    mesh_add_vertex(&s->m, x + half, y, half, &f);
    mesh_add_vertex(&s->m, x - half, y, half, &f);
    mesh_add_triangle(&s->m, base, base + 1, base + 2, &f);
    mesh_add_triangle(&s->m, base, base + 2, base + 3, &f);
    lit_scene_is(s, material);
}

/* A floor, and the materials of a lit scene; glass without highlights. */
static lit_scene begin(void) {
    lit_scene s, empty = {.m = {0}};
    lit_scene_make(&s);
    mesh_free(&s.m);
    s.m = empty.m;
    s.materials.filled = 0;
    material_values *g = &s.materials.material[LIT_GLASS].values;
    memset(g->specular, 0, sizeof g->specular);
    add_square(&s, 0, 0, 3, LIT_FLOOR);
    return s;
}

/* The light comes from (-4, 4, 0), at 45 degrees; slabs of glass are where it comes from, so that
 * the eye, straight above, does not look through them. */
static plt_lighting slanting(void) {
    plt_lighting l = {.lights = 1};
    l.light[0] = (plt_light){{-4, 4, 0}, {1, 1, 1}, 0, PLT_LIGHT_DISTANT, 1};
    return l;
}

static void add_slab(lit_scene *s, float below, float above) {
    add_square(s, -below, below, 0.4f, LIT_GLASS);
    add_square(s, -above, above, 0.4f, LIT_GLASS);
}

/* The middle of the floor; *visits: of the frame. */
static void see(const lit_scene *s, const plt_lighting *l, enum lit_image image, uint8_t rgb[3],
                uint64_t *visits) {
    static const float eye[3] = {0, 9, 0}, look[3] = {0, 0, 0};
    const plt_options o = {.packet_side = 2, .whitted = (uint8_t)(1 + l->bounces)};
    plt_frame f = frame_of(eye, look, 3, 3, PLT_SHADE_WHITTED);
    rig r = {.engine = NULL};
    plt_stats counted;
    f.camera.up[1] = 0;
    f.camera.up[2] = 1;
    f.camera.tan_half_fov = 0.001f;
    CHECK(lit_pack(&r.image, s, image) == 0 && lit_open(&r, &o, 0) == PLT_OK, "%s",
          r.fault.message);
    CHECK(plt_lighting_set(r.engine, l) == PLT_OK, "lights");
    const frame_result result = frame_render(r.engine, &f, 1000);
    memcpy(rgb, result.rgb + 3 * 4, 3);
    plt_stats_get(r.engine, &counted);
    *visits = counted.node_visits;
    free(result.rgb);
    rig_close(&r);
}

/* What comes through: `surfaces` of glass that reflect `reflected` each, and `distance` in it. */
static void shows(const lit_scene *s, const plt_lighting *l, int surfaces, float reflected,
                  float distance, float lit, const char *what) {
    const float passes = powf(1.0f - reflected, (float)surfaces);
    for (int image = 0; image < LIT_IMAGES; image++) {
        uint8_t rgb[3];
        uint64_t visits;
        if (image == LIT_COMPACT && rig_is_tiny()) {
            continue;
        }
        see(s, l, (enum lit_image)image, rgb, &visits);
        for (int c = 0; c < 3; c++) {
            const float due = lit * floor_of[c] * passes * expf(-absorbs[c] * distance);
            CHECK(abs(rgb[c] - plt_srgb_byte(due)) <= 1, "%s, image %d, %d: %u not %u", what, image,
                  c, rgb[c], plt_srgb_byte(due));
        }
    }
}

/* Of index 1.5 at 45 degrees, by Schlick's formula. */
static float at_45(void) {
    return 0.04f + 0.96f * powf(1.0f - sqrtf(0.5f), 5);
}

static void slab(void) {
    const float half = sqrtf(0.5f), slant = sqrtf(2.0f);
    lit_scene s = begin();
    plt_lighting l = slanting();
    test("light through a slab fades by Beer's law along its way, and by what its sides reflect");
    shows(&s, &l, 0, 0, 0, half, "no slab");
    add_slab(&s, 1, 2.5f);
    shows(&s, &l, 2, at_45(), 1.5f * slant, half, "a sun");
    l.light[0].at[0] = -400000;
    l.light[0].at[1] = 400000;
    shows(&s, &l, 2, at_45(), 1.5f * slant, half, "its direction may have any length");
    l.light[0] = (plt_light){{-4, 4, 0}, {32, 32, 32}, 0, PLT_LIGHT_POINT, 1};
    shows(&s, &l, 2, at_45(), 1.5f * slant, half, "a point");
    l.light[0].at[0] = -2;
    l.light[0].at[1] = 2;
    l.light[0].power[0] = l.light[0].power[1] = l.light[0].power[2] = 8;
    shows(&s, &l, 1, at_45(), 0, half, "a point within it: what comes out has not ended yet");
    test("two slabs count twice, and index and transparency are those of the material");
    l = slanting();
    add_slab(&s, 3, 3.5f);
    shows(&s, &l, 4, at_45(), 2 * slant, half, "two slabs");
    s.materials.material[LIT_GLASS].values.index = 1;
    s.materials.material[LIT_GLASS].values.transparency = 0.5f;
    const float grazing = powf(1.0f - half, 5); /* what Schlick's formula leaves of index 1 */
    shows(&s, &l, 4, 1.0f - 0.5f * (1.0f - grazing), 2 * slant, half, "half clear");
    lit_scene_free(&s);
}

static void within(void) {
    lit_scene s = begin();
    plt_lighting l = slanting();
    test("a shadow ray that begins in glass leaves it, and fades on the way");
    l.light[0].at[0] = 0;
    l.bounces = 1;
    add_square(&s, 0, 1, 3, LIT_GLASS);
    shows(&s, &l, 2, 0.04f, 2, 1, "down by the eye's ray, up to the sun");
    lit_scene_free(&s);
}

static void opaque(void) {
    const float half = sqrtf(0.5f);
    lit_scene s = begin();
    plt_lighting l = slanting();
    test("what is opaque throws a shadow before glass and behind it, and glass if it is to");
    add_slab(&s, 1, 2.5f);
    l.solid_shadows = 1;
    shows(&s, &l, 0, 0, 0, 0, "solid");
    l.solid_shadows = 0;
    add_square(&s, -3, 3, 0.4f, LIT_PAINT);
    shows(&s, &l, 0, 0, 0, 0, "behind it");
    l.light[0] = (plt_light){{-2.8f, 2.8f, 0}, {15.68f, 15.68f, 15.68f}, 0, PLT_LIGHT_POINT, 1};
    shows(&s, &l, 2, at_45(), 1.5f * sqrtf(2), half, "the light is nearer");
    lit_scene_free(&s);
    s = begin();
    add_square(&s, -0.5f, 0.5f, 0.1f, LIT_PAINT);
    add_slab(&s, 1, 2.5f);
    l = slanting();
    shows(&s, &l, 0, 0, 0, 0, "before it");
    lit_scene_free(&s);
}

static void many(void) {
    lit_scene s = begin();
    plt_lighting l = slanting();
    material_values *g = &s.materials.material[LIT_GLASS].values;
    const float grazing = powf(1.0f - sqrtf(0.5f), 5);
    g->index = 1;
    test("light passes as many surfaces as it may, and no more");
    for (int i = 0; i < PLT_SHADOW_SURFACES / 2; i++) {
        add_slab(&s, 1.0f + 0.125f * (float)i, 1.0625f + 0.125f * (float)i);
    }
    const float distance = (PLT_SHADOW_SURFACES / 2) * 0.0625f * sqrtf(2);
    shows(&s, &l, PLT_SHADOW_SURFACES, grazing, distance, sqrtf(0.5f), "as many");
    add_square(&s, -2.5f, 2.5f, 0.4f, LIT_GLASS);
    shows(&s, &l, 0, 0, 0, 0, "one more");
    lit_scene_free(&s);
}

/* A frame's visits and colour. */
static uint64_t visits_of(const lit_scene *s, uint8_t solid, uint8_t rgb[3]) {
    plt_lighting l = slanting();
    uint64_t visits;
    l.solid_shadows = solid;
    see(s, &l, LIT_THESIS, rgb, &visits);
    return visits;
}

static void without_glass(void) {
    lit_scene s = begin();
    uint8_t clear[3], solid[3];
    test("without glass a shadow ray ends at the first thing that it meets, whatever is asked for");
    for (int i = 1; i <= 8; i++) {
        add_square(&s, -0.25f * (float)i, 0.25f * (float)i, 0.1f, LIT_PAINT);
    }
    const uint64_t visits = visits_of(&s, 0, clear);
    CHECK(visits > 0 && visits == visits_of(&s, 1, solid), "%u", (unsigned)visits);
    CHECK(memcmp(clear, solid, 3) == 0, "colours");
    s.materials.material[LIT_PAINT].values.transparency = 1;
    CHECK(visits_of(&s, 0, clear) > visits, "of glass they take more");
    lit_scene_free(&s);
}

int main(void) {
    slab();
    within();
    opaque();
    many();
    without_glass();
    return test_done();
}
