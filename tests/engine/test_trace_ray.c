/* test_trace_ray - one ray against one triangle gives what four rays against it give
 *
 * Two triangles after each other for every ray, so that hits are compared with hits: t, u, v,
 * normal and id are the same bits. Rays of a group start at one point and know nothing of each
 * other; triangles are made around one of them.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "engine/planelet.h"
#include "engine/trace/triangle.h"
#include "engine/trace/triangle_ray.h"
#include "tests/reference/random.h"
#include "tests/test.h"

enum { GROUPS_PER_KIND = 24000 };

typedef struct four {
    plt_group_slabs slabs;
    plt_group_rays rays;
    plt_packet packet;
    plt_box scene;
    float org[3], dir[4][3];
} four;

/* What one ray has found. */
typedef struct found {
    float t, u, v, normal[3];
    uint32_t id;
} found;

static float size_of(random_state *r) {
    return ldexpf(random_float(r, 1.0f, 2.0f), -(int)random_below(r, 24));
}

static void make_rays(four *f, random_state *r, float scale) {
    const float spread = random_below(r, 3) ? size_of(r) : 0.0f;
    const float length = ldexpf(1.0f, (int)random_below(r, 41) - 20);
    for (int a = 0; a < 3; a++) {
        f->org[a] = scale * random_float(r, -2.0f, 2.0f);
        f->scene.lo[a] = -scale;
        f->scene.hi[a] = scale;
        f->dir[0][a] = length * random_float(r, -1.0f, 1.0f);
    }
    for (unsigned zero = random_below(r, 8) == 0 ? 1 + random_below(r, 2) : 0; zero-- > 0;) {
        const float little = random_below(r, 2) ? 0.0f : length * 0x1p-65f; /* along an axis */
        f->dir[0][random_below(r, 3)] = random_below(r, 2) ? little : -little;
    }
    for (int i = 1; i < 4; i++) {
        for (int a = 0; a < 3; a++) {
            f->dir[i][a] = f->dir[0][a] + length * spread * random_float(r, -1.0f, 1.0f);
        }
    }
}

/* Where there are hulls hits have normals, or u and v. */
static void set_group(four *f, int normals) {
    f4 o[3], d[3];
    for (int a = 0; a < 3; a++) {
        const float lanes[4] = {f->dir[0][a], f->dir[1][a], f->dir[2][a], f->dir[3][a]};
        o[a] = f4_all(f->org[a]);
        d[a] = f4_load(lanes);
    }
    memset(&f->rays, 0, sizeof f->rays);
    memset(&f->packet, 0, sizeof f->packet);
    f->packet.slabs.group = &f->slabs;
    f->packet.rays = &f->rays;
    plt_packet_begin(&f->packet, &f->scene, 1, 0);
    if (normals) {
        plt_packet_want_normals(&f->packet);
    }
    plt_packet_set_group(&f->packet, 0, o, d, f4_zero(), f4_all(3.0e38f), 4);
    plt_packet_finish(&f->packet);
}

/* ---- triangles -------------------------------------------------------------------- */

enum kind { ANY, SLIVER, GRAZING, EDGE_ON, AIMED, TIE, KINDS };

/* At a distance along the first ray that is inside the scene as a rule. */
static void point_on_ray(const four *f, random_state *r, float scale, float to[3]) {
    float most = 0.0f;
    for (int a = 0; a < 3; a++) {
        most = fmaxf(most, fabsf(f->dir[0][a]));
    }
    const float t = most > 0.0f ? scale * random_float(r, -0.5f, 3.0f) / most : 0.0f;
    for (int a = 0; a < 3; a++) {
        to[a] = f->org[a] + t * f->dir[0][a];
    }
}

static void offset(random_state *r, float size, float to[3]) {
    for (int a = 0; a < 3; a++) {
        to[a] = size * random_float(r, -1.0f, 1.0f);
    }
}

/* A triangle near the first ray, whose edges run along `along` but for `across`. */
static void near_ray(random_state *r, const float at[3], const float along[3], float length,
                     float across, float c[3][3]) {
    const float from = random_float(r, -1.0f, 0.0f), mid = random_float(r, -1.0f, 1.0f);
    for (int i = 0; i < 3; i++) {
        const float k = i == 0 ? from : (i == 1 ? 1.0f : mid);
        float beside[3];
        offset(r, across, beside);
        for (int a = 0; a < 3; a++) {
            c[i][a] = at[a] + k * length * along[a] + beside[a];
        }
    }
}

static void make_triangle(const four *f, random_state *r, enum kind kind, float scale,
                          float c[3][3]) {
    const float size = scale * size_of(r);
    float at[3], along[3];
    point_on_ray(f, r, scale, at);
    offset(r, 1.0f, along);
    switch (kind) {
    case SLIVER:
        near_ray(r, at, along, size, size * size_of(r), c);
        break;
    case GRAZING: /* along the ray, but for very little */
    case EDGE_ON: {
        float most = 1e-30f;
        for (int a = 0; a < 3; a++) {
            most = fmaxf(most, fabsf(f->dir[0][a]));
        }
        for (int a = 0; a < 3; a++) {
            along[a] = f->dir[0][a] / most;
        }
        near_ray(r, at, along, size, kind == GRAZING ? size * size_of(r) : 0.0f, c);
        if (kind == EDGE_ON) {
            c[1][random_below(r, 3)] += size * random_float(r, -1.0f, 1.0f);
        }
        break;
    }
    default:
        for (int i = 0; i < 3; i++) {
            offset(r, size, c[i]);
            for (int a = 0; a < 3; a++) {
                c[i][a] += at[a];
            }
        }
        if (kind == AIMED) { /* a corner on the ray */
            memcpy(c[random_below(r, 3)], at, sizeof at);
        }
        break;
    }
}

