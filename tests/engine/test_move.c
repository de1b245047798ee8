/* test_move - triangles that move, and trees that are refitted, against scenes that are packed anew
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "board/fake/fake.h"
#include "engine/engine.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/frames.h"
#include "tests/reference/rays.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/reference/tree_check.h"
#include "tests/test.h"

enum { RAYS = 256, GUARD = 64 };

/* An engine whose triangles can be moved, in an arena of just its need. */
typedef struct mover {
    packed image;
    fake_link link; /* not mapped: the image comes through it */
    unsigned char *arena;
    size_t bytes;
    plt_engine *engine;
    plt_fault fault;
} mover;

/* Nodes of a treelet: with tiny limits of few stack entries one. */
static uint32_t treelet(uint32_t nodes) {
    return rig_is_tiny() ? 1 : nodes;
}

static int open_mover(mover *v, const mesh *m, const rig_config *config, int is_mapped) {
    fail f = {""};
    plt_options o = config->run;
    o.movable = 1;
    memset(v, 0, sizeof *v);
    CHECK(pack_mesh(&v->image, m, &config->pack, "test", &f) == 0, "%s", f.text);
    v->link.image = v->image.bytes;
    v->link.bytes = v->image.size;
    const plt_source source = is_mapped ? rig_source(&v->image) : fake_source(&v->link);
    v->bytes = plt_arena_need(&v->image.info, is_mapped, &o);
    v->arena = aligned_alloc(PLT_ALIGN, v->bytes + GUARD);
    memset(v->arena, 0x5A, v->bytes + GUARD);
    v->link.arena = v->arena;
    v->link.arena_bytes = v->bytes;
    const int status = plt_open(&v->engine, v->arena, v->bytes, &source, &o, &v->fault);
    CHECK(status == PLT_OK, "%s: %s", rig_name(config), v->fault.message);
    return status;
}

static void close_mover(mover *v) {
    for (unsigned i = 0; i < GUARD; i++) {
        CHECK(v->arena[v->bytes + i] == 0x5A, "written behind the arena");
    }
    free(v->arena);
    pack_free(&v->image);
}

static float (*corners_of(const mesh *m))[9] {
    float(*corners)[9] = malloc((m->triangles + 1) * sizeof *corners);
    for (uint32_t i = 0; i < m->triangles; i++) {
        for (unsigned c = 0; c < 3; c++) {
            memcpy(&corners[i][3 * c], shape_corner(m, i, c), 3 * sizeof(float));
        }
    }
    return corners;
}

static int move_to(mover *v, const mesh *m) {
    float(*corners)[9] = corners_of(m);
    const int status = plt_move(v->engine, (const float(*)[9])corners, &v->fault);
    free(corners);
    return status;
}

/* ---- ways to move -------------------------------------------------------------- */

static void stay(float p[3], random_state *r) {
    (void)p;
    (void)r;
}

static void shiver(float p[3], random_state *r) {
    for (int a = 0; a < 3; a++) {
        p[a] += random_float(r, -0.02f, 0.02f);
    }
}

static void twist(float p[3], random_state *r) {
    const float c = cosf(2.0f * p[1]), s = sinf(2.0f * p[1]), x = p[0];
    (void)r;
    p[0] = c * x - s * p[2];
    p[2] = s * x + c * p[2];
}

static void mirror(float p[3], random_state *r) {
    (void)r;
    p[0] = -p[0];
    p[1] = p[1] * 3.0f + 1.0f;
}

/* Everything into a plane: triangles along it keep an area. */
static void flatten(float p[3], random_state *r) {
    (void)r;
    p[1] = 0.25f;
}

static void collapse(float p[3], random_state *r) {
    (void)r;
    p[0] = p[1] = p[2] = -0.0f;
}

/* Anywhere: the tree is of no use any more. */
static void scatter(float p[3], random_state *r) {
    for (int a = 0; a < 3; a++) {
        p[a] = random_float(r, -50.0f, 50.0f);
    }
}

static void far_away(float p[3], random_state *r) {
    (void)r;
    for (int a = 0; a < 3; a++) {
        p[a] = p[a] * 1e6f + 1e11f;
    }
}

