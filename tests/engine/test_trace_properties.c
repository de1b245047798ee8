/* test_trace_properties - properties of hits that hold for any scene
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/reference/rays.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

#define RAYS 4096u

static plt_ray rays[RAYS];
static plt_hit hits[RAYS], others[RAYS];

static int same(const plt_hit *a, const plt_hit *b) {
    return memcmp(a, b, sizeof *a) == 0;
}

static rig opened(const mesh *m, uint8_t build, uint8_t order) {
    rig r;
    rig_config config = rig_config_of(2, 3, build, PLT_SPLIT_SAH);
    config.run.order = order;
    const int status = rig_open(&r, m, &config);
    CHECK(status == PLT_OK, "%s: %s", rig_name(&config), r.fault.message);
    if (status != PLT_OK) {
        exit(test_done());
    }
    return r;
}

/* 128 triangles and RAYS mixed rays at them, traced. */
static mesh soup(uint64_t seed) {
    mesh m = {0};
    random_state r = {seed};
    shape_soup(&m, 100, 0.7f, seed);
    shape_sheet(&m, 3, (int)(seed % 3));
    shape_coincident(&m, 5);
    rays_mixed(rays, RAYS, &m, &r);
    rig one = opened(&m, PLT_BUILD_HOST, PLT_ORDER_DEPTH_FIRST);
    plt_trace(one.engine, rays, hits, RAYS, 0);
    rig_close(&one);
    uint32_t met = 0;
    for (uint32_t i = 0; i < RAYS; i++) {
        met += hits[i].triangle != PLT_MISS;
    }
    CHECK(met > RAYS / 8 && met < RAYS, "%u of %u rays hit", met, RAYS);
    return m;
}

static void trace_other(const mesh *m, const plt_ray *by, int any) {
    rig one = opened(m, PLT_BUILD_HOST, PLT_ORDER_TWO_STAGE);
    plt_trace(one.engine, by, others, RAYS, any);
    rig_close(&one);
}

static void occlusion(uint64_t seed) {
    mesh m = soup(seed);
    trace_other(&m, rays, 1);
    for (uint32_t i = 0; i < RAYS; i++) {
        const plt_hit expected = {0.0f, 0.0f, 0.0f, hits[i].triangle != PLT_MISS};
        CHECK(same(&others[i], &expected), "ray %u: any %u, nearest %u", i, others[i].triangle,
              hits[i].triangle);
    }
    mesh_free(&m);
}

/* Triangle i of `m` gets primitive id `number[i]`. */
static void shuffle(mesh *m, uint32_t *number, uint64_t seed) {
    random_state r = {seed};
    const uint32_t count = (uint32_t)m->triangles;
    uint32_t *triangle = malloc(12 * (size_t)count), *from = malloc(4 * (size_t)count);
    for (uint32_t i = 0; i < count; i++) {
        from[i] = i;
    }
    for (uint32_t i = count; i-- > 1;) {
        const uint32_t k = random_below(&r, i + 1), t = from[i];
        from[i] = from[k];
        from[k] = t;
    }
    for (uint32_t i = 0; i < count; i++) {
        number[from[i]] = i;
        memcpy(triangle + 3 * i, m->triangle + 3 * from[i], 12);
    }
    memcpy(m->triangle, triangle, 12 * (size_t)count);
    free(triangle);
    free(from);
}

static void permutation(uint64_t seed) {
    mesh m = soup(seed);
    uint32_t *number = malloc(4 * m.triangles), ties = 0;
    shuffle(&m, number, seed + 1);
    trace_other(&m, rays, 0);
    for (uint32_t i = 0; i < RAYS; i++) {
        plt_hit expected = hits[i];
        if (hits[i].triangle != PLT_MISS) {
            expected.triangle = number[hits[i].triangle];
        }
        /* A tie may go to another triangle, but only to one with a lower id now. */
        const int tie = others[i].triangle < expected.triangle;
        ties += tie != 0;
        CHECK(others[i].t == hits[i].t, "ray %u", i);
        CHECK(tie || same(&others[i], &expected), "ray %u: %u, not %u", i, others[i].triangle,
              expected.triangle);
    }
    CHECK(ties < RAYS / 2, "%u ties", ties);
    free(number);
    mesh_free(&m);
}

