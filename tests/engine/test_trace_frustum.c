/* test_trace_frustum - no ray meets a triangle that the frustum culls
 *
 * Triangles of all sizes and shapes are near a bundle of rays: the first corner is on a ray, or
 * beside it by anything from a rounding to half the scene; or the rays are in the triangle's
 * plane. A triangle that the frustum of some groups culls is tested against every ray of these
 * groups all the same, and must have no hit.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "engine/planelet.h"
#include "engine/trace/frustum.h"
#include "engine/trace/triangle.h"
#include "tests/reference/random.h"
#include "tests/test.h"

enum { SIDE = 4, GROUPS = SIDE * SIDE / 4 };

typedef struct bundle {
    plt_group_slabs slabs[GROUPS];
    plt_group_rays rays[GROUPS];
    plt_packet packet;
    plt_box scene;
    float org[3];
} bundle;

/* `away`: the distance of the scene, of size 2, from the origin on all axes. */
static plt_box scene_at(float away) {
    const plt_box b = {{away - 1, away - 1, away - 1}, {away + 1, away + 1, away + 1}};
    return b;
}

/* Rays with slopes x .. x + spread, y .. y + spread along an axis, in either direction. */
static void make_bundle(bundle *b, random_state *r, float spread, float away) {
    const int axis = (int)random_below(r, 3);
    const float sign = random_below(r, 2) ? 1.0f : -1.0f, length = random_float(r, 0.5f, 2.0f);
    const float x = random_float(r, 0.0f, 0.9f - spread), y = random_float(r, 0.0f, 0.9f - spread);
    const float sign_x = random_below(r, 2) ? 1.0f : -1.0f,
                sign_y = random_below(r, 2) ? 1.0f : -1.0f;
    memset(b, 0, sizeof *b);
    b->scene = scene_at(away);
    b->packet.slabs.group = b->slabs;
    b->packet.rays = b->rays;
    plt_packet_begin(&b->packet, &b->scene, GROUPS, 0);
    const unsigned lanes = 1 + random_below(r, 4);
    for (int a = 0; a < 3; a++) {
        b->org[a] = away + random_float(r, -2.0f, 2.0f);
    }
    for (unsigned i = 0; i < GROUPS; i++) {
        float dir[3][4];
        f4 o[3], d[3];
        for (unsigned lane = 0; lane < 4; lane++) {
            const unsigned column = 2 * (i % (SIDE / 2)) + lane % 2,
                           row = 2 * (i / (SIDE / 2)) + lane / 2;
            const float along = sign * length;
            dir[axis][lane] = along;
            dir[(axis + 1) % 3][lane] = along * sign_x * (x + spread * (float)column / (SIDE - 1));
            dir[(axis + 2) % 3][lane] = along * sign_y * (y + spread * (float)row / (SIDE - 1));
        }
        for (int a = 0; a < 3; a++) {
            o[a] = f4_all(b->org[a]);
            d[a] = f4_load(dir[a]);
        }
        plt_packet_set_group(&b->packet, i, o, d, f4_zero(), f4_all(1e30f), lanes);
    }
    plt_packet_finish(&b->packet);
}

/* On a ray of the bundle, at distance t, or `off` beside it. */
static void point(const bundle *b, random_state *r, float t, float off, float to[3]) {
    const plt_group_rays *g = &b->rays[random_below(r, GROUPS)];
    const unsigned lane = random_below(r, 4);
    for (int a = 0; a < 3; a++) {
        to[a] = b->org[a] + t * g->dir[a][lane] + random_float(r, -off, off);
    }
}

