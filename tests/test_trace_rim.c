/* test_trace_rim - a triangle that lies beside all rays is one that none of them meets
 *
 * Triangles of all sizes and shapes stand where a bundle of rays ends: corners on
 * rays of its rim, or as little as a rounding beside them. One that the rim says lies
 * beside is tested against every ray all the same, and may have no hit.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "engine/planelet.h"
#include "engine/trace/rim.h"
#include "engine/trace/triangle.h"
#include "tests/reference/random.h"
#include "tests/test.h"

enum { SIDE = 4, GROUPS = SIDE * SIDE / 4 };

typedef struct bundle {
    plt_group group[GROUPS];
    plt_packet packet;
    float org[3], corner[4][3]; /* directions of its corner rays */
} bundle;

/* `away`: of the scene, of size 2, from where coordinates are 0, on all axes. */
static plt_box scene_at(float away) {
    const plt_box b = {{away - 1, away - 1, away - 1}, {away + 1, away + 1, away + 1}};
    return b;
}

/* Rays of slopes x .. x + spread, y .. y + spread along an axis, one way or back. */
static void make_bundle(bundle *b, random_state *r, float spread, float away) {
    const plt_box scene = scene_at(away);
    const int axis = (int)random_below(r, 3);
    const float way = random_below(r, 2) ? 1.0f : -1.0f, length = random_float(r, 0.5f, 2.0f);
    const float x = random_float(r, 0.0f, 0.9f - spread), y = random_float(r, 0.0f, 0.9f - spread);
    const float sign_x = random_below(r, 2) ? 1.0f : -1.0f,
                sign_y = random_below(r, 2) ? 1.0f : -1.0f;
    memset(b, 0, sizeof *b);
    b->packet.group = b->group;
    plt_packet_begin(&b->packet, GROUPS, 0);
    for (int a = 0; a < 3; a++) {
        b->org[a] = away + random_float(r, -2.0f, 2.0f);
    }
    for (unsigned i = 0; i < GROUPS; i++) {
        float dir[3][4];
        f4 o[3], d[3];
        for (unsigned lane = 0; lane < 4; lane++) {
            const unsigned column = 2 * (i % (SIDE / 2)) + lane % 2,
                           row = 2 * (i / (SIDE / 2)) + lane / 2;
            const float along = way * length;
            dir[axis][lane] = along;
            dir[(axis + 1) % 3][lane] = along * sign_x * (x + spread * (float)column / (SIDE - 1));
            dir[(axis + 2) % 3][lane] = along * sign_y * (y + spread * (float)row / (SIDE - 1));
        }
        for (int a = 0; a < 3; a++) {
            o[a] = f4_all(b->org[a]);
            d[a] = f4_load(dir[a]);
        }
        plt_group_set(&b->packet, i, &scene, o, d, f4_zero(), f4_all(1e30f), 4);
    }
    plt_packet_finish(&b->packet);
}

/* On a ray of the bundle, at distance t, or `off` beside it. */
static void point(const bundle *b, random_state *r, float t, float off, float to[3]) {
    const plt_group *g = &b->group[random_below(r, GROUPS)];
    const unsigned lane = random_below(r, 4);
    for (int a = 0; a < 3; a++) {
        to[a] = b->org[a] + t * g->dir[a][lane] + random_float(r, -off, off);
    }
}

static void make_triangle(const bundle *b, random_state *r, plt_triangle *t) {
    static const float offs[5] = {0.0f, 1e-7f, 1e-5f, 1e-2f, 0.5f};
    const float at = random_float(r, 0.05f, 1.5f), size = ldexpf(1.0f, -(int)random_below(r, 24));
    float push[3];
    point(b, r, at, offs[random_below(r, 5)], t->corner[0]);
    for (int a = 0; a < 3; a++) {
        push[a] = random_float(r, -size, size);
        t->corner[1][a] = t->corner[0][a] + push[a];
        /* a sliver, or any shape */
        t->corner[2][a] =
            t->corner[0][a] + (random_below(r, 2) ? 2.0f * push[a] + random_float(r, -1e-7f, 1e-7f)
                                                  : random_float(r, -size, size));
    }
    t->longest = 0.0f;
    for (int i = 0; i < 9; i++) {
        const float side = fabsf(t->corner[i % 3][i / 3] - t->corner[(i + 1) % 3][i / 3]);
        t->longest = side > t->longest ? side : t->longest;
    }
}

/* Does any ray of the bundle meet the triangle? */
static int is_met(bundle *b, const plt_triangle *t) {
    int met = 0;
    plt_triangle_groups(&b->packet, t, b->packet.active);
    for (unsigned i = 0; i < GROUPS; i++) {
        for (unsigned lane = 0; lane < 4; lane++) {
            met |= b->group[i].source[lane] != PLT_MISS;
            b->group[i].source[lane] = PLT_MISS;
            b->group[i].tmax[lane] = 1e30f;
        }
    }
    return met;
}

static int is_beside(const plt_rim *rim, const plt_triangle *t) {
    return (plt_rim_code(rim, t->corner[0]) & plt_rim_code(rim, t->corner[1]) &
            plt_rim_code(rim, t->corner[2])) != 0;
}

static void test_bundles(float spread, float away) {
    enum { BUNDLES = 4000, TRIANGLES = 50 };
    random_state r = {(uint64_t)(spread * 1e6f)};
    unsigned beside = 0, met = 0, wrong = 0, without = 0;
    for (int i = 0; i < BUNDLES; i++) {
        static bundle b;
        plt_rim rim;
        make_bundle(&b, &r, spread, away);
        without += !plt_rim_set(&rim, &b.packet, b.packet.active);
        for (int k = 0; k < TRIANGLES; k++) {
            plt_triangle t = {.number = 0, .numbers = NULL};
            make_triangle(&b, &r, &t);
            const int out = is_beside(&rim, &t), hit = is_met(&b, &t);
            beside += (unsigned)out;
            met += (unsigned)hit;
            wrong += (unsigned)(out && hit);
        }
    }
    test("what lies beside a bundle of rays is met by none of them");
    CHECK(without == 0, "%u bundles have no rim", without);
    CHECK(wrong == 0, "%u triangles beside are met", wrong);
    CHECK(beside > BUNDLES && met > BUNDLES, "only %u beside, %u met", beside, met);
    printf("    slopes of %g, %g away: %u triangles, %u met, %u beside\n", (double)spread,
           (double)away, BUNDLES * TRIANGLES, met, beside);
}

static void test_none(void) {
    static bundle b;
    random_state r = {1};
    plt_rim rim;
    test("rays that share no axis or origin, and no rays, have no rim");
    make_bundle(&b, &r, 0.1f, 0.0f);
    CHECK(plt_rim_set(&rim, &b.packet, b.packet.active), "one bundle has");
    CHECK(!plt_rim_set(&rim, &b.packet, 0), "no groups");
    b.packet.axis = 3;
    CHECK(!plt_rim_set(&rim, &b.packet, b.packet.active), "no axis");
    b.packet.axis = 0;
    b.packet.shared = 0;
    CHECK(!plt_rim_set(&rim, &b.packet, b.packet.active), "no origin");
}

int main(void) {
    static const float spreads[4] = {0.0f, 1e-6f, 1e-3f, 0.1f}, aways[3] = {0.0f, 4096.0f, 1e6f};
    for (int i = 0; i < 12; i++) {
        test_bundles(spreads[i % 4], aways[i / 4]);
    }
    test_none();
    return test_done();
}
