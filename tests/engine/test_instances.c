/* test_instances - bodies that matrices place: hits of every frame, packet and order
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "engine/engine.h"
#include "tests/reference/instances_rig.h"
#include "tests/reference/rays.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { RAYS = 600 };

static plt_ray rays[RAYS];
static plt_hit hits[RAYS], due[RAYS];

static uint32_t treelet(uint32_t nodes) {
    return rig_is_tiny() ? 1 : nodes;
}

static instances_config config_of(uint32_t k, uint32_t nodes, uint32_t instances,
                                  enum instances_kind kind) {
    const instances_config c = {rig_config_of(k, treelet(nodes), PLT_BUILD_HOST, PLT_SPLIT_SAH),
                                instances,
                                kind,
                                4.0f,
                                1,
                                instances + 100 * kind};
    return c;
}

typedef const float (*matrices)[PLT_MATRIX_FLOATS];

static matrices frame_of(const instances_rig *r, uint32_t frame) {
    return (matrices)r->matrix[frame];
}

/* Rays that look at the whole frame; one in eight from very far away. */
static void make_rays(const instances_rig *s, uint32_t frame, random_state *r) {
    mesh flat = {0};
    instances_rig_flatten(s, frame_of(s, frame), &flat);
    rays_mixed(rays, RAYS, &flat, r);
    for (uint32_t i = 0; i < RAYS; i += 8) {
        for (int a = 0; a < 3; a++) {
            rays[i].org[a] -= 3.0e4f * rays[i].dir[a];
        }
        rays[i].tmax = RAYS_FAR;
    }
    mesh_free(&flat);
}

/* What the engine hits is what each body alone has, bit for bit. Returns how many hit. */
static uint32_t compare(const instances_rig *s, matrices m, int any, const char *what) {
    uint32_t count = 0;
    memset(hits, 0x77, sizeof hits);
    CHECK(plt_trace(s->engine, rays, hits, RAYS, any) == PLT_OK, "%s", what);
    for (uint32_t i = 0; i < RAYS; i++) {
        due[i] = instances_rig_hit(s, m, &rays[i], any);
        count += due[i].triangle != (any ? 0 : PLT_MISS);
        CHECK(memcmp(&hits[i], &due[i], sizeof due[i]) == 0,
              "%s: ray %u: triangle %u at %a (%a %a), due %u at %a (%a %a)", what, i,
              hits[i].triangle, (double)hits[i].t, (double)hits[i].u, (double)hits[i].v,
              due[i].triangle, (double)due[i].t, (double)due[i].u, (double)due[i].v);
    }
    return count;
}

static void every_packet_and_order(const instances_config *config) {
    for (unsigned side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        for (uint8_t order = 0; order <= PLT_ORDER_TWO_STAGE; order++) {
            instances_config c = *config;
            instances_rig s;
            random_state r = {side + order};
            c.scene.run.packet_side = (uint8_t)side;
            c.scene.run.order = order;
            if (instances_rig_start(&s, &c) == PLT_OK) {
                make_rays(&s, 0, &r);
                const uint32_t hit = compare(&s, frame_of(&s, 0), 0, rig_name(&c.scene));
                CHECK(hit > RAYS / 20 && hit < RAYS, "%u of %d rays hit", hit, (int)RAYS);
                compare(&s, frame_of(&s, 0), 1, rig_name(&c.scene));
            }
            CHECK(instances_rig_close(&s), "arena");
        }
    }
}

static void hits_of_bodies(void) {
    static const uint32_t counts[] = {1, 2, 3, 9, 40};
    for (unsigned i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        for (int kind = INSTANCES_RIGID; kind <= INSTANCES_SKEWED; kind++) {
            const instances_config c =
                config_of(1u << i % 3, i % 2 ? 16 : 5, counts[i], (enum instances_kind)kind);
            every_packet_and_order(&c);
        }
    }
}

/* ---- frames ----------------------------------------------------------------------- */

static void frames(int is_mapped) {
    instances_config c = config_of(2, 8, 12, INSTANCES_SCALED);
    instances_rig s;
    random_state r = {3};
    c.is_mapped = is_mapped;
    if (instances_rig_start(&s, &c) == PLT_OK) {
        const size_t used = plt_arena_used(s.engine), peak = plt_arena_peak(s.engine);
        CHECK(used <= s.arena_bytes && peak == s.arena_bytes, "%zu, %zu of %zu", used, peak,
              s.arena_bytes);
        for (uint32_t i = 0; i < 12; i++) {
            const uint32_t k = random_below(&r, INSTANCES_RIG_FRAMES);
            CHECK(plt_sequence_show(s.engine, k, &s.fault) == PLT_OK, "%s", s.fault.message);
            make_rays(&s, k, &r);
            compare(&s, frame_of(&s, k), 0, "frame");
            CHECK(plt_arena_used(s.engine) == used && plt_arena_peak(s.engine) == peak,
                  "the arena has changed");
        }
        CHECK(plt_sequence_show(s.engine, INSTANCES_RIG_FRAMES, &s.fault) == PLT_ERR_ARGUMENT &&
                  plt_sequence_failed(s.engine) == INSTANCES_RIG_FRAMES,
              "%s", s.fault.message);
    }
    CHECK(instances_rig_close(&s), "arena or source: %s", s.link.sentence);
}