static void (*const ways[])(float p[3], random_state *r) = {stay,    shiver,  twist,    mirror,
                                                            flatten, scatter, collapse, far_away};
enum { WAYS = sizeof ways / sizeof *ways };

static void deform(mesh *m, unsigned way) {
    random_state r = {way};
    for (size_t i = 0; i < m->vertices; i++) {
        ways[way](&m->vertex[3 * i], &r);
    }
}

/* ---- what is to be the same ------------------------------------------------------- */

static void compare_hits(mover *v, rig *fresh, const mesh *m, const char *name) {
    static plt_ray rays[RAYS];
    static plt_hit moved[RAYS], due[RAYS];
    random_state r = {m->triangles};
    rays_mixed(rays, RAYS, m, &r);
    for (int any = 0; any < 2; any++) {
        CHECK(plt_trace(v->engine, rays, moved, RAYS, any) == PLT_OK, "%s", name);
        CHECK(plt_trace(fresh->engine, rays, due, RAYS, any) == PLT_OK, "%s", name);
        CHECK(memcmp(moved, due, sizeof due) == 0, "%s, any %d: hits", name, any);
    }
}

static void compare_frames(mover *v, rig *fresh, const char *name) {
    static const float from[3] = {1.0f, 0.8f, 2.2f};
    const plt_info *info = plt_engine_info(fresh->engine);
    float eye[3], look[3];
    for (int a = 0; a < 3; a++) {
        look[a] = 0.5f * (info->lo[a] + info->hi[a]);
        eye[a] = look[a] + from[a] * (info->hi[0] - info->lo[0] + 1.0f);
    }
    const plt_frame f = frame_of(eye, look, 37, 29, PLT_SHADE_TRIANGLE);
    CHECK(frame_hash(v->engine, &f, 500) == frame_hash(fresh->engine, &f, 500), "%s: frame", name);
}

/* Its boxes are tight, and all else is as before. */
static void check_tree(const mover *v, const char *name) {
    const plt_engine *e = v->engine;
    const plt_info *info = plt_engine_info(e);
    if (info->build != PLT_BUILD_HOST) {
        return;
    }
    tree_view view = tree_view_of(&v->image);
    view.nodes = (const unsigned char *)e->scene.thesis.nodes;
    view.records = (const unsigned char *)e->scene.thesis.records;
    memcpy(view.lo, info->lo, sizeof view.lo);
    memcpy(view.hi, info->hi, sizeof view.hi);
    const tree_facts facts = tree_check(&view);
    CHECK(facts.broken == 0, "%s: %s", name, facts.sentence);
}

static void move_and_compare(mover *v, const mesh *m, const rig_config *config, unsigned way) {
    rig fresh;
    char name[200];
    snprintf(name, sizeof name, "%s, way %u", rig_name(config), way);
    CHECK(move_to(v, m) == PLT_OK, "%s: %s", name, v->fault.message);
    check_tree(v, name);
    if (rig_open(&fresh, m, config) == PLT_OK) {
        const plt_info *now = plt_engine_info(v->engine), *due = plt_engine_info(fresh.engine);
        CHECK(now->lo[0] == due->lo[0] && now->lo[1] == due->lo[1] && now->lo[2] == due->lo[2] &&
                  now->hi[0] == due->hi[0] && now->hi[1] == due->hi[1] && now->hi[2] == due->hi[2],
              "%s: box", name);
        compare_hits(v, &fresh, m, name);
        compare_frames(v, &fresh, name);
        rig_close(&fresh);
    }
}

/* One way after the other, each from where the last one led. */
static void all_ways(const rig_config *config, uint32_t triangles, int is_mapped) {
    mesh m = {0};
    mover v;
    shape_soup(&m, rig_triangles(triangles, config->pack.leaf_triangles), 0.15f, triangles);
    if (open_mover(&v, &m, config, is_mapped) == PLT_OK) {
        for (unsigned way = 0; way < WAYS; way++) {
            deform(&m, way);
            move_and_compare(&v, &m, config, way);
        }
    }
    close_mover(&v);
    mesh_free(&m);
}

