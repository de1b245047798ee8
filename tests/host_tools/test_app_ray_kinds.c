/* test_app_ray_kinds - the rays that planelet bench makes are of the kinds it says
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "host_tools/app/ray_kinds.h"
#include "host_tools/pack/pack.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/rig.h"
#include "tests/test.h"

enum { WIDTH = 100, HEIGHT = 52, ARENA = 1 << 16, ALL_KINDS = (1 << RAY_KINDS) - 1 };
static _Alignas(PLT_ALIGN) unsigned char arena[ARENA];

static double dot(const float a[3], const float b[3]) {
    return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
}

static plt_engine *open_ground(packed *image) {
    mesh m = {0};
    fail f = {""};
    plt_fault fault;
    plt_engine *engine = NULL;
    const pack_options options = {.leaf_triangles = 2, .treelet_nodes = 64};
    const plt_options run = {.packet_side = PLT_PACKET_SIDE_MAX < 8 ? 2 : 8};
    CHECK(scene_ground(&m, &f) == 0 && pack_mesh(image, &m, &options, "ground", &f) == 0, "%s",
          f.text);
    const plt_source source = {.mapped = image->bytes, .bytes = image->size};
    CHECK(plt_open(&engine, arena, sizeof arena, &source, &run, &fault) == PLT_OK, "%s",
          fault.message);
    mesh_free(&m);
    return engine;
}

/* From above onto the middle of the slab, whose top is y = 0. */
static const plt_frame frame = {
    .width = WIDTH,
    .height = HEIGHT,
    .camera = {.eye = {0, 6, 0}, .look = {0, 0, 0}, .up = {0, 0, -1}, .tan_half_fov = 0.5f}};

static void check_primary(const ray_set *s) {
    test("primary rays: one through each pixel, square packets in tiles");
    CHECK(s->count == WIDTH * HEIGHT, "%u rays", (unsigned)s->count);
    /* On the slab, ray by ray: a pixel is 6 * 2 * 0.5 / 52 wide there. */
    const double pixel = 6.0 / HEIGHT;
    for (uint32_t i = 0; i + 4 <= 16 * 16 * (WIDTH / 16); i += 4) {
        double x[4], z[4];
        for (uint32_t k = 0; k < 4; k++) {
            const plt_ray *r = &s->rays[i + k];
            const double t = -(double)r->org[1] / (double)r->dir[1];
            x[k] = (double)r->org[0] + t * (double)r->dir[0];
            z[k] = (double)r->org[2] + t * (double)r->dir[2];
        }
        CHECK(fabs(x[1] - x[0] - pixel) < 1e-4 && fabs(x[3] - x[2] - pixel) < 1e-4 &&
                  fabs(z[2] - z[0] - pixel) < 1e-4 && fabs(z[3] - z[1] - pixel) < 1e-4,
              "group %u", (unsigned)i / 4);
    }
    CHECK(s->rays[0].org[1] == 6.0f && s->rays[0].tmin == 0.0f && s->rays[0].tmax > 1e30f, "ray 0");
}

static void check_shadow(const ray_kinds *r) {
    test("shadow rays: from above each hit, in their order, to one light");
    const ray_set *s = &r->of[RAYS_SHADOW], *p = &r->of[RAYS_PRIMARY];
    CHECK(s->count == p->count, "%u rays", (unsigned)s->count);
    for (uint32_t i = 0; i < s->count; i++) {
        const plt_ray *a = &s->rays[i];
        CHECK(a->org[1] > 0.0f && a->org[1] < 0.01f && a->tmax == 1.0f, "ray %u", (unsigned)i);
        for (int k = 0; k < 3; k++) {
            const double end = (double)a->org[k] + (double)a->dir[k];
            const double first = (double)s->rays[0].org[k] + (double)s->rays[0].dir[k];
            CHECK(fabs(end - first) < 1e-4, "ray %u, axis %d", (unsigned)i, k);
        }
        const double t = -(double)p->rays[i].org[1] / (double)p->rays[i].dir[1];
        CHECK(fabs((double)p->rays[i].org[0] + t * (double)p->rays[i].dir[0] - (double)a->org[0]) <
                  0.01,
              "ray %u is not of its hit", (unsigned)i);
    }
}

static void check_bounce(const ray_kinds *r) {
    test("bounce rays: upwards from the same points, by the cosine law, shuffled");
    const ray_set *s = &r->of[RAYS_BOUNCE], *h = &r->of[RAYS_SHADOW];
    CHECK(s->count == h->count, "%u rays", (unsigned)s->count);
    double cosine = 0.0, moved = 0.0, x = 0.0, sum[2] = {0, 0};
    for (uint32_t i = 0; i < s->count; i++) {
        const plt_ray *a = &s->rays[i];
        CHECK(a->dir[1] > 0.0f && fabs(dot(a->dir, a->dir) - 1.0) < 1e-5 && a->tmax > 1e30f,
              "ray %u", (unsigned)i);
        cosine += (double)a->dir[1] / s->count;
        x += (double)a->dir[0] / s->count;
        sum[0] += (double)a->org[0];
        sum[1] += (double)h->rays[i].org[0];
        moved += a->org[0] != h->rays[i].org[0] || a->org[2] != h->rays[i].org[2];
    }
    CHECK(fabs(cosine - 2.0 / 3.0) < 0.02, "the mean cosine is %g, of the law 2/3", cosine);
    CHECK(fabs(x) < 0.03, "the mean along x is %g", x);
    CHECK(fabs(sum[0] - sum[1]) < 1e-2, "other points: %g, %g", sum[0], sum[1]);
    CHECK(moved > 0.99 * s->count, "only %g are elsewhere", moved);
}