/* Read block by block while another one is shown, and given up on the way. */
static void steps(void) {
    instances_config c = config_of(2, 8, INSTANCES_RIG_MOST, INSTANCES_RIGID);
    instances_rig s;
    random_state r = {4};
    c.is_mapped = 0;
    if (instances_rig_start(&s, &c) == PLT_OK) {
        CHECK(plt_sequence_begin(s.engine, 3, &s.fault) == PLT_OK, "%s", s.fault.message);
        make_rays(&s, 0, &r);
        compare(&s, frame_of(&s, 0), 0, "begun");
        while (plt_sequence_step(s.engine, 1, &s.fault) == PLT_MORE) {
            compare(&s, frame_of(&s, 0), 0, "on its way");
        }
        compare(&s, frame_of(&s, 0), 0, "there");
        CHECK(plt_sequence_show(s.engine, 3, &s.fault) == PLT_OK, "%s", s.fault.message);
        make_rays(&s, 3, &r);
        compare(&s, frame_of(&s, 3), 0, "shown");
        CHECK(plt_sequence_begin(s.engine, 2, &s.fault) == PLT_OK &&
                  plt_sequence_begin(s.engine, 1, &s.fault) == PLT_OK &&
                  plt_sequence_show(s.engine, 4, &s.fault) == PLT_OK,
              "%s", s.fault.message);
        make_rays(&s, 4, &r);
        compare(&s, frame_of(&s, 4), 0, "another one");
    }
    CHECK(instances_rig_close(&s), "arena or source: %s", s.link.sentence);
}

static void exact_need(void) {
    for (int is_mapped = 0; is_mapped < 2; is_mapped++) {
        instances_config c = config_of(2, 8, 9, INSTANCES_RIGID);
        instances_rig s;
        c.is_mapped = is_mapped;
        instances_rig_pack(&s, &c);
        CHECK(instances_rig_open(&s, &c, PLT_ALIGN) == PLT_ERR_ARENA &&
                  s.fault.need_bytes == s.arena_bytes + PLT_ALIGN,
              "%zu, need %zu", s.arena_bytes, s.fault.need_bytes);
        CHECK(instances_rig_open(&s, &c, 0) == PLT_OK, "%s", s.fault.message);
        CHECK(instances_rig_close(&s), "arena");
    }
}

/* ---- placing ---------------------------------------------------------------------- */

static void place(void) {
    const instances_config c = config_of(2, 8, 9, INSTANCES_SKEWED);
    instances_rig s;
    random_state r = {5};
    if (instances_rig_start(&s, &c) == PLT_OK) {
        for (uint32_t k = 1; k < INSTANCES_RIG_FRAMES; k++) {
            CHECK(plt_place(s.engine, frame_of(&s, k), &s.fault) == PLT_OK, "%s", s.fault.message);
            make_rays(&s, k, &r);
            compare(&s, frame_of(&s, k), 0, "placed");
        }
    }
    CHECK(instances_rig_close(&s), "arena");
}

/* Nothing has changed, and the instance is named. */
static void refused(void) {
    static const struct {
        unsigned at;
        float value;
    } bad[] = {{0, NAN},    {3, INFINITY},   {7, -1.2e12f},
               {5, 2.0e6f}, {11, -INFINITY}, {11, 1.0995e12f}};
    const instances_config c = config_of(2, 8, 9, INSTANCES_RIGID);
    instances_rig s;
    random_state r = {6};
    if (instances_rig_start(&s, &c) == PLT_OK) {
        make_rays(&s, 0, &r);
        for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
            float m[INSTANCES_RIG_MOST][PLT_MATRIX_FLOATS];
            memcpy(m, s.matrix[1], sizeof m);
            m[i + 1][bad[i].at] = bad[i].value;
            CHECK(plt_place(s.engine, (matrices)m, &s.fault) == PLT_ERR_ARGUMENT &&
                      s.fault.offset == i + 1,
                  "%u: %u, %s", i, s.fault.offset, s.fault.message);
        }
        for (unsigned rank = 0; rank < 3; rank++) { /* flat: no row, one, two of them */
            float m[INSTANCES_RIG_MOST][PLT_MATRIX_FLOATS];
            memcpy(m, s.matrix[1], sizeof m);
            memset(m[3] + 4 * rank, 0, (3 - rank) * 4 * sizeof(float));
            CHECK(plt_place(s.engine, (matrices)m, &s.fault) == PLT_ERR_ARGUMENT &&
                      s.fault.offset == 3,
                  "rank %u: %s", rank, s.fault.message);
        }
        CHECK(plt_sequence_begin(s.engine, 2, &s.fault) == PLT_OK &&
                  plt_place(s.engine, NULL, &s.fault) == PLT_ERR_ARGUMENT,
              "no matrices: %s", s.fault.message);
        compare(&s, frame_of(&s, 0), 0, "as before");
    }
    CHECK(instances_rig_close(&s), "arena");
}