static void lowest_id_wins(uint8_t build, uint8_t order) {
    mesh m = {0};
    random_state r = {5};
    shape_soup(&m, 20, 0.5f, 5);
    for (uint32_t copies = 0; copies < 3;
         copies++) { /* once more, with the corners in another order */
        for (uint32_t i = 0; i < 20; i++) {
            fail f = {""};
            const uint32_t *t = m.triangle + 3 * i;
            const uint32_t a = t[0], b = t[1], c = t[2];
            mesh_add_triangle(&m, a, b, c, &f);
        }
    }
    rays_mixed(rays, RAYS, &m, &r);
    rig one = opened(&m, build, order);
    plt_trace(one.engine, rays, hits, RAYS, 0);
    for (uint32_t i = 0; i < RAYS; i++) {
        CHECK(hits[i].triangle < 20 || hits[i].triangle == PLT_MISS, "ray %u: %u", i,
              hits[i].triangle);
    }
    rig_close(&one);
    mesh_free(&m);
}

/* With tmax at t the hit stays; just below t it is lost, and nothing nearer is found. */
static void shrink(uint64_t seed) {
    mesh m = soup(seed);
    plt_ray shorter[RAYS];
    for (uint32_t i = 0; i < RAYS; i++) {
        shorter[i] = rays[i];
        shorter[i].tmax = hits[i].triangle == PLT_MISS ? 0.5f * rays[i].tmax : hits[i].t;
        shorter[i].tmax = fmaxf(shorter[i].tmax, shorter[i].tmin);
    }
    trace_other(&m, shorter, 0);
    for (uint32_t i = 0; i < RAYS; i++) {
        CHECK(same(&others[i], &hits[i]), "tmax at t, ray %u: %u, not %u", i, others[i].triangle,
              hits[i].triangle);
        shorter[i].tmax = nextafterf(hits[i].t, -1.0f);
    }
    trace_other(&m, shorter, 0);
    for (uint32_t i = 0; i < RAYS; i++) {
        CHECK(others[i].triangle == PLT_MISS, "tmax below t, ray %u", i);
    }
    mesh_free(&m);
}

/* With tmin at t the hit stays; above t the next hit is no nearer. */
static void advance(uint64_t seed) {
    mesh m = soup(seed);
    plt_ray later[RAYS];
    for (uint32_t i = 0; i < RAYS; i++) {
        later[i] = rays[i];
        later[i].tmin = hits[i].triangle == PLT_MISS ? rays[i].tmin : hits[i].t;
    }
    trace_other(&m, later, 0);
    for (uint32_t i = 0; i < RAYS; i++) {
        CHECK(same(&others[i], &hits[i]), "tmin at t, ray %u", i);
        later[i].tmin = hits[i].triangle == PLT_MISS ? rays[i].tmin : nextafterf(hits[i].t, 1e38f);
    }
    trace_other(&m, later, 0);
    for (uint32_t i = 0; i < RAYS; i++) {
        const int next = others[i].triangle != PLT_MISS;
        CHECK(!next || (hits[i].triangle != PLT_MISS && others[i].t > hits[i].t), "ray %u", i);
    }
    mesh_free(&m);
}

/* Scene and origins by 2^power, directions by 2^dir_power. */
static void scale(uint64_t seed, int power, int dir_power) {
    mesh m = soup(seed);
    plt_ray scaled[RAYS];
    for (size_t i = 0; i < 3 * m.vertices; i++) {
        m.vertex[i] = ldexpf(m.vertex[i], power);
    }
    for (uint32_t i = 0; i < RAYS; i++) {
        scaled[i] = rays[i];
        for (int a = 0; a < 3; a++) {
            scaled[i].org[a] = ldexpf(rays[i].org[a], power);
            scaled[i].dir[a] = ldexpf(rays[i].dir[a], dir_power);
        }
        scaled[i].tmin = ldexpf(rays[i].tmin, power - dir_power);
        scaled[i].tmax = rays[i].tmax < 1e30f ? ldexpf(rays[i].tmax, power - dir_power) : RAYS_FAR;
    }
    trace_other(&m, scaled, 0);
    for (uint32_t i = 0; i < RAYS; i++) {
        plt_hit expected = hits[i];
        expected.t = ldexpf(hits[i].t, power - dir_power);
        CHECK(same(&others[i], &expected), "2^%d, 2^%d, ray %u: %g, not %g", power, dir_power, i,
              (double)others[i].t, (double)expected.t);
    }
    mesh_free(&m);
}