static void every_tree(void) {
    static const uint32_t sizes[] = {1, 16, 64, 1000};
    for (uint32_t k = 1; k <= 4; k++) {
        for (unsigned n = 0; n < 4; n++) {
            for (uint8_t build = PLT_BUILD_HOST; build <= PLT_BUILD_DEVICE; build++) {
                for (uint8_t splits = 0; splits < 2; splits++) {
                    rig_config c = rig_config_of(k, treelet(sizes[n]), build, splits);
                    c.run.packet_side =
                        (uint8_t)(2u << (k + n) % (PLT_PACKET_SIDE_MAX < 16 ? 1 : 4));
                    c.run.order = (uint8_t)((k + n) % 2);
                    all_ways(&c, 120 + 60 * k, (int)(k + n) / 2 % 2);
                }
            }
        }
    }
}

/* No triangles, one, two, one list of all, lists of more than the mesh has. */
static void small_scenes(void) {
    for (uint32_t triangles = 0; triangles < 6; triangles++) {
        for (uint8_t build = PLT_BUILD_HOST; build <= PLT_BUILD_NONE; build++) {
            const rig_config c =
                rig_config_of(1 + triangles % 3, treelet(16), build, PLT_SPLIT_SAH);
            mesh m = {0};
            mover v;
            shape_soup(&m, triangles, 0.5f, 1);
            if (open_mover(&v, &m, &c, triangles % 2) == PLT_OK) {
                for (unsigned way = 0; way < WAYS; way++) {
                    deform(&m, way);
                    if (build == PLT_BUILD_NONE || triangles == 0) {
                        rig fresh;
                        CHECK(move_to(&v, &m) == PLT_OK, "%s", v.fault.message);
                        CHECK(rig_open(&fresh, &m, &c) == PLT_OK, "%s", fresh.fault.message);
                        compare_hits(&v, &fresh, &m, "a list");
                        rig_close(&fresh);
                    } else {
                        move_and_compare(&v, &m, &c, way);
                    }
                }
            }
            close_mover(&v);
            mesh_free(&m);
        }
    }
}

/* With a wave, which has no wide form then. */
static void in_waves(void) {
    rig_config c = rig_config_of(2, treelet(16), PLT_BUILD_HOST, PLT_SPLIT_SAH);
    c.run.rays_in_flight = 32;
    c.run.rays = PLT_RAYS_INCOHERENT;
    all_ways(&c, 900, 1);
}

/* What has not moved keeps every bit, zeros of either sign, too. */
static void unchanged(void) {
    for (unsigned scene = 0; scene < 6; scene++) {
        mesh m = {0};
        mover v;
        const rig_config c = rig_config_of(1 + scene % 3, treelet(16), PLT_BUILD_HOST, scene % 2);
        switch (scene) {
        case 0:
            shape_icosphere(&m, rig_is_tiny() ? 0 : 3);
            break;
        case 1:
            shape_sheet(&m, rig_is_tiny() ? 2 : 12, 1);
            break;
        case 2:
            shape_needles(&m, 12);
            break;
        case 3:
            shape_coincident(&m, 9);
            break;
        default:
            shape_soup(&m, rig_triangles(700, 1), 0.2f, scene);
        }
        for (size_t i = 0; i < m.vertices; i += 3) { /* zeros of either sign */
            m.vertex[3 * i + scene % 3] = i % 2 ? 0.0f : -0.0f;
        }
        if (open_mover(&v, &m, &c, 0) == PLT_OK) {
            const plt_tree *t = &v.engine->scene.thesis;
            const size_t nodes = t->node_slots * sizeof *t->nodes;
            const size_t records = t->records_count * sizeof *t->records;
            void *was = malloc(nodes + records + 1);
            memcpy(was, t->nodes, nodes);
            memcpy((char *)was + nodes, t->records, records);
            CHECK(move_to(&v, &m) == PLT_OK, "%s", v.fault.message);
            CHECK(memcmp(was, t->nodes, nodes) == 0, "scene %u: nodes", scene);
            CHECK(memcmp((char *)was + nodes, t->records, records) == 0, "scene %u: records",
                  scene);
            free(was);
        }
        close_mover(&v);
        mesh_free(&m);
    }
}

