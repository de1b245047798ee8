/* test_trace_odd - invalid rays, and rays at the limits
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/scenes/scenes.h"
#include "tests/reference/brute.h"
#include "tests/reference/rays.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/reference/visits.h"
#include "tests/test.h"

static const float INF = HUGE_VALF;

static rig opened(const mesh *m, uint8_t order) {
    rig r;
    rig_config config = rig_config_of(2, 3, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    config.run.order = order;
    const int status = rig_open(&r, m, &config);
    CHECK(status == PLT_OK, "%s: %s", rig_name(&config), r.fault.message);
    if (status != PLT_OK) {
        exit(test_done());
    }
    return r;
}

static plt_hit trace1(plt_engine *e, plt_ray ray) {
    plt_hit hit = {1, 2, 3, 4}, any = hit;
    plt_trace(e, &ray, &hit, 1, 0);
    plt_trace(e, &ray, &any, 1, 1);
    CHECK(any.triangle == (hit.triangle != PLT_MISS) && any.t == 0.0f, "any hit differs");
    return hit;
}

static plt_ray towards(float x, float y, float z, float dx, float dy, float dz) {
    const float org[3] = {x, y, z}, dir[3] = {dx, dy, dz};
    return ray_make(org, dir, 0.0f, RAYS_FAR);
}

static void hits_nothing(plt_engine *e, plt_ray ray, const char *what) {
    const plt_hit hit = trace1(e, ray), miss = {0.0f, 0.0f, 0.0f, PLT_MISS};
    CHECK(memcmp(&hit, &miss, sizeof hit) == 0, "%s: triangle %u, t %g", what, hit.triangle,
          (double)hit.t);
}

static void hits_at(plt_engine *e, plt_ray ray, double t, const char *what) {
    const plt_hit hit = trace1(e, ray);
    CHECK(hit.triangle != PLT_MISS && fabs((double)hit.t - t) <= 1e-5 * fabs(t),
          "%s: triangle %u, t %g, not %g", what, hit.triangle, (double)hit.t, t);
}

/* In the cube -1 .. 1, one field after another made NaN or infinite. */
static void not_finite(plt_engine *e) {
    const float bad[3] = {NAN, INF, -INF};
    for (int field = 0; field < 8; field++) {
        for (int i = 0; i < 3; i++) {
            plt_ray ray = towards(0.1f, 0.2f, 0.3f, 0.5f, 0.25f, 1.0f);
            memcpy((unsigned char *)&ray + 4 * field, &bad[i], 4);
            const int allowed = (field == 7 && i == 1) || (field == 3 && i == 2);
            if (allowed) { /* tmax infinite, tmin minus infinite */
                hits_at(e, ray, 0.7, "an infinite interval");
            } else {
                hits_nothing(e, ray, "not a number or infinite");
            }
        }
    }
}

static void directions(plt_engine *e) {
    const float low = ldexpf(1.0f, -60), high = ldexpf(1.0f, 60);
    hits_nothing(e, towards(0, 0, 0, 0, 0, 0), "no direction");
    hits_nothing(e, towards(0, 0, 0, -0.0f, 0, -0.0f), "no direction, minus zero");
    hits_nothing(e, towards(0, 0, 0, 1e-40f, 0, 0), "subnormal");
    hits_nothing(e, towards(0, 0, 0, nextafterf(low, 0), 0, 0), "just below 2^-60");
    hits_nothing(e, towards(0, 0, 0, nextafterf(high, INF), 0, 0), "just above 2^60");
    hits_nothing(e, towards(0, 0, 0, 1, nextafterf(high, INF), 0), "one component too large");
    hits_at(e, towards(0, 0, 0, low, 0, 0), ldexp(1.0, 60), "2^-60");
    hits_at(e, towards(0, 0, 0, 0, -high, 0), ldexp(1.0, -60), "2^60");
    hits_at(e, towards(0, 0, 0, low, low, -low), ldexp(1.0, 60), "2^-60 diagonally");
    hits_at(e, towards(0, 0, 0, high, -high, high), ldexp(1.0, -60), "2^60 diagonally");
    hits_at(e, towards(0.5f, 0, 0, 1, 1e-40f, -1e-44f), 0.5, "subnormal beside 1");
    hits_at(e, towards(0.5f, 0, 0, 1e-30f, 0, 1), 1.0, "tiny beside 1");
    hits_nothing(e, towards(2e12f, 0, 0, -1, 0, 0), "origin beyond 2^40");
    hits_at(e, towards(PLT_COORD_MAX, 0, 0, -1, 0, 0), (double)PLT_COORD_MAX, "origin at 2^40");
}