static void check_random(const ray_set *s, const plt_info *info) {
    test("random rays: from a side of the box through it, in all directions");
    int towards[8] = {0};
    CHECK(s->count == WIDTH * HEIGHT, "%u rays", (unsigned)s->count);
    for (uint32_t i = 0; i < s->count; i++) {
        const plt_ray *a = &s->rays[i];
        int on = 0;
        unsigned signs = 0;
        for (int k = 0; k < 3; k++) {
            CHECK(a->org[k] >= info->lo[k] && a->org[k] <= info->hi[k], "ray %u starts outside",
                  (unsigned)i);
            on |= a->org[k] == info->lo[k] || a->org[k] == info->hi[k];
            signs |= (unsigned)(a->dir[k] > 0.0f) << k;
        }
        CHECK(on, "ray %u starts on no side", (unsigned)i);
        towards[signs]++;
    }
    for (int k = 0; k < 8; k++) {
        CHECK(towards[k] > WIDTH * HEIGHT / 16, "%d rays in octant %d", towards[k], k);
    }
}

static void check_outside(const ray_set *s, const plt_info *info) {
    test("outside rays: lines through the ball around the box, in all directions alike");
    double middle[3], radius = 0.0, mean[3] = {0, 0, 0}, past = 0.0;
    CHECK(s->count == WIDTH * HEIGHT, "%u rays", (unsigned)s->count);
    for (int k = 0; k < 3; k++) {
        middle[k] = 0.5 * ((double)info->lo[k] + (double)info->hi[k]);
        radius += 0.25 * ((double)info->hi[k] - (double)info->lo[k]) *
                  ((double)info->hi[k] - (double)info->lo[k]);
    }
    radius = sqrt(radius);
    for (uint32_t i = 0; i < s->count; i++) {
        const plt_ray *a = &s->rays[i];
        double away = 0.0, along = 0.0;
        for (int k = 0; k < 3; k++) {
            const double from = (double)a->org[k] - middle[k];
            away += from * from;
            along += from * (double)a->dir[k];
            mean[k] += (double)a->dir[k] / s->count;
        }
        const double square = away - along * along; /* of the distance from the middle */
        CHECK(fabs(along + 2.0 * radius) < 1e-4 * radius && square < radius * radius * 1.0001,
              "ray %u: %g, %g", (unsigned)i, along, square);
        CHECK(fabs(dot(a->dir, a->dir) - 1.0) < 1e-5 && a->tmax > 1e30f, "ray %u", (unsigned)i);
        past += square / (radius * radius) / s->count;
    }
    CHECK(fabs(past - 0.5) < 0.02, "the mean square distance is %g, of a disc 0.5", past);
    CHECK(fabs(mean[0]) < 0.03 && fabs(mean[1]) < 0.03 && fabs(mean[2]) < 0.03, "%g %g %g", mean[0],
          mean[1], mean[2]);
}

static void check_inside(const ray_set *s, const plt_info *info) {
    test("inside rays: from the middle of the box, in all directions alike");
    double mean[3] = {0, 0, 0}, square[3] = {0, 0, 0};
    CHECK(s->count == WIDTH * HEIGHT, "%u rays", (unsigned)s->count);
    for (uint32_t i = 0; i < s->count; i++) {
        const plt_ray *a = &s->rays[i];
        CHECK(fabs(dot(a->dir, a->dir) - 1.0) < 1e-5 && a->tmax > 1e30f, "ray %u", (unsigned)i);
        for (int k = 0; k < 3; k++) {
            const double edge = (double)info->hi[k] - (double)info->lo[k];
            const double share = ((double)a->org[k] - (double)info->lo[k]) / edge;
            CHECK(share > 0.249 && share < 0.751, "ray %u, axis %d: %g", (unsigned)i, k, share);
            mean[k] += (double)a->dir[k] / s->count;
            square[k] += (double)a->dir[k] * (double)a->dir[k] / s->count;
        }
    }
    for (int k = 0; k < 3; k++) {
        CHECK(fabs(mean[k]) < 0.03 && fabs(square[k] - 1.0 / 3.0) < 0.02, "axis %d: %g %g", k,
              mean[k], square[k]);
    }
}