static void others_have_none(void) {
    mesh m = {0};
    rig s;
    const rig_config c = rig_config_of(2, treelet(8), PLT_BUILD_HOST, PLT_SPLIT_SAH);
    const float identity[1][12] = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
    plt_instance to;
    shape_cube(&m);
    CHECK(rig_open(&s, &m, &c) == PLT_OK, "%s", s.fault.message);
    CHECK(plt_place(s.engine, identity, &s.fault) == PLT_ERR_ARGUMENT, "%s", s.fault.message);
    CHECK(plt_instance_find(s.engine, 0, &to) == PLT_ERR_ARGUMENT, "of a scene without");
    rig_close(&s);
    mesh_free(&m);
}

static void names(void) {
    const instances_config c = config_of(2, 8, 17, INSTANCES_RIGID);
    instances_rig s;
    if (instances_rig_start(&s, &c) == PLT_OK) {
        uint32_t id = 0;
        plt_instance to;
        for (uint32_t i = 0; i < c.instances; i++) {
            const uint32_t count = (uint32_t)s.body[s.body_of[i]].triangles;
            for (uint32_t k = 0; k < count; k++, id++) {
                CHECK(plt_instance_find(s.engine, id, &to) == PLT_OK && to.instance == i &&
                          to.body == s.body_of[i] && to.triangle == k,
                      "%u is %u of %u", id, to.triangle, to.instance);
            }
        }
        CHECK(id == plt_engine_info(s.engine)->placed_triangles &&
                  plt_instance_find(s.engine, id, &to) == PLT_ERR_ARGUMENT,
              "%u triangles", id);
    }
    CHECK(instances_rig_close(&s), "arena");
}

/* ---- where rounding is largest ------------------------------------------------------ */

/* Turned, made flat, and turned again. */
static void flat_matrix(float m[PLT_MATRIX_FLOATS], random_state *r) {
    float a[PLT_MATRIX_FLOATS], b[PLT_MATRIX_FLOATS];
    instances_rig_matrix(a, INSTANCES_RIGID, 1.0f, r);
    instances_rig_matrix(b, INSTANCES_RIGID, 1.0f, r);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            m[4 * i + j] =
                a[4 * i] * b[j] + a[4 * i + 1] * b[4 + j] + a[4 * i + 2] * b[8 + j] * 0.006f;
        }
        m[4 * i + 3] = a[4 * i + 3];
    }
}

/* Rays from far away that run along a face of the box in the world, by the vertex that it
 * touches, a little within or without. */
static void graze_boxes(const mesh *body, const float m[PLT_MATRIX_FLOATS], random_state *r) {
    for (uint32_t i = 0; i < RAYS; i++) {
        const int axis = (int)(i % 3);
        const float sign = i % 2 ? 1.0f : -1.0f, far = 1000.0f * (float)(1u << i % 11);
        float best = -1.0e30f, at[3] = {0, 0, 0};
        for (size_t v = 0; v < body->vertices; v++) {
            const float *p = body->vertex + 3 * v;
            float q[3];
            for (int a = 0; a < 3; a++) {
                q[a] = m[4 * a] * p[0] + m[4 * a + 1] * p[1] + m[4 * a + 2] * p[2] + m[4 * a + 3];
            }
            if (sign * q[axis] > best) {
                best = sign * q[axis];
                memcpy(at, q, sizeof at);
            }
        }
        const float within = random_float(r, -1.0e-5f, 1.0e-5f) * far; /* as far as rounding is */
        plt_ray *ray = &rays[i];
        for (int a = 0; a < 3; a++) {
            at[a] += within * (m[4 * a + 3] - at[a]);
            ray->dir[a] = a == axis ? 0.0f : random_float(r, -1.0f, 1.0f);
            ray->org[a] = at[a] - far * ray->dir[a];
        }
        ray->tmin = 0.0f;
        ray->tmax = RAYS_FAR;
    }
}

