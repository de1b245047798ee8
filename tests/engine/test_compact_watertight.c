/* test_compact_watertight - no ray passes through a closed mesh on a lattice
 *
 * Equal lattice coordinates become equal floats in every block, so a closed mesh stays closed.
 * Rays from points inside go to every vertex and the middle of every edge at their lattice
 * positions; others come from outside and must hit something before they arrive. The meshes are
 * chosen such that the lattice drops no sliver whose middle corner would be left on an edge.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "host_tools/pack/lattice_snap.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/rays.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { BATCH = 256, INSIDE = 3 };

typedef struct closed {
    const char *name;
    mesh m;
    float inside[INSIDE][3];
} closed;

static uint64_t traced, escaped;

static closed sphere(void) {
    closed c = {.name = "icosphere"};
    shape_icosphere(&c.m, rig_is_tiny() ? 1 : 2);
    random_state r = {4};
    for (int i = 1; i < INSIDE; i++) {
        const float lo[3] = {-0.4f, -0.4f, -0.4f}, hi[3] = {0.4f, 0.4f, 0.4f};
        random_point(&r, lo, hi, c.inside[i]);
    }
    return c;
}

/* The middles of rings: the tube is convex in each of its cross sections. */
static closed knot(uint32_t triangles) {
    closed c = {.name = "knot"};
    fail f = {""};
    CHECK(scene_knot(&c.m, triangles, &f) == 0, "%s", f.text);
    uint32_t sides = 3;
    while ((sides + 1) * (sides + 1) <= triangles / 20) {
        sides++;
    }
    const uint32_t rings = (uint32_t)c.m.vertices / sides;
    for (uint32_t i = 0; i < INSIDE; i++) {
        for (uint32_t k = 0; k < 3 * sides; k++) {
            c.inside[i][k % 3] += c.m.vertex[3 * sides * (i * rings / INSIDE) + k] / (float)sides;
        }
    }
    return c;
}

static void move(closed *c, float scale, float x, float y, float z) {
    const float move[3] = {x, y, z};
    shape_transform(&c->m, scale, x, y, z);
    for (int i = 0; i < 3 * INSIDE; i++) {
        float *p = &c->inside[i / 3][i % 3];
        *p = *p * scale + move[i % 3];
    }
}

/* No triangle is lost, and no two vertices coincide. */
static void stays_closed(const closed *c, uint8_t bits) {
    snapped s;
    fail f = {""};
    CHECK(lattice_snap(&s, &c->m, bits, c->name, &f) == 0, "%s", f.text);
    CHECK(s.count == c->m.triangles && s.loss.merged == 0 && s.loss.t_junctions == 0,
          "%s at %u bits: %u triangles of %zu", c->name, bits, s.count, c->m.triangles);
    snapped_free(&s);
}

static void shoot(const rig *r, const char *name, const plt_ray *rays, uint32_t count) {
    plt_hit hits[BATCH];
    plt_trace(r->engine, rays, hits, count, 0);
    for (uint32_t i = 0; i < count; i++) {
        traced++;
        escaped += hits[i].triangle == PLT_MISS;
        CHECK(hits[i].triangle != PLT_MISS, "%s: from %a %a %a along %a %a %a", name,
              (double)rays[i].org[0], (double)rays[i].org[1], (double)rays[i].org[2],
              (double)rays[i].dir[0], (double)rays[i].dir[1], (double)rays[i].dir[2]);
    }
}

/* From behind `at`, at a distance of the mesh's width, to the point inside. */
static plt_ray from_outside(const mesh *m, const float inside[3], const float at[3]) {
    float lo[3], hi[3], org[3], wide = 0.0f, distance = 0.0f;
    shape_box(m, lo, hi);
    for (int a = 0; a < 3; a++) {
        wide += hi[a] - lo[a];
        distance = fmaxf(distance, fabsf(at[a] - inside[a]));
    }
    for (int a = 0; a < 3; a++) {
        org[a] = at[a] + (at[a] - inside[a]) * (wide / distance);
    }
    plt_ray ray = ray_between(org, inside);
    ray.tmax = 1.0f;
    return ray;
}

/* Target i: corner i % 3 of a triangle, or the middle of the edge that starts there. */
static void target(const mesh *m, uint32_t i, float at[3]) {
    const float *p = shape_corner(m, i / 6, i % 3), *q = shape_corner(m, i / 6, (i + 1) % 3);
    for (int a = 0; a < 3; a++) {
        at[a] = i % 6 < 3 ? p[a] : p[a] + 0.5f * (q[a] - p[a]);
    }
}

static void bombard(const closed *c, const compact_config *config) {
    mesh moved = compact_mesh(&c->m, config->pack.lattice_bits);
    plt_ray rays[BATCH];
    rig r;
    CHECK(compact_open(&r, &c->m, config) == PLT_OK, "%s: %s", c->name, r.fault.message);
    for (uint32_t from = 0; from < INSIDE && r.engine != NULL; from++) {
        uint32_t made = 0;
        for (uint32_t i = 0; i < 6 * moved.triangles; i++) {
            float at[3];
            target(&moved, i, at);
            rays[made++] = ray_between(c->inside[from], at);
            rays[made++] = from_outside(&moved, c->inside[from], at);
            if (made == BATCH || i + 1 == 6 * moved.triangles) {
                shoot(&r, c->name, rays, made);
                made = 0;
            }
        }
    }
    rig_close(&r);
    mesh_free(&moved);
}

static void every_config(closed *c, const uint8_t bits[3]) {
    for (int i = 0; i < 3; i++) {
        compact_config config =
            compact_config_of(1u << i, bits[i], (uint8_t)(i & 1), (uint8_t)(i == 2));
        config.run.packet_side = i == 1 ? 2 : config.run.packet_side;
        stays_closed(c, bits[i]);
        bombard(c, &config);
    }
    mesh_free(&c->m);
}

int main(void) {
    static const uint8_t coarse[3] = {12, 13, 16}, fine[3] = {17, 20, 21};
    const uint32_t triangles = rig_triangles(800, 1);
    closed c = sphere();
    test("no ray escapes from an icosphere through a vertex or an edge");
    every_config(&c, coarse);
    c = sphere();
    move(&c, 1e-6f, 0.0f, 0.0f, 0.0f);
    every_config(&c, fine);
    test("no ray escapes from a knot through a vertex or an edge");
    c = knot(triangles);
    every_config(&c, coarse);
    c = knot(triangles);
    move(&c, 1e6f, 1e5f, -1e6f, 2e6f);
    every_config(&c, fine);
    test("... nor where the floats of the lattice are rounded, far from the origin");
    c = sphere();
    move(&c, 1.0f, 100.0f, -200.0f, 77.0f);
    every_config(&c, coarse);
    c = knot(triangles);
    move(&c, 3.0f, -1000.0f, 500.0f, 1.0f);
    every_config(&c, coarse);
    printf("    %llu rays, %llu escaped\n", (unsigned long long)traced,
           (unsigned long long)escaped);
    return test_done();
}