static plt_ray bounded(float tmin, float tmax) {
    plt_ray ray = towards(-2.0f, 0.25f, 0.125f, 1.0f, 0.0f, 0.0f); /* walls at t = 1 and 3 */
    ray.tmin = tmin;
    ray.tmax = tmax;
    return ray;
}

static void intervals(plt_engine *e) {
    hits_nothing(e, bounded(2.0f, 1.0f), "tmin > tmax");
    hits_nothing(e, bounded(0.0f, -1.0f), "tmax below 0");
    hits_nothing(e, bounded(-5.0f, -1.0f), "all below 0");
    hits_nothing(e, bounded(1.5f, 2.5f), "between the walls");
    hits_nothing(e, bounded(nextafterf(1.0f, 2.0f), nextafterf(3.0f, 2.0f)), "just between");
    hits_at(e, bounded(-100.0f, 100.0f), 1.0, "tmin below 0");
    hits_at(e, bounded(1.0f, 1.0f), 1.0, "tmin = tmax = t");
    hits_at(e, bounded(3.0f, 3.0f), 3.0, "tmin = tmax = t behind");
    hits_at(e, bounded(1.5f, 3.0f), 3.0, "tmax at the second wall");
    hits_at(e, bounded(0.0f, INF), 1.0, "tmax infinite");
    hits_nothing(e, bounded(INF, INF), "both infinite");
}

static void on_surfaces(plt_engine *e) {
    hits_at(e, towards(-1, 0.25f, 0.125f, 1, 0, 0), 0.0, "starts on a plane, leaves it");
    hits_at(e, towards(-1, 0.25f, 0.125f, -1, 0, 0), 0.0, "starts on a plane, goes outward");
    hits_at(e, towards(-1, -1, -1, 1, 1, 1), 0.0, "starts at a vertex");
    hits_at(e, towards(1, 1, -1, -1, 1, 1), 0.0, "starts at a vertex, grazes");
    hits_at(e, towards(-1, -1, 0, 0, 1, 1), 0.0, "starts on an edge");
    hits_at(e, towards(-2, -2, -2, 1, 1, 1), 1.0, "through two vertices");
    hits_at(e, towards(-2, 0, 0, 1, 0, 0), 1.0, "through two diagonals");
    hits_at(e, towards(-2, -1, 0, 1, 1, 0), 1.0, "through an edge");
}

/* In the plane of a face a ray may hit or miss, but the answer must be the same in any packet,
 * without a NaN and within the interval. */
static void in_the_plane(plt_engine *e) {
    random_state r = {3};
    for (int i = 0; i < 2000; i++) {
        float org[3], dir[3], lo[3] = {-2, -2, -2}, hi[3] = {2, 2, 2};
        const unsigned axis = random_below(&r, 3);
        random_point(&r, lo, hi, org);
        random_point(&r, lo, hi, dir);
        org[axis] = random_below(&r, 2) ? 1.0f : -1.0f;
        dir[axis] = random_below(&r, 2) ? 0.0f : -0.0f;
        if (random_below(&r, 3) == 0) {
            dir[(axis + 1) % 3] = 0.0f;
        }
        const plt_hit hit = trace1(e, ray_make(org, dir, 0.0f, RAYS_FAR));
        CHECK(hit.t >= 0.0f && hit.t <= RAYS_FAR && hit.u >= 0.0f && hit.u <= 1.0f &&
                  hit.v >= 0.0f && hit.v <= 1.0f,
              "t %g, u %g, v %g", (double)hit.t, (double)hit.u, (double)hit.v);
        CHECK(hit.triangle < 12 || hit.triangle == PLT_MISS, "triangle %u", hit.triangle);
    }
}