/* ---- the comparison ------------------------------------------------------------------- */

static uint32_t hits;

static void with_four(four *f, const float c[3][3], uint32_t word) {
    plt_triangle t = {.word = word};
    memcpy(t.corner, c, sizeof t.corner);
    for (int a = 0; a < 3; a++) {
        const float lo = fminf(fminf(c[0][a], c[1][a]), c[2][a]);
        t.longest = fmaxf(t.longest, fmaxf(fmaxf(c[0][a], c[1][a]), c[2][a]) - lo);
    }
    plt_triangle_groups(&f->packet, &t, 1);
}

static void with_one(const plt_ray_origin *o, const float dir[3], const float c[3][3],
                     uint32_t word, found *best) {
    plt_ray_hit hit;
    const uint32_t id = plt_primitive_id(word);
    if (plt_triangle_ray(o, dir, c, best->t, id < best->id, &hit)) {
        float normal[3];
        plt_hit_normal(c, normal);
        CHECK(memcmp(normal, hit.normal, sizeof normal) == 0, "the normal of the triangle");
        best->t = hit.t;
        best->id = id;
        memcpy(best->normal, hit.normal, sizeof best->normal);
        plt_ray_hit_weights(&hit, plt_primitive_rotation(word), &best->u, &best->v);
        hits++;
    }
}

/* What a lane has: u and v, or the normal; t and id both times. */
static void take(const four *f, unsigned lane, int normals, found *g) {
    const found none = {.t = 3.0e38f, .id = PLT_MISS}, before = normals ? *g : none;
    *g = before;
    if (!(f->rays.valid >> lane & 1u)) {
        return;
    }
    g->t = f->slabs.tmax[lane];
    g->id = f->rays.id[lane];
    CHECK(!normals || (g->t == before.t && g->id == before.id), "the same hits with normals");
    for (int a = 0; normals && g->id != PLT_MISS && a < 3; a++) {
        g->normal[a] = f->rays.normal[a][lane];
    }
    if (!normals && g->id != PLT_MISS) {
        g->u = f->rays.u[lane];
        g->v = f->rays.v[lane];
    }
}

static void compare(const found *g, const found *one, enum kind kind) {
    CHECK(memcmp(g, one, sizeof *g) == 0, "kind %d: %a %a %a of %u, and in a group %a %a %a of %u",
          kind, (double)one->t, (double)one->u, (double)one->v, one->id, (double)g->t, (double)g->u,
          (double)g->v, g->id);
}

static void one_group(random_state *r, enum kind kind, float scale) {
    four f;
    float c[2][3][3];
    plt_ray_origin o;
    make_rays(&f, r, scale);
    plt_ray_origin_set(&o, &f.scene, f.org);
    make_triangle(&f, r, kind, scale, c[0]);
    make_triangle(&f, r, kind, scale, c[1]);
    if (kind == TIE) { /* the same one again, turned round, or its neighbour in the plane */
        memcpy(c[1], c[0], sizeof c[0]);
        const unsigned moved = random_below(r, 3);
        for (int a = 0; a < 3; a++) {
            c[1][moved][a] = random_below(r, 2) ? c[0][moved][a]
                                                : c[0][(moved + 1) % 3][a] * 2.0f - c[0][moved][a];
        }
    }
    const uint32_t first = random_below(r, 2);
    const uint32_t word[2] = {first | random_below(r, 3) << 29, (1 - first) | random_below(r, 3)
                                                                                  << 29};
    found four_found[4];
    for (int normals = 0; normals < 2; normals++) {
        set_group(&f, normals);
        with_four(&f, c[0], word[0]);
        with_four(&f, c[1], word[1]);
        for (unsigned lane = 0; lane < 4; lane++) {
            take(&f, lane, normals, &four_found[lane]);
        }
    }
    for (unsigned lane = 0; lane < 4; lane++) {
        found one = {.t = 3.0e38f, .id = PLT_MISS};
        for (int i = 0; i < 2; i++) {
            with_one(&o, f.dir[lane], c[i], word[i], &one);
        }
        compare(&four_found[lane], &one, kind);
    }
}

static void all_of(float scale, uint32_t groups) {
    random_state r = {(uint64_t)(1000.0f * fabsf(log2f(scale)))};
    hits = 0;
    for (int kind = 0; kind < KINDS; kind++) {
        for (uint32_t i = 0; i < groups; i++) {
            one_group(&r, (enum kind)kind, scale);
        }
    }
    CHECK(hits > groups, "%u hits", hits);
}

int main(void) {
    test("one ray against a triangle: the bits of four rays against it");
    all_of(1.0f, GROUPS_PER_KIND);
    test("the same in scenes of 2^-60, where normals underflow");
    all_of(0x1p-60f, GROUPS_PER_KIND / 4);
    test("the same in scenes of 2^-100");
    all_of(0x1p-100f, GROUPS_PER_KIND / 4);
    test("the same in scenes of 2^38");
    all_of(0x1p38f, GROUPS_PER_KIND / 4);
    return test_done();
}
