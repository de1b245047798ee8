/* test_move - triangles that move, and trees that are refitted, against scenes that are packed anew
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "engine/engine.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/mover.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

static void move_and_compare(mover *v, const mesh *m, const rig_config *config, unsigned way) {
    char name[200];
    snprintf(name, sizeof name, "%s, way %u", rig_name(config), way);
    CHECK(mover_move(v, m) == PLT_OK, "%s: %s", name, v->fault.message);
    mover_compare(v, m, config, name);
}

/* One way after the other, each from where the last one led. */
static void all_ways(const rig_config *config, uint32_t triangles, int is_mapped) {
    mesh m = {0};
    mover v = {.bytes = 0};
    shape_soup(&m, rig_triangles(triangles, config->pack.leaf_triangles), 0.15f, triangles);
    if (mover_open(&v, &m, config, is_mapped) == PLT_OK) {
        for (unsigned way = 0; way < MOVER_WAYS; way++) {
            mover_deform(&m, way);
            move_and_compare(&v, &m, config, way);
        }
    }
    mover_close(&v);
    mesh_free(&m);
}

static void every_tree(void) {
    static const uint32_t sizes[] = {1, 16, 64, 1000};
    for (uint32_t k = 1; k <= 4; k++) {
        for (unsigned n = 0; n < 4; n++) {
            for (uint8_t build = PLT_BUILD_HOST; build <= PLT_BUILD_DEVICE; build++) {
                for (uint8_t splits = 0; splits < 2; splits++) {
                    rig_config c = rig_config_of(k, mover_treelet(sizes[n]), build, splits);
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
                rig_config_of(1 + triangles % 3, mover_treelet(16), build, PLT_SPLIT_SAH);
            mesh m = {0};
            mover v = {.bytes = 0};
            shape_soup(&m, triangles, 0.5f, 1);
            if (mover_open(&v, &m, &c, triangles % 2) == PLT_OK) {
                for (unsigned way = 0; way < MOVER_WAYS; way++) {
                    mover_deform(&m, way);
                    if (build == PLT_BUILD_NONE || triangles == 0) {
                        rig fresh;
                        CHECK(mover_move(&v, &m) == PLT_OK, "%s", v.fault.message);
                        CHECK(rig_open(&fresh, &m, &c) == PLT_OK, "%s", fresh.fault.message);
                        compare_rays(v.engine, fresh.engine, &m, "a list");
                        rig_close(&fresh);
                    } else {
                        move_and_compare(&v, &m, &c, way);
                    }
                }
            }
            mover_close(&v);
            mesh_free(&m);
        }
    }
}

/* With a wave, which has no wide form then. */
static void in_waves(void) {
    rig_config c = rig_config_of(2, mover_treelet(16), PLT_BUILD_HOST, PLT_SPLIT_SAH);
    c.run.rays_in_flight = 32;
    c.run.rays = PLT_RAYS_INCOHERENT;
    all_ways(&c, 900, 1);
}

/* What has not moved keeps every bit, zeros of either sign, too. */
static void unchanged(void) {
    for (unsigned scene = 0; scene < 6; scene++) {
        mesh m = {0};
        mover v = {.bytes = 0};
        const rig_config c =
            rig_config_of(1 + scene % 3, mover_treelet(16), PLT_BUILD_HOST, scene % 2);
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
        if (mover_open(&v, &m, &c, 0) == PLT_OK) {
            const plt_tree *t = &v.engine->scene.thesis;
            const size_t nodes = t->node_slots * sizeof *t->nodes;
            const size_t records = t->records_count * sizeof *t->records;
            void *was = malloc(nodes + records + 1);
            memcpy(was, t->nodes, nodes);
            memcpy((char *)was + nodes, t->records, records);
            CHECK(mover_move(&v, &m) == PLT_OK, "%s", v.fault.message);
            CHECK(memcmp(was, t->nodes, nodes) == 0, "scene %u: nodes", scene);
            CHECK(memcmp((char *)was + nodes, t->records, records) == 0, "scene %u: records",
                  scene);
            free(was);
        }
        mover_close(&v);
        mesh_free(&m);
    }
}

static void bad_corners(void) {
    static const float bad[] = {NAN, INFINITY, -INFINITY, 1.2e12f, -1.2e12f};
    const rig_config c = rig_config_of(2, mover_treelet(16), PLT_BUILD_HOST, PLT_SPLIT_SAH);
    mesh m = {0};
    mover v = {.bytes = 0};
    rig fresh;
    shape_soup(&m, rig_triangles(200, 2), 0.3f, 3);
    if (mover_open(&v, &m, &c, 1) == PLT_OK && rig_open(&fresh, &m, &c) == PLT_OK) {
        float(*corners)[9] = mover_corners(&m);
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
        compare_rays(v.engine, fresh.engine, &m, "after refusals");
        corners = mover_corners(&m);
        corners[0][0] = PLT_COORD_MAX;
        CHECK(plt_move(v.engine, (const float(*)[9])corners, &v.fault) == PLT_OK, "at 2^40");
        free(corners);
        rig_close(&fresh);
    }
    mover_close(&v);
    mesh_free(&m);
}

static void refusals(void) {
    mesh m = {0};
    rig r;
    rig_config c = rig_config_of(2, mover_treelet(16), PLT_BUILD_HOST, PLT_SPLIT_SAH);
    shape_soup(&m, rig_triangles(50, 2), 0.3f, 3);
    float(*corners)[9] = mover_corners(&m);
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