static void far_and_flat(void) {
    const instances_config c = config_of(2, 8, 1, INSTANCES_RIGID);
    instances_rig s;
    random_state r = {12};
    uint32_t hit = 0;
    if (instances_rig_start(&s, &c) == PLT_OK) {
        for (int i = 0; i < 30; i++) {
            float m[1][PLT_MATRIX_FLOATS];
            flat_matrix(m[0], &r);
            CHECK(plt_place(s.engine, (matrices)m, &s.fault) == PLT_OK, "%s", s.fault.message);
            graze_boxes(&s.body[s.body_of[0]], m[0], &r);
            hit += compare(&s, (matrices)m, 0, "flat");
        }
    }
    CHECK(hit > 500, "%u hits", hit);
    CHECK(instances_rig_close(&s), "arena");
}

/* ---- beside a scene that is packed flat ------------------------------------------- */

/* A vertex lies elsewhere by no more than these units in the last place of what is added up, and
 * so does the ray: t is off by that over the cosine. */
static double tolerance(const mesh *m, const plt_ray *ray, const plt_hit *hit, double skew) {
    double e[2][3], n[3], length = 0, dir = 0, along = 0, size = 0;
    for (int a = 0; a < 3; a++) {
        const double p = (double)shape_corner(m, hit->triangle, 0)[a];
        e[0][a] = (double)shape_corner(m, hit->triangle, 1)[a] - p;
        e[1][a] = (double)shape_corner(m, hit->triangle, 2)[a] - p;
        size = fmax(size, fmax(fabs(p), fabs((double)ray->org[a])));
    }
    for (int a = 0; a < 3; a++) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        n[a] = e[0][b] * e[1][c] - e[0][c] * e[1][b];
        length += n[a] * n[a];
        dir += (double)ray->dir[a] * (double)ray->dir[a];
        along += n[a] * (double)ray->dir[a];
    }
    const double cosine = fabs(along) / sqrt(length * dir);
    return 256.0 * skew * size * 5.97e-8 / (cosine * cosine * sqrt(dir));
}

static void beside_flat(enum instances_kind kind) {
    instances_config c = config_of(2, 16, 20, kind);
    instances_rig s;
    random_state r = {8};
    rig flat_rig;
    mesh flat = {0};
    uint32_t same = 0, hit = 0;
    if (instances_rig_start(&s, &c) == PLT_OK) {
        instances_rig_flatten(&s, frame_of(&s, 0), &flat);
        rig_config fc = c.scene;
        fc.pack.build = PLT_BUILD_NONE;
        CHECK(rig_open(&flat_rig, &flat, &fc) == PLT_OK, "%s", flat_rig.fault.message);
        rays_random(rays, RAYS, &flat, &r); /* not through vertices */
        plt_trace(s.engine, rays, hits, RAYS, 0);
        plt_trace(flat_rig.engine, rays, due, RAYS, 0);
        for (uint32_t i = 0; i < RAYS; i++) {
            hit += due[i].triangle != PLT_MISS;
            if (due[i].triangle == PLT_MISS || hits[i].triangle == PLT_MISS) {
                same += due[i].triangle == hits[i].triangle;
                continue;
            }
            const double most = tolerance(&flat, &rays[i], &due[i], 64);
            const int near = fabs((double)(hits[i].t - due[i].t)) <= most;
            CHECK(near || due[i].triangle != hits[i].triangle, "ray %u: %a, flat %a, %g", i,
                  (double)hits[i].t, (double)due[i].t, most);
            same += near; /* where two lie in one place, rounding says which */
        }
        CHECK(hit > RAYS / 20 && same >= RAYS - RAYS / 100, "%u hit, %u of %d alike", hit, same,
              (int)RAYS);
        rig_close(&flat_rig);
        mesh_free(&flat);
    }
    CHECK(instances_rig_close(&s), "arena");
}

int main(void) {
    test("hits are those of each body alone, as its instances see the rays, bit for bit");
    hits_of_bodies();
    test("... also along the boxes of instances that are all but flat, from very far away");
    far_and_flat();
    test("frames are shown in any order, mapped and fetched, and the arena stays as it is");
    frames(1);
    frames(0);
    test("a frame comes block by block while another one is shown");
    steps();
    test("the need of an arena is exact");
    exact_need();
    test("instances are where a caller places them, and a matrix that is refused changes nothing");
    place();
    refused();
    others_have_none();
    test("a hit's number names instance, body and triangle");
    names();
    test("a scene that is packed flat has the same hits, but for rounding");
    beside_flat(INSTANCES_RIGID);
    beside_flat(INSTANCES_SCALED);
    beside_flat(INSTANCES_SKEWED);
    return test_done();
}
