/* test_move_some - some triangles that move: every byte is that of moving all
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "engine/engine.h"
#include "tests/reference/mover.h"
#include "tests/reference/random.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

/* Nodes, records, box and degradation of both. */
static void compare(const mover *some, const mover *all, const char *name, unsigned round) {
    const plt_tree *a = &some->engine->scene.thesis, *b = &all->engine->scene.thesis;
    const plt_info *now = plt_engine_info(some->engine), *due = plt_engine_info(all->engine);
    plt_motion p, q;
    plt_motion_get(some->engine, &p);
    plt_motion_get(all->engine, &q);
    CHECK(a->node_slots == b->node_slots &&
              memcmp(a->nodes, b->nodes, a->node_slots * sizeof *a->nodes) == 0,
          "%s, round %u: nodes", name, round);
    CHECK(memcmp(a->records, b->records, a->records_count * sizeof *a->records) == 0,
          "%s, round %u: records", name, round);
    CHECK(memcmp(now->lo, due->lo, sizeof now->lo) == 0 &&
              memcmp(now->hi, due->hi, sizeof now->hi) == 0,
          "%s, round %u: box", name, round);
    for (uint32_t w = 0; w < (now->triangles + 31) / 32; w++) {
        CHECK(some->engine->moving.dirty.bits[w] == 0, "%s, round %u: a bit stays", name, round);
    }
    CHECK(p.degradation == q.degradation && p.moves == q.moves, "%s, round %u: %.9g, not %.9g",
          name, round, (double)p.degradation, (double)q.degradation);
}

/* Triangles of a round: one, a few in a row, many in a row, at random, all, none. */
static uint32_t choose(uint32_t *ids, uint32_t count, unsigned round, random_state *r) {
    const uint32_t length[] = {1, 3, count / 5, count / 3, count, 0};
    const uint32_t wanted = length[round % 6] < count ? length[round % 6] : count;
    const uint32_t first = random_below(r, count);
    for (uint32_t i = 0; i < wanted; i++) {
        ids[i] = round % 12 < 6 ? (first + i) % count : random_below(r, count);
    }
    return wanted;
}

/* The vertices of the chosen triangles go elsewhere, and back to where they were, and to zeros of
 * either sign; an id that comes twice goes to the last. */
static void new_corners(float corner[9], unsigned round, random_state *r) {
    for (int i = 0; i < 9; i++) {
        const float by = random_float(r, -0.4f, 0.4f);
        corner[i] = round % 4 == 3 ? (random_below(r, 2) ? 0.0f : -0.0f) : corner[i] + by;
    }
}

static void rounds(const rig_config *config, const mesh *m, unsigned count) {
    mover some = {.bytes = 0}, all = {.bytes = 0};
    const uint32_t n = (uint32_t)m->triangles;
    uint32_t *ids = malloc((n + 1) * sizeof *ids);
    float(*corners)[9] = mover_corners(m), (*moved)[9] = mover_corners(m);
    random_state r = {n};
    if (mover_open(&some, m, config, 0) == PLT_OK && mover_open(&all, m, config, 1) == PLT_OK) {
        for (unsigned round = 0; round < count; round++) {
            const uint32_t wanted = choose(ids, n, round, &r);
            for (uint32_t i = 0; i < wanted; i++) {
                memcpy(moved[i], corners[ids[i]], sizeof moved[i]);
                new_corners(moved[i], round, &r);
                memcpy(corners[ids[i]], moved[i], sizeof moved[i]);
            }
            CHECK(plt_move_some(some.engine, ids, (const float(*)[9])moved, wanted, &some.fault) ==
                      PLT_OK,
                  "%s", some.fault.message);
            if (wanted > 0) {
                CHECK(plt_move(all.engine, (const float(*)[9])corners, &all.fault) == PLT_OK, "%s",
                      all.fault.message);
            }
            compare(&some, &all, rig_name(config), round);
        }
    }
    mover_close(&some);
    mover_close(&all);
    free(ids);
    free(corners);
    free(moved);
}

static void every_tree(void) {
    static const uint32_t sizes[] = {1, 16, 64, 1000};
    for (uint32_t k = 1; k <= 4; k++) {
        for (unsigned n = 0; n < 4; n++) {
            for (uint8_t build = PLT_BUILD_HOST; build <= PLT_BUILD_DEVICE; build++) {
                mesh m = {0};
                rig_config c = rig_config_of(k, mover_treelet(sizes[n]), build, (uint8_t)(n % 2));
                c.run.moves_some = c.run.rebuild = 1; /* so that degradation is counted */
                shape_soup(&m, rig_triangles(100 + 150 * k, k), 0.15f, k);
                rounds(&c, &m, 24);
                mesh_free(&m);
            }
        }
    }
}

