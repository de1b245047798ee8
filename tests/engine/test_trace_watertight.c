/* test_trace_watertight - no ray passes through a closed mesh
 *
 * Rays go to every vertex, every edge's middle and random points of edges and faces, from
 * points inside (they must hit something) and from outside to such a point (they must hit
 * something before it), at several scales and offsets. PLANELET_SOAK=1 traces twenty times as
 * many.
 *
 * Source of the property: Woop, Benthin, Wald, "Watertight ray/triangle intersection", 2013.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/scenes/scenes.h"
#include "tests/reference/rays.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

#if defined(__SANITIZE_ADDRESS__)
#define RAYS_A_PLACE 30000u
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define RAYS_A_PLACE 30000u
#endif
#endif
#ifndef RAYS_A_PLACE
#define RAYS_A_PLACE 140000u
#endif

#define BATCH 256u
#define INSIDE 16

typedef struct closed {
    const char *name;
    mesh m;
    float inside[INSIDE][3];
    int points;
} closed;

typedef struct transform {
    float scale, offset[3];
} transform;

static const transform transforms[] = {
    {1.0f, {0.0f, 0.0f, 0.0f}},         {1e-6f, {0.0f, 0.0f, 0.0f}},
    {1e6f, {0.0f, 0.0f, 0.0f}},         {1.0f, {100.0f, -33.0f, 7.0f}},
    {1e-6f, {1e-4f, 2e-4f, -3e-4f}},    {1e6f, {-7e7f, 3e7f, 1e6f}},
    {1.0f, {-1000.0f, 777.0f, 555.5f}}, {3e-7f, {1e-7f, 0.0f, 0.0f}},
};

static uint64_t rays_aimed, escaped;

/* ---- are the meshes closed? ----------------------------------------- */

static uint32_t count_edge(const mesh *m, uint32_t a, uint32_t b) {
    uint32_t count = 0;
    for (size_t i = 0; i < m->triangles; i++) {
        const uint32_t *t = m->triangle + 3 * i;
        for (int k = 0; k < 3; k++) {
            count += t[k] == a && t[(k + 1) % 3] == b;
        }
    }
    return count;
}

static void check_closed(const closed *c) {
    for (size_t i = 0; i < c->m.triangles; i++) {
        const uint32_t *t = c->m.triangle + 3 * i;
        for (int k = 0; k < 3; k++) {
            CHECK(count_edge(&c->m, t[k], t[(k + 1) % 3]) == 1 &&
                      count_edge(&c->m, t[(k + 1) % 3], t[k]) == 1,
                  "%s: triangle %zu, edge %d", c->name, i, k);
        }
    }
}

/* ---- the meshes -------------------------------------------------------------- */

static void add_inside(closed *c, float x, float y, float z) {
    const float p[3] = {x, y, z};
    memcpy(c->inside[c->points++], p, sizeof p);
}

static closed round_mesh(int cube, unsigned levels) {
    closed c = {.name = cube ? "cube" : "icosphere"};
    if (cube) {
        shape_cube(&c.m);
    } else {
        shape_icosphere(&c.m, levels);
    }
    add_inside(&c, 0.0f, 0.0f, 0.0f); /* rays run exactly through vertices */
    add_inside(&c, 0.125f, -0.25f, 0.0f);
    add_inside(&c, -0.3f, 0.2f, 0.1f);
    add_inside(&c, 0.45f, 0.45f, 0.45f);
    return c;
}

static closed needles(void) {
    closed c = {.name = "needles"};
    shape_needles(&c.m, 17);
    add_inside(&c, 0.0f, 0.0f, 0.0f);
    add_inside(&c, 0.0f, 0.5f, 0.0f);
    add_inside(&c, 0.0001f, -0.25f, 0.0002f);
    add_inside(&c, 0.0f, 0.9f, 0.00001f);
    return c;
}

/* The middles of rings: the tube is convex in each of its cross sections. */
static closed knot(uint32_t triangles) {
    closed c = {.name = "knot"};
    fail f = {""};
    scene_knot(&c.m, triangles, &f);
    uint32_t sides = 3;
    while ((sides + 1) * (sides + 1) <= triangles / 20) {
        sides++;
    }
    const uint32_t rings = (uint32_t)c.m.vertices / sides;
    for (uint32_t i = 0; i < INSIDE; i++) {
        float sum[3] = {0.0f, 0.0f, 0.0f};
        for (uint32_t k = 0; k < 3 * sides; k++) {
            sum[k % 3] += c.m.vertex[3 * sides * (i * rings / INSIDE) + k];
        }
        add_inside(&c, sum[0] / (float)sides, sum[1] / (float)sides, sum[2] / (float)sides);
    }
    return c;
}

static closed transformed(const closed *from, const transform *to) {
    closed c = *from;
    c.m = (mesh){0};
    fail f = {""};
    mesh_reserve(&c.m, from->m.vertices, from->m.triangles, &f);
    c.m.vertices = from->m.vertices;
    c.m.triangles = from->m.triangles;
    memcpy(c.m.vertex, from->m.vertex, 12 * c.m.vertices);
    memcpy(c.m.triangle, from->m.triangle, 12 * c.m.triangles);
    shape_transform(&c.m, to->scale, to->offset[0], to->offset[1], to->offset[2]);
    for (int i = 0; i < c.points; i++) {
        for (int a = 0; a < 3; a++) {
            c.inside[i][a] = from->inside[i][a] * to->scale + to->offset[a];
        }
    }
    return c;
}

/* ---- rays -------------------------------------------------------------------- */