/* Corners a and b of every triangle are exchanged: so are u and v, and t is close. */
static void reverse_triangles(uint64_t seed) {
    mesh m = soup(seed);
    uint32_t unchanged = 0;
    for (size_t i = 0; i < m.triangles; i++) {
        const uint32_t t = m.triangle[3 * i + 1];
        m.triangle[3 * i + 1] = m.triangle[3 * i + 2];
        m.triangle[3 * i + 2] = t;
    }
    trace_other(&m, rays, 0);
    for (uint32_t i = 0; i < RAYS; i++) {
        unchanged += same(&hits[i], &others[i]) != 0;
        CHECK(hits[i].triangle == others[i].triangle && hits[i].t == others[i].t, "ray %u", i);
        /* u + v + w is summed in another order: two roundings. */
        CHECK(fabsf(hits[i].u - others[i].v) <= 2.5e-7f &&
                  fabsf(hits[i].v - others[i].u) <= 2.5e-7f,
              "ray %u: u and v", i);
    }
    CHECK(unchanged < RAYS, "nothing changed");
    mesh_free(&m);
}

/* The scene mirrored. Negating an axis changes no rounding, but another corner may come first
 * in canonical order: a few roundings in t. */
static void mirror(uint64_t seed, int axis) {
    mesh m = soup(seed);
    plt_ray image[RAYS];
    for (size_t i = 0; i < m.vertices; i++) {
        m.vertex[3 * i + (size_t)axis] *= -1.0f;
    }
    memcpy(image, rays, sizeof image);
    for (uint32_t i = 0; i < RAYS; i++) {
        image[i].org[axis] *= -1.0f;
        image[i].dir[axis] *= -1.0f;
    }
    trace_other(&m, image, 0);
    for (uint32_t i = 0; i < RAYS; i++) {
        const plt_hit *h = &hits[i], *o = &others[i]; /* a zero may change its sign */
        CHECK(h->triangle == o->triangle && fabsf(h->t - o->t) <= 1e-5f * h->t + 1e-6f &&
                  fabsf(h->u - o->u) <= 1e-4f && fabsf(h->v - o->v) <= 1e-4f,
              "axis %d, ray %u: %u t %.9g, not %u t %.9g", axis, i, others[i].triangle,
              (double)others[i].t, hits[i].triangle, (double)hits[i].t);
    }
    mesh_free(&m);
}

/* x y z become y z x: the same hits, but sums are computed in another order. */
static void rotate_axes(uint64_t seed) {
    mesh m = soup(seed);
    plt_ray rotated[RAYS];
    uint32_t off = 0;
    for (size_t i = 0; i < m.vertices; i++) {
        float *v = m.vertex + 3 * i, x = v[0];
        v[0] = v[1];
        v[1] = v[2];
        v[2] = x;
    }
    for (uint32_t i = 0; i < RAYS; i++) {
        rotated[i] = rays[i];
        for (int a = 0; a < 3; a++) {
            rotated[i].org[a] = rays[i].org[(a + 1) % 3];
            rotated[i].dir[a] = rays[i].dir[(a + 1) % 3];
        }
    }
    trace_other(&m, rotated, 0);
    for (uint32_t i = 0; i < RAYS; i++) {
        const int bounded = rays[i].tmin > 0.0f || rays[i].tmax < 1e30f;
        CHECK(bounded || (hits[i].triangle == PLT_MISS) == (others[i].triangle == PLT_MISS),
              "ray %u: %u, not %u", i, others[i].triangle, hits[i].triangle);
        off += hits[i].triangle != others[i].triangle ||
               !(fabsf(hits[i].t - others[i].t) <= 1e-5f * hits[i].t);
    }
    CHECK(off < RAYS / 100, "%u hits differ in triangle, or by more than 1e-5", off);
    mesh_free(&m);
}