static float any_float(random_state *r) {
    const uint32_t bits = (uint32_t)random_bits(r);
    float x;
    memcpy(&x, &bits, 4);
    return random_below(r, 4) ? ldexpf(random_float(r, -1, 1), (int)random_below(r, 140) - 70) : x;
}

/* Random bits as rays: no NaN is returned, and hits are in range. */
static void any_bits(const mesh *m, uint8_t order) {
    rig one = opened(m, order);
    random_state r = {11};
    uint32_t met = 0;
    for (int round = 0; round < 400; round++) {
        plt_ray rays[64];
        plt_hit hits[64];
        for (int i = 0; i < 64; i++) {
            const float org[3] = {any_float(&r), any_float(&r), any_float(&r)};
            const float dir[3] = {any_float(&r), any_float(&r), any_float(&r)};
            rays[i] = ray_make(org, dir, any_float(&r), any_float(&r));
        }
        plt_trace(one.engine, rays, hits, 64, 0);
        for (int i = 0; i < 64; i++) {
            const plt_hit *h = &hits[i];
            const int miss = h->triangle == PLT_MISS && h->t == 0.0f && h->u == 0 && h->v == 0;
            CHECK(miss || (h->triangle < m->triangles && h->t >= rays[i].tmin && h->t >= 0.0f &&
                           h->t <= rays[i].tmax && h->u >= 0.0f && h->v >= 0.0f),
                  "triangle %u, t %g", h->triangle, (double)h->t);
            met += h->triangle != PLT_MISS;
        }
    }
    CHECK(met >= 100, "only %u hits", met);
    plt_stats s;
    plt_stats_get(one.engine, &s);
    CHECK(s.node_visits <= visits_most(&s, plt_engine_info(one.engine)->nodes), "%llu visits",
          (unsigned long long)s.node_visits);
    rig_close(&one);
}

/* Coordinates and origins up to 2^40: products come near overflow. */
static void far_corners(void) {
    mesh m = {0};
    random_state r = {2};
    shape_soup(&m, 60, 1.0f, 21);
    shape_transform(&m, PLT_COORD_MAX / 2.5f, 0.0f, 0.0f, 0.0f);
    rig one = opened(&m, PLT_ORDER_DEPTH_FIRST);
    uint32_t hits = 0;
    for (int i = 0; i < 3000; i++) {
        float from[3], to[3], lo[3], hi[3];
        int unsure;
        shape_box(&m, lo, hi);
        random_point(&r, lo, hi, from);
        random_point(&r, lo, hi, to);
        plt_ray ray = ray_between(from, to);
        for (int a = 0; a < 3; a++) {
            ray.dir[a] = ldexpf(ray.dir[a], i % 2 ? 18 : -90);
        }
        const plt_hit hit = trace1(one.engine, ray);
        const char *wrong = brute_objects(&m, &ray, &hit, &unsure);
        CHECK(wrong == NULL, "ray %d: %s", i, wrong);
        hits += hit.triangle != PLT_MISS;
    }
    CHECK(hits > 500, "%u hits", hits);
    rig_close(&one);
    mesh_free(&m);
}