/* A vertex, an edge's middle, a point of an edge, or of the face. */
static void pick_target(const mesh *m, uint32_t i, random_state *r, float at[3]) {
    const uint32_t triangle = i / 3 % (uint32_t)m->triangles;
    const float *p = shape_corner(m, triangle, i % 3), *q = shape_corner(m, triangle, (i + 1) % 3),
                *s = shape_corner(m, triangle, (i + 2) % 3);
    const uint32_t kind = i / 3 / (uint32_t)m->triangles % 4;
    const float share = kind == 0 ? 0.0f : (kind == 1 ? 0.5f : random_float(r, 0.0f, 1.0f));
    const float inner = kind == 3 ? random_float(r, 0.0f, 0.5f) : 0.0f;
    for (int a = 0; a < 3; a++) {
        at[a] = p[a] + share * (q[a] - p[a]);
        at[a] += inner * (s[a] - at[a]);
    }
}

static plt_ray from_inside(const float inside[3], const float at[3]) {
    return ray_between(inside, at);
}

/* From outside the mesh's box, `away` times its size behind `at`, to the point
 * inside, which has t = 1. */
static plt_ray from_outside(const float box[6], const float inside[3], const float at[3],
                            float away) {
    float org[3], size = 0.0f, most = 0.0f;
    for (int a = 0; a < 3; a++) {
        size += box[3 + a] - box[a];
        most = fmaxf(most, fabsf(at[a] - inside[a]));
    }
    const float factor = most > 0.0f ? away * size / most : 0.0f;
    for (int a = 0; a < 3; a++) {
        org[a] = at[a] + factor * (at[a] - inside[a]);
    }
    plt_ray ray = ray_between(org, inside);
    ray.tmax = 1.0f;
    return ray;
}

static int has_direction(const plt_ray *ray) {
    return ray->dir[0] != 0.0f || ray->dir[1] != 0.0f || ray->dir[2] != 0.0f;
}

static void shoot(plt_engine *e, const char *name, const plt_ray *rays, uint32_t count) {
    plt_hit hits[BATCH];
    plt_trace(e, rays, hits, count, 0);
    for (uint32_t i = 0; i < count; i++) {
        rays_aimed++;
        escaped += hits[i].triangle == PLT_MISS;
        CHECK(hits[i].triangle != PLT_MISS, "%s: from %a %a %a along %a %a %a", name,
              (double)rays[i].org[0], (double)rays[i].org[1], (double)rays[i].org[2],
              (double)rays[i].dir[0], (double)rays[i].dir[1], (double)rays[i].dir[2]);
    }
}

static void bombard(const closed *c, plt_engine *e, uint32_t count, int outside, uint64_t seed) {
    random_state r = {seed};
    plt_ray rays[BATCH];
    uint32_t made = 0;
    float corners[6];
    shape_box(&c->m, corners, corners + 3);
    for (uint32_t i = 0; i < count; i++) {
        float at[3];
        const float *inside = c->inside[(i / 64) % (uint32_t)c->points];
        pick_target(&c->m, i, &r, at);
        rays[made] = outside ? from_outside(corners, inside, at, random_float(&r, 1.0f, 8.0f))
                             : from_inside(inside, at);
        made += (uint32_t)has_direction(&rays[made]);
        if (made == BATCH) {
            shoot(e, c->name, rays, made);
            made = 0;
        }
    }
    shoot(e, c->name, rays, made);
}

static void bombard_transformed(const closed *base, int outside, uint32_t count) {
    for (size_t p = 0; p < sizeof transforms / sizeof transforms[0]; p++) {
        closed c = transformed(base, &transforms[p]);
        /* A needle's radius must not vanish in the offset's rounding. */
        const int drowned = strcmp(base->name, "needles") == 0 && transforms[p].offset[0] != 0.0f;
        rig one;
        rig_config config = rig_config_of(1 + p % 2, 3, PLT_BUILD_HOST, p % 3 == 0);
        config.run.order = p % 2 == 0 ? PLT_ORDER_DEPTH_FIRST : PLT_ORDER_TWO_STAGE;
        if (drowned) {
            mesh_free(&c.m);
            continue;
        }
        CHECK(rig_open(&one, &c.m, &config) == PLT_OK, "%s", one.fault.message);
        if (one.engine != NULL) {
            bombard(&c, one.engine, count, outside, p + 1);
        }
        rig_close(&one);
        mesh_free(&c.m);
    }
}

int main(void) {
    const char *soak = getenv("PLANELET_SOAK");
    const uint32_t count = RAYS_A_PLACE * (soak != NULL && soak[0] == '1' ? 20u : 1u);
    closed c[5] = {round_mesh(1, 0), round_mesh(0, 1), round_mesh(0, rig_is_tiny() ? 0 : 3),
                   knot(rig_triangles(2000, 1)), needles()};
    c[2].name = "fine icosphere";
    test("the meshes are closed: each edge has one triangle on either side");
    for (int i = 0; i < 5; i++) {
        check_closed(&c[i]);
    }
    test("from inside no ray escapes through an edge, a vertex or a face");
    for (int i = 0; i < 5; i++) {
        bombard_transformed(&c[i], 0, count);
    }
    test("from outside no ray reaches a point inside without a hit");
    for (int i = 0; i < 5; i++) {
        bombard_transformed(&c[i], 1, count);
    }
    printf("    %llu rays, %llu escaped\n", (unsigned long long)rays_aimed,
           (unsigned long long)escaped);
    for (int i = 0; i < 5; i++) {
        mesh_free(&c[i].m);
    }
    return test_done();
}