static void bad_corners(void) {
    static const float bad[] = {NAN, INFINITY, -INFINITY, 1.2e12f, -1.2e12f};
    const rig_config c = rig_config_of(2, treelet(16), PLT_BUILD_HOST, PLT_SPLIT_SAH);
    mesh m = {0};
    mover v;
    rig fresh;
    shape_soup(&m, rig_triangles(200, 2), 0.3f, 3);
    if (open_mover(&v, &m, &c, 1) == PLT_OK && rig_open(&fresh, &m, &c) == PLT_OK) {
        float(*corners)[9] = corners_of(&m);
        const uint32_t last = (uint32_t)m.triangles - 1;
        for (unsigned i = 0; i < 45; i++) {
            const uint32_t at = i % 3 == 0 ? 0 : i % 3 == 1 ? last : last / 2;
            const float was = corners[at][i % 9];
            corners[at][i % 9] = bad[i % 5];
            CHECK(plt_move(v.engine, (const float(*)[9])corners, &v.fault) == PLT_ERR_ARGUMENT &&
                      v.fault.offset == at && strstr(v.fault.message, "corner"),
                  "corner %u of %u: %u, %s", i % 9, at, v.fault.offset, v.fault.message);
            corners[at][i % 9] = was;
        }
        free(corners);
        compare_hits(&v, &fresh, &m, "after refusals");
        corners = corners_of(&m);
        corners[0][0] = PLT_COORD_MAX;
        CHECK(plt_move(v.engine, (const float(*)[9])corners, &v.fault) == PLT_OK, "at 2^40");
        free(corners);
        rig_close(&fresh);
    }
    close_mover(&v);
    mesh_free(&m);
}

static void refusals(void) {
    mesh m = {0};
    rig r;
    rig_config c = rig_config_of(2, treelet(16), PLT_BUILD_HOST, PLT_SPLIT_SAH);
    shape_soup(&m, rig_triangles(50, 2), 0.3f, 3);
    float(*corners)[9] = corners_of(&m);
    CHECK(rig_open(&r, &m, &c) == PLT_OK, "%s", r.fault.message);
    CHECK(plt_move(r.engine, (const float(*)[9])corners, &r.fault) == PLT_ERR_ARGUMENT &&
              strstr(r.fault.message, "not opened to be moved"),
          "%s", r.fault.message);
    plt_options o = c.run;
    o.movable = 1;
    CHECK(plt_arena_need(&r.image.info, 1, &o) > plt_arena_need(&r.image.info, 1, &c.run),
          "nodes and records are copied");
    o.movable = 2;
    CHECK(plt_arena_need(&r.image.info, 1, &o) == 0, "an unknown option");
    o.movable = 1;
    o.residency = PLT_RESIDENCY_STREAMED;
    CHECK(plt_arena_need(&r.image.info, 0, &o) == 0, "a streamed scene");
    o.residency = PLT_RESIDENCY_WHOLE;
    o.rays_in_flight = 32;
    o.wide = 1;
    CHECK(plt_arena_need(&r.image.info, 1, &o) == 0, "with a wide form");
    rig_close(&r);
    free(corners);
    compact_config blocks = compact_config_of(2, 14, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    blocks.run.movable = 1;
    CHECK(compact_open(&r, &m, &blocks) == PLT_ERR_ARGUMENT && strstr(r.fault.message, "compact"),
          "%s", r.fault.message);
    rig_close(&r);
    mesh_free(&m);
}

int main(void) {
    test("moved triangles: hits and frames are those of a scene that is packed anew");
    every_tree();
    test("... of few triangles, and without a tree");
    small_scenes();
    test("... by the wave");
    in_waves();
    test("what has not moved keeps every bit");
    unchanged();
    test("a corner that is no number or too far away is refused, and nothing has changed");
    bad_corners();
    test("what cannot be moved is refused");
    refusals();
    return test_done();
}