/* Towards edges and corners of the mesh, from its surroundings and from very far, in turn. */
static void rays_of_all_reaches(const mesh *m, random_state *r, plt_ray *rays, uint32_t count) {
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t *corner = &m->triangle[3 * random_below(r, (uint32_t)m->triangles)];
        const float *p = &m->vertex[3 * corner[0]], *q = &m->vertex[3 * corner[1]];
        const float along = (float)random_below(r, 5) / 4, far = ldexpf(1.0f, i % 2 ? 20 : 0);
        float to[3], from[3];
        for (int a = 0; a < 3; a++) {
            to[a] = p[a] + along * (q[a] - p[a]);
            from[a] = to[a] + far * random_float(r, a == 2 ? 0.8f : -0.2f, a == 2 ? 1.0f : 0.2f);
        }
        rays[i] = ray_between(from, to);
    }
}

/* What a packet knows of all its rays must do for each of them. */
static void one_by_one(uint8_t side, uint8_t order) {
    enum { RAYS = 2048 };
    static plt_ray rays[RAYS];
    static plt_hit hits[RAYS];
    mesh m = {0};
    fail f = {""};
    random_state r = {5};
    scene_knot(&m, rig_triangles(4000, 2), &f);
    rig one;
    rig_config config = rig_config_of(2, 3, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    config.run.packet_side = side;
    config.run.order = order;
    const int status = rig_open(&one, &m, &config);
    CHECK(status == PLT_OK, "%s: %s", rig_name(&config), one.fault.message);
    if (status != PLT_OK) {
        exit(test_done());
    }
    rays_of_all_reaches(&m, &r, rays, RAYS);
    for (int any = 0; any < 2; any++) {
        plt_trace(one.engine, rays, hits, RAYS, any);
        for (uint32_t i = 0; i < RAYS; i++) {
            plt_hit alone;
            plt_trace(one.engine, &rays[i], &alone, 1, any);
            CHECK(memcmp(&alone, &hits[i], sizeof alone) == 0, "side %u, ray %u: %u, alone %u",
                  side, i, hits[i].triangle, alone.triangle);
        }
    }
    rig_close(&one);
    mesh_free(&m);
}

#if PLT_WITH_WAVE
/* An interval that ends where the hit is has it, by the wave as in packets. */
static void ends_at_the_hit(uint8_t wide) {
    enum { RAYS = 1024 };
    static plt_ray rays[RAYS];
    static plt_hit hits[RAYS], again[RAYS];
    mesh m = {0};
    random_state r = {6};
    uint32_t found = 0;
    shape_soup(&m, 80, 0.6f, 7);
    rig one;
    rig_config config = rig_config_of(2, 3, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    config.run.rays_in_flight = 16;
    config.run.wide = wide;
    config.run.rays = PLT_RAYS_INCOHERENT;
    const int status = rig_open(&one, &m, &config);
    CHECK(status == PLT_OK, "%s: %s", rig_name(&config), one.fault.message);
    if (status != PLT_OK) {
        exit(test_done());
    }
    rays_mixed(rays, RAYS, &m, &r);
    plt_trace(one.engine, rays, hits, RAYS, 0);
    for (uint32_t i = 0; i < RAYS; i++) {
        rays[i].tmax = hits[i].triangle != PLT_MISS ? hits[i].t : rays[i].tmax;
    }
    for (int any = 0; any < 2; any++) {
        plt_trace(one.engine, rays, again, RAYS, any);
        for (uint32_t i = 0; i < RAYS; i++) {
            if (hits[i].triangle == PLT_MISS) {
                continue;
            }
            const uint32_t due = any ? 1 : hits[i].triangle;
            CHECK(again[i].triangle == due, "any %d, ray %u: %u, not %u", any, i, again[i].triangle,
                  due);
            found++;
        }
    }
    CHECK(found > RAYS / 8, "%u hits", found);
    rig_close(&one);
    mesh_free(&m);
}
#endif

static void visits_are_bounded(uint8_t order) {
    mesh m = {0};
    fail f = {""};
    random_state r = {8};
    plt_ray rays[1024];
    plt_hit hits[1024];
    plt_stats s;
    scene_knot(&m, rig_triangles(4000, 2), &f);
    rig one = opened(&m, order);
    for (int kind = 0; kind < 12; kind++) {
        plt_stats_reset(one.engine);
        rays_mixed(rays, 1024, &m, &r);
        plt_trace(one.engine, rays, hits, 1024, kind & 1);
        plt_stats_get(one.engine, &s);
        const uint64_t nodes = plt_engine_info(one.engine)->nodes;
        CHECK(s.node_visits <= visits_most(&s, nodes), "%llu visits",
              (unsigned long long)s.node_visits);
        CHECK(s.rays == 1024 && s.packets > 0 && s.mixed_packets <= s.packets, "statistics");
        CHECK(s.bytes_touched_once <= s.bytes_fetched &&
                  s.bytes_touched_once <= plt_engine_info(one.engine)->node_bytes + 64u,
              "bytes");
        CHECK(s.node_visits == 0 || s.treelet_fetches > 0, "no fetches");
    }
    rig_close(&one);
    mesh_free(&m);
}

static void empty(uint8_t build) {
    mesh m = {0};
    rig one;
    const rig_config config = rig_config_of(1, 2, build, PLT_SPLIT_SAH);
    CHECK(rig_open(&one, &m, &config) == PLT_OK, "%s", one.fault.message);
    hits_nothing(one.engine, towards(0, 0, 0, 1, 0, 0), "nothing to hit");
    const plt_info *info = plt_engine_info(one.engine);
    CHECK(info->triangles == 0 && info->nodes == 0, "counts");
    for (int a = 0; a < 3; a++) {
        CHECK(info->lo[a] > info->hi[a], "axis %d: %g .. %g", a, (double)info->lo[a],
              (double)info->hi[a]);
    }
    rig_close(&one);
}

int main(void) {
    mesh cube = {0}, mixed = {0};
    shape_cube(&cube);
    shape_soup(&mixed, 80, 0.6f, 77);
    shape_degenerate(&mixed);
    rig one = opened(&cube, PLT_ORDER_DEPTH_FIRST);
    test("NaN and infinity hit nothing, but an interval may be unbounded");
    not_finite(one.engine);
    test("directions from 2^-60 to 2^60 hit, others hit nothing");
    directions(one.engine);
    test("hits are in tmin .. tmax, both included");
    intervals(one.engine);
    test("rays that start on planes, edges and vertices hit them at 0");
    on_surfaces(one.engine);
    test("rays in the plane of a face get an id, a distance and weights in range, or a miss");
    in_the_plane(one.engine);
    test("random bits as rays give misses or hits in range");
    any_bits(&mixed, PLT_ORDER_DEPTH_FIRST);
    any_bits(&mixed, PLT_ORDER_TWO_STAGE);
    test("coordinates up to 2^40 overflow nothing");
    far_corners();
    test("a ray hits what it hits alone, however far the others of its packet come from");
    for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side = (uint8_t)(2 * side)) {
        one_by_one(side, PLT_ORDER_DEPTH_FIRST);
        one_by_one(side, PLT_ORDER_TWO_STAGE);
    }
#if PLT_WITH_WAVE
    test("a hit at tmax is one for single rays, too, the nearest and any");
    ends_at_the_hit(0);
    ends_at_the_hit(1);
#endif
    test("in a packet no group visits a node twice");
    visits_are_bounded(PLT_ORDER_DEPTH_FIRST);
    visits_are_bounded(PLT_ORDER_TWO_STAGE);
    test("a scene without triangles opens, has an empty box and is never hit");
    empty(PLT_BUILD_HOST);
    empty(PLT_BUILD_DEVICE);
    empty(PLT_BUILD_NONE);
    rig_close(&one);
    mesh_free(&cube);
    mesh_free(&mixed);
    return test_done();
}