/* Of every set: those that are asked for, as they are among all; of the others nothing is kept. */
static void check_sets(const ray_kinds *all, plt_engine *engine) {
    test("each set of kinds is made alone, of the same rays");
    for (unsigned kinds = 0; kinds <= ALL_KINDS; kinds++) {
        ray_kinds r;
        fail f = {""};
        CHECK(ray_kinds_make(&r, kinds, engine, &frame, "ground", &f) == 0, "%s", f.text);
        for (int k = 0; k < RAY_KINDS; k++) {
            const ray_set *s = &r.of[k];
            const uint32_t count = kinds >> k & 1u ? all->of[k].count : 0;
            CHECK(s->count == count && (s->rays == NULL) == (count == 0), "set %u, %s: %u rays",
                  kinds, ray_kind_names[k], (unsigned)s->count);
            CHECK(count == 0 || memcmp(s->rays, all->of[k].rays, count * sizeof(plt_ray)) == 0,
                  "set %u, %s", kinds, ray_kind_names[k]);
        }
        ray_kinds_free(&r);
    }
}

static void check_closed_room(void) {
    mesh m = {0};
    packed image = {0};
    fail f = {""};
    plt_fault fault;
    plt_engine *engine = NULL;
    ray_kinds r = {0};
    const pack_options options = {.leaf_triangles = 2, .treelet_nodes = 64};
    const plt_options run = {.packet_side = 2};
    plt_frame inside = frame;
    inside.camera = (plt_camera){.eye = {0.3f, 1.6f, 1.5f}, .up = {0, 1, 0}, .tan_half_fov = 0.5f};
    test("from inside a closed room every ray hits, of primary and inside rays");
    CHECK(scene_room(&m, 24000, 0, &f) == 0 && pack_mesh(&image, &m, &options, "room", &f) == 0,
          "%s", f.text);
    const plt_source source = {.mapped = image.bytes, .bytes = image.size};
    CHECK(plt_open(&engine, arena, sizeof arena, &source, &run, &fault) == PLT_OK, "%s",
          fault.message);
    CHECK(ray_kinds_make(&r, ALL_KINDS, engine, &inside, "room", &f) == 0, "%s", f.text);
    plt_hit *hits = malloc(WIDTH * HEIGHT * sizeof *hits);
    for (int kind = RAYS_PRIMARY; kind <= RAYS_INSIDE; kind += RAYS_INSIDE - RAYS_PRIMARY) {
        uint32_t missed = 0;
        plt_trace(engine, r.of[kind].rays, hits, r.of[kind].count, 0);
        for (uint32_t i = 0; i < r.of[kind].count; i++) {
            missed += hits[i].triangle == PLT_MISS;
        }
        CHECK(missed == 0, "%s: %u of %u rays left the room", ray_kind_names[kind],
              (unsigned)missed, (unsigned)r.of[kind].count);
    }
    free(hits);
    ray_kinds_free(&r);
    pack_free(&image);
    mesh_free(&m);
}

int main(void) {
    packed image = {0};
    ray_kinds one = {0}, two = {0};
    fail f = {""};
    test("all kinds are made");
    plt_engine *engine = open_ground(&image);
    CHECK(ray_kinds_make(&one, ALL_KINDS, engine, &frame, "ground", &f) == 0, "%s", f.text);
    check_primary(&one.of[RAYS_PRIMARY]);
    check_shadow(&one);
    check_bounce(&one);
    check_random(&one.of[RAYS_RANDOM], plt_engine_info(engine));
    check_outside(&one.of[RAYS_OUTSIDE], plt_engine_info(engine));
    check_inside(&one.of[RAYS_INSIDE], plt_engine_info(engine));
    test("the same scene and view give the same rays");
    CHECK(ray_kinds_make(&two, ALL_KINDS, engine, &frame, "ground", &f) == 0, "%s", f.text);
    for (int k = 0; k < RAY_KINDS; k++) {
        CHECK(one.of[k].count == two.of[k].count &&
                  memcmp(one.of[k].rays, two.of[k].rays, one.of[k].count * sizeof(plt_ray)) == 0,
              "%s", ray_kind_names[k]);
    }
    ray_kinds_free(&two);
    check_sets(&one, engine);
    test("no hit, no rays from hits: refused");
    plt_frame away = frame;
    away.camera.look[1] = 99.0f;
    CHECK(ray_kinds_make(&two, ALL_KINDS, engine, &away, "ground", &f) == -1, "made");
    CHECK(strstr(f.text, "no primary ray") != NULL, "%s", f.text);
    for (unsigned kind = RAYS_PRIMARY; kind <= RAYS_INSIDE; kind++) {
        fail g = {""};
        ray_kinds_free(&two);
        CHECK((ray_kinds_make(&two, 1u << kind, engine, &away, "ground", &g) == -1) ==
                  (kind <= RAYS_BOUNCE),
              "%s alone: %s", ray_kind_names[kind], g.text);
    }
    ray_kinds_free(&one);
    ray_kinds_free(&two);
    pack_free(&image);
    if (!rig_is_tiny()) { /* a room has more levels */
        check_closed_room();
    }
    return test_done();
}