static void small_scenes(void) {
    for (uint32_t triangles = 1; triangles < 70; triangles += triangles < 10 ? 1 : 7) {
        for (uint8_t build = PLT_BUILD_HOST; build <= PLT_BUILD_NONE; build++) {
            mesh m = {0};
            rig_config c = rig_config_of(1 + triangles % 3, mover_treelet(16), build, 0);
            c.run.moves_some = 1;
            shape_soup(&m, rig_triangles(triangles, 1), 0.5f, triangles);
            if (build == PLT_BUILD_NONE) {
                c.run.moves_some = 1;
            }
            rounds(&c, &m, build == PLT_BUILD_NONE ? 0 : 14);
            mesh_free(&m);
        }
    }
}

/* An image with a loose box, of its header alone. */
static void loose_box(void) {
    mesh m = {0};
    mover v = {.bytes = 0};
    rig_config c = rig_config_of(2, mover_treelet(16), PLT_BUILD_HOST, PLT_SPLIT_SAH);
    c.run.moves_some = 1;
    shape_soup(&m, rig_triangles(300, 2), 0.3f, 5);
    if (mover_open(&v, &m, &c, 1) == PLT_OK) {
        float(*corners)[9] = mover_corners(&m);
        for (int a = 0; a < 3; a++) {
            v.engine->scene.box.lo[a] -= 7.0f;
            v.engine->scene.box.hi[a] += 7.0f;
        }
        const uint32_t id = 3;
        CHECK(plt_move_some(v.engine, &id, (const float(*)[9])corners[3], 1, &v.fault) == PLT_OK,
              "%s", v.fault.message);
        mover_compare(&v, &m, &c, "after a loose box");
        free(corners);
    }
    mover_close(&v);
    mesh_free(&m);
}

static void refusals(void) {
    mesh m = {0};
    mover v = {.bytes = 0}, whole = {.bytes = 0};
    rig_config c = rig_config_of(2, mover_treelet(16), PLT_BUILD_HOST, PLT_SPLIT_SAH);
    shape_soup(&m, rig_triangles(200, 2), 0.3f, 3);
    float(*corners)[9] = mover_corners(&m);
    const uint32_t n = (uint32_t)m.triangles;
    uint32_t ids[4] = {0, n - 1, n, 0xFFFFFFFFu};
    CHECK(mover_open(&whole, &m, &c, 1) == PLT_OK, "%s", whole.fault.message);
    CHECK(plt_move_some(whole.engine, ids, (const float(*)[9])corners, 1, &whole.fault) ==
                  PLT_ERR_ARGUMENT &&
              strstr(whole.fault.message, "some triangles"),
          "%s", whole.fault.message);
    c.run.moves_some = 1;
    if (mover_open(&v, &m, &c, 1) == PLT_OK) {
        for (uint32_t bad = 2; bad < 4; bad++) {
            const uint32_t list[3] = {0, n - 1, ids[bad]};
            CHECK(plt_move_some(v.engine, list, (const float(*)[9])corners, 3, &v.fault) ==
                          PLT_ERR_ARGUMENT &&
                      v.fault.offset == 2 && strstr(v.fault.message, "no such triangle"),
                  "%u, %s", v.fault.offset, v.fault.message);
        }
        corners[1][4] = NAN;
        CHECK(plt_move_some(v.engine, ids, (const float(*)[9])corners, 2, &v.fault) ==
                      PLT_ERR_ARGUMENT &&
                  v.fault.offset == 1,
              "%u, %s", v.fault.offset, v.fault.message);
        mover_compare(&v, &m, &c, "after refusals");
    }
    mover_close(&v);
    mover_close(&whole);
    free(corners);
    mesh_free(&m);
}

/* Which SPEC.md allows: then all are moved, or none. */
static void ids_that_come_twice(void) {
    mesh m = {0};
    mover v = {.bytes = 0};
    rig_config c = rig_config_of(2, mover_treelet(16), PLT_BUILD_HOST, PLT_SPLIT_SAH);
    shape_soup(&m, rig_triangles(100, 2), 0.3f, 3);
    if (mover_open(&v, &m, &c, 1) == PLT_OK) {
        plt_record *r = (plt_record *)(uintptr_t)v.engine->scene.thesis.records;
        const uint32_t word = plt_get_u32(&r[0].word[9]) & ~PLT_PRIMITIVE_ID_MASK;
        const size_t words = ((size_t)m.triangles + 31) / 32;
        plt_dirty d = {.places = malloc(4 * m.triangles), .bits = malloc(4 * words)};
        CHECK(plt_dirty_find(&d, r, (uint32_t)m.triangles) == 1, "ids differ");
        plt_put_u32(&r[0].word[9], word | plt_primitive_id(plt_get_u32(&r[9].word[9])));
        CHECK(plt_dirty_find(&d, r, (uint32_t)m.triangles) == 0, "two are the same");
        free(d.places);
        free(d.bits);
    }
    mover_close(&v);
    mesh_free(&m);
}

int main(void) {
    test("some triangles move: nodes, records, box and degradation are those of moving all");
    every_tree();
    test("... in small scenes");
    small_scenes();
    test("... from a box that is not the triangles'");
    loose_box();
    test("ids and corners out of range are refused, and nothing has changed");
    refusals();
    test("two triangles of one id are seen");
    ids_that_come_twice();
    return test_done();
}