static void measure(plt_triangle *t) {
    t->longest = 0.0f;
    for (int i = 0; i < 9; i++) {
        const float side = fabsf(t->corner[i % 3][i / 3] - t->corner[(i + 1) % 3][i / 3]);
        t->longest = side > t->longest ? side : t->longest;
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
    measure(t);
}

/* Does any ray of the groups meet the triangle? */
static int is_met(bundle *b, const plt_triangle *t, plt_mask groups) {
    int met = 0;
    plt_triangle_groups(&b->packet, t, groups);
    for (unsigned i = 0; i < GROUPS; i++) {
        for (unsigned lane = 0; lane < 4; lane++) {
            met |= b->rays[i].id[lane] != PLT_MISS;
            b->rays[i].id[lane] = PLT_MISS;
            b->slabs[i].tmax[lane] = b->rays[i].valid >> lane & 1u ? 1e30f : -1.0f;
        }
    }
    return met;
}

static int is_culled(const plt_frustum *frustum, const plt_triangle *t) {
    return plt_frustum_culls(plt_frustum_outcode(frustum, t->corner[0]),
                             plt_frustum_outcode(frustum, t->corner[1]),
                             plt_frustum_outcode(frustum, t->corner[2]));
}

typedef struct counts {
    unsigned triangles, culled, met, wrong, without;
} counts;

/* A triangle against some groups of a bundle. */
static void compare(counts *n, bundle *b, random_state *r, const plt_triangle *t) {
    const plt_mask groups = 1 + random_below(r, (1u << GROUPS) - 1);
    plt_frustum frustum;
    if (!plt_frustum_set(&frustum, &b->packet, groups)) {
        n->without++;
        return;
    }
    const int out = is_culled(&frustum, t), hit = is_met(b, t, groups);
    n->triangles++;
    n->culled += (unsigned)out;
    n->met += (unsigned)hit;
    n->wrong += (unsigned)(out && hit);
}

static void verdict(const counts *n) {
    CHECK(n->wrong == 0, "%u culled triangles are met", n->wrong);
    CHECK(n->culled > n->triangles / 50 && n->met > n->triangles / 100, "only %u culled, %u met",
          n->culled, n->met);
    printf("    %u triangles, %u met, %u culled\n", n->triangles, n->met, n->culled);
}

static void test_bundles(float spread, float away) {
    enum { BUNDLES = 4000, TRIANGLES = 50 };
    random_state r = {(uint64_t)(spread * 1e6f) + ((uint64_t)away << 32)};
    counts n = {0, 0, 0, 0, 0};
    for (int i = 0; i < BUNDLES; i++) {
        static bundle b;
        make_bundle(&b, &r, spread, away);
        for (int k = 0; k < TRIANGLES; k++) {
            plt_triangle t = {.word = 0, .ids = NULL};
            make_triangle(&b, &r, &t);
            compare(&n, &b, &r, &t);
        }
    }
    test("a triangle that the frustum of a bundle culls is met by none of its rays");
    CHECK(n.without == 0, "%u bundles have no frustum", n.without);
    verdict(&n);
}

static void whole_numbers(random_state *r, int most, float to[3]) {
    for (int a = 0; a < 3; a++) {
        to[a] = (float)((int)random_below(r, 2u * (unsigned)most + 1) - most);
    }
}

/* Rays in the plane that p and q span, from a grid point or very close to one. */
static void make_flat(bundle *b, random_state *r, const float p[3], const float q[3]) {
    memset(b, 0, sizeof *b);
    b->scene = (plt_box){{-4096, -4096, -4096}, {4096, 4096, 4096}};
    b->packet.slabs.group = b->slabs;
    b->packet.rays = b->rays;
    plt_packet_begin(&b->packet, &b->scene, GROUPS, 0);
    whole_numbers(r, 16, b->org);
    b->org[random_below(r, 3)] = ldexpf((float)random_below(r, 3), -(int)random_below(r, 40));
    for (unsigned i = 0; i < GROUPS; i++) {
        float dir[3][4];
        f4 o[3], d[3];
        for (unsigned lane = 0; lane < 4; lane++) {
            const float u = (float)(8 + random_below(r, 4)), v = (float)random_below(r, 4);
            for (int a = 0; a < 3; a++) {
                dir[a][lane] = u * p[a] + v * q[a];
            }
        }
        for (int a = 0; a < 3; a++) {
            o[a] = f4_all(b->org[a]);
            d[a] = f4_load(dir[a]);
        }
        plt_packet_set_group(&b->packet, i, o, d, f4_zero(), f4_all(1e30f), 4);
    }
    plt_packet_finish(&b->packet);
}

/* All edge functions are 0, or nearly so, for every ray. */
static void test_edge_on(void) {
    random_state r = {7};
    counts n = {0, 0, 0, 0, 0};
    test("a culled triangle seen edge-on is met by no ray");
    for (int i = 0; i < 400000; i++) {
        static bundle b;
        plt_triangle t = {.longest = 0.0f, .word = 0, .ids = NULL};
        float p[3], q[3];
        whole_numbers(&r, 9, p);
        whole_numbers(&r, 9, q);
        make_flat(&b, &r, p, q);
        for (int c = 0; c < 3; c++) {
            const float u = (float)random_below(&r, 40) - 4.0f;
            const float v = (float)random_below(&r, 40) - 20.0f;
            for (int a = 0; a < 3; a++) {
                t.corner[c][a] = rintf(b.org[a]) + u * p[a] + v * q[a];
            }
        }
        measure(&t);
        compare(&n, &b, &r, &t);
    }
    CHECK(n.wrong == 0, "%u culled triangles are met", n.wrong);
    CHECK(n.culled > 10000 && n.without < 390000, "%u culled, %u without a frustum", n.culled,
          n.without);
    printf("    %u triangles, %u met, %u culled\n", n.triangles, n.met, n.culled);
}

static void test_none(void) {
    static bundle b;
    random_state r = {1};
    plt_frustum frustum;
    test("rays without a common axis or origin, and no rays, have no frustum");
    make_bundle(&b, &r, 0.1f, 0.0f);
    CHECK(plt_frustum_set(&frustum, &b.packet, b.packet.active), "one bundle has");
    CHECK(!plt_frustum_set(&frustum, &b.packet, 0), "no groups");
    b.packet.axis = 3;
    CHECK(!plt_frustum_set(&frustum, &b.packet, b.packet.active), "no axis");
    b.packet.axis = 0;
    b.packet.slabs.coherence = PLT_ONE_SIGN;
    CHECK(!plt_frustum_set(&frustum, &b.packet, b.packet.active), "no origin");
}

int main(void) {
    static const float spreads[4] = {0.0f, 1e-6f, 1e-3f, 0.1f}, aways[3] = {0.0f, 4096.0f, 1e6f};
    for (int i = 0; i < 12; i++) {
        test_bundles(spreads[i % 4], aways[i / 4]);
    }
    test_edge_on();
    test_none();
    return test_done();
}