static plt_ray garbage(random_state *r) {
    plt_ray ray;
    for (size_t i = 0; i < sizeof ray / 4; i++) {
        const uint32_t bits = (uint32_t)random_bits(r);
        memcpy((unsigned char *)&ray + 4 * i, &bits, 4);
    }
    if (random_below(r, 2)) {
        ray.dir[random_below(r, 3)] = NAN;
    }
    return ray;
}

/* Every third ray stays, garbage replaces the others. */
static void company(uint64_t seed, uint8_t order) {
    mesh m = soup(seed);
    random_state r = {seed};
    plt_ray mixed[RAYS];
    for (uint32_t i = 0; i < RAYS; i++) {
        mixed[i] = i % 3 == 0 ? rays[i] : garbage(&r);
    }
    rig one = opened(&m, PLT_BUILD_HOST, order);
    plt_trace(one.engine, mixed, others, RAYS, 0);
    for (uint32_t i = 0; i < RAYS; i += 3) {
        CHECK(same(&hits[i], &others[i]), "ray %u", i);
    }
    plt_trace(one.engine, mixed, others, RAYS, 1);
    for (uint32_t i = 0; i < RAYS; i += 3) {
        CHECK(others[i].triangle == (hits[i].triangle != PLT_MISS), "any, ray %u", i);
    }
    rig_close(&one);
    mesh_free(&m);
}

static void any_count(uint64_t seed) {
    mesh m = soup(seed);
    const plt_hit untouched = {-7.0f, -7.0f, -7.0f, 77};
    rig one = opened(&m, PLT_BUILD_HOST, PLT_ORDER_DEPTH_FIRST);
    for (uint32_t count = 0; count < 600; count += count < 70 ? 1 : 37) {
        /* Arrays of exactly the requested size: sanitizers see one element too many. */
        plt_ray *some = malloc(count * sizeof *some + 1);
        plt_hit *found = malloc((count + 1) * sizeof *found);
        memcpy(some, rays + 100, count * sizeof *some);
        found[count] = untouched;
        plt_trace(one.engine, some, found, count, 0);
        for (uint32_t i = 0; i < count; i++) {
            CHECK(same(&found[i], &hits[100 + i]), "ray %u of %u", i, count);
        }
        CHECK(same(&found[count], &untouched), "hit %u was written", count);
        free(some);
        free(found);
    }
    rig_close(&one);
    mesh_free(&m);
}

int main(void) {
    test("any hit is the same as having a nearest hit");
    occlusion(1);
    occlusion(2);
    test("the order of triangles changes only their primitive ids");
    permutation(3);
    permutation(4);
    test("of triangles hit at equal t the lowest primitive id wins");
    for (uint8_t build = 0; build < 3; build++) {
        lowest_id_wins(build, PLT_ORDER_DEPTH_FIRST);
        lowest_id_wins(build, PLT_ORDER_TWO_STAGE);
    }
    test("tmax at t keeps a hit, tmax below t finds nothing");
    shrink(6);
    test("tmin at t keeps a hit, tmin above t finds only hits behind it");
    advance(7);
    test("scaling by powers of two scales t exactly and nothing else");
    scale(8, 0, 0);
    scale(8, 19, 0);
    scale(8, -19, 0);
    scale(9, 0, 50);
    scale(9, 12, -50);
    test("reversing the winding of triangles exchanges u and v");
    reverse_triangles(10);
    test("a mirrored scene has mirrored hits");
    for (int axis = 0; axis < 3; axis++) {
        mirror(11, axis);
    }
    test("a scene with its axes exchanged has the same hits and misses");
    rotate_axes(15);
    rotate_axes(16);
    test("hits do not depend on the other rays of a packet, even if these are garbage");
    company(12, PLT_ORDER_DEPTH_FIRST);
    company(13, PLT_ORDER_TWO_STAGE);
    test("any count of rays is traced, and no hit beyond it is written");
    any_count(14);
    return test_done();
}
