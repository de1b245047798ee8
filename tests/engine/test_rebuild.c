/* test_rebuild - trees that are built anew while triangles move
 *
 * Each engine lies in an arena of just its need, or of less.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/engine.h"
#include "engine/tree/thesis/validate.h"
#include "tests/reference/mover.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

static rig_config config_of(uint32_t k, uint32_t nodes, uint8_t build, uint8_t splits) {
    rig_config c = rig_config_of(k, mover_treelet(nodes), build, splits);
    c.run.rebuild = 1;
    return c;
}

/* Whole, in steps; the number of steps. */
static uint32_t rebuild(mover *v, uint32_t triangles, const char *name) {
    uint32_t steps = 0;
    int status = plt_rebuild_begin(v->engine, &v->fault);
    CHECK(status == PLT_OK, "%s: %s", name, v->fault.message);
    do {
        status = plt_rebuild_step(v->engine, triangles, &v->fault);
        steps++;
    } while (status == PLT_MORE && steps < 1000000);
    CHECK(status == PLT_OK, "%s: %s", name, v->fault.message);
    return steps;
}

/* The tree is as large as that of a scene packed anew, but for the order of equals. */
static void same_size(const mover *v, const mesh *m, const rig_config *config, const char *name) {
    mover due = {.bytes = 0};
    if (mover_open(&due, m, config, 1) == PLT_OK) {
        const uint32_t now = plt_engine_info(v->engine)->nodes;
        const uint32_t anew = plt_engine_info(due.engine)->nodes;
        CHECK(now <= anew + anew / 16 + 1 && anew <= now + now / 16 + 1,
              "%s: %u nodes, packed anew %u", name, now, anew);
    }
    mover_close(&due);
}

/* Scratch serves the builder, then plt_tree_validate, whatever the build's limits are. */
static void check_scratch(const mover *v, const char *name) {
    const plt_build_job *job = &v->engine->moving.rebuild.build;
    const size_t levels = PLT_VALIDATE_LEVELS * sizeof(plt_validate_level);
    CHECK(job->scratch_bytes >= levels, "%s: %zu bytes of scratch, %zu of levels", name,
          job->scratch_bytes, levels);
}

/* Steps of every size, while nothing moves; each tree is the same, whatever the steps. */
static void every_step(const rig_config *config, uint32_t triangles) {
    static const uint32_t sizes[] = {1, 3, 50, 1000, 0xFFFFFFFFu};
    mesh m = {0};
    mover v = {.bytes = 0}, due = {.bytes = 0};
    shape_soup(&m, rig_triangles(triangles, config->pack.leaf_triangles), 0.15f, triangles);
    if (mover_open(&v, &m, config, (int)triangles % 2) == PLT_OK &&
        mover_open(&due, &m, config, 1) == PLT_OK) {
        uint32_t before = 0xFFFFFFFFu;
        check_scratch(&v, rig_name(config));
        for (unsigned i = 0; i < sizeof sizes / sizeof *sizes; i++) {
            char name[200];
            snprintf(name, sizeof name, "%s, steps of %u", rig_name(config), sizes[i]);
            mover_deform(&m, 1 + i);
            CHECK(mover_move(&v, &m) == PLT_OK && mover_move(&due, &m) == PLT_OK, "%s", name);
            const uint32_t steps = rebuild(&v, sizes[i], name);
            CHECK(steps < before || steps <= 16, "%s: %u steps, in shorter ones %u", name, steps,
                  before);
            before = steps;
            mover_compare(&v, &m, config, name);
            rebuild(&due, 77, name);
            const plt_tree *a = &v.engine->scene.thesis, *b = &due.engine->scene.thesis;
            CHECK(a->root == b->root && a->node_slots == b->node_slots &&
                      memcmp(a->nodes, b->nodes, a->node_slots * sizeof *a->nodes) == 0 &&
                      memcmp(a->records, b->records, a->records_count * sizeof *a->records) == 0,
                  "%s: the tree is that of other steps", name);
            same_size(&v, &m, config, name);
        }
    }
    mover_close(&v);
    mover_close(&due);
    mesh_free(&m);
}

static void every_tree(void) {
    static const uint32_t sizes[] = {1, 16, 64, 1000};
    for (uint32_t k = 1; k <= 4; k++) {
        for (unsigned n = 0; n < 4; n++) {
            for (uint8_t build = PLT_BUILD_HOST; build <= PLT_BUILD_DEVICE; build++) {
                rig_config c = config_of(k, sizes[n], build, (uint8_t)(n % 2));
                c.run.order = (uint8_t)((k + n) % 2);
                every_step(&c, 100 + 61 * k);
            }
        }
    }
}

static void small_scenes(void) {
    for (uint32_t triangles = 1; triangles < 12; triangles++) {
        for (uint8_t build = PLT_BUILD_HOST; build <= PLT_BUILD_DEVICE; build++) {
            const rig_config c = config_of(1 + triangles % 3, 16, build, PLT_SPLIT_SAH);
            every_step(&c, triangles);
        }
    }
}

/* In waves, whose stacks are as deep as any tree. */
static void in_waves(void) {
    rig_config c = config_of(2, 16, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    c.run.rays_in_flight = 32;
    c.run.rays = PLT_RAYS_INCOHERENT;
    c.run.count_touched = 1;
    every_step(&c, 700);
}

/* Triangles move between every pair of steps: all, or some. The old tree is right until the swap,
 * the new one from then on. */
static void while_moving(const rig_config *config, uint32_t step, int some) {
    mesh m = {0};
    mover v = {.bytes = 0};
    shape_soup(&m, rig_triangles(300, config->pack.leaf_triangles), 0.15f, step);
    if (mover_open(&v, &m, config, 0) == PLT_OK) {
        int status = PLT_OK;
        plt_motion motion = {0};
        for (unsigned frame = 0; frame < 40 + 9000 / step && motion.rebuilds < 3; frame++) {
            char name[200];
            snprintf(name, sizeof name, "%s, frame %u", rig_name(config), frame);
            mover_deform(&m, frame % 5 + (frame % 5 == 4));
            float(*corners)[9] = mover_corners(&m);
            uint32_t ids[400];
            for (uint32_t i = 0; i < m.triangles; i++) {
                ids[i] = (uint32_t)m.triangles - 1 - i;
            }
            if (some) { /* an eighth, and another time the others */
                const uint32_t few = (uint32_t)m.triangles / 8;
                for (uint32_t i = 0; i < few; i++) {
                    float one[9];
                    memcpy(one, corners[i], sizeof one);
                    memcpy(corners[i], corners[ids[i]], sizeof one);
                    memcpy(corners[ids[i]], one, sizeof one);
                }
                CHECK(plt_move_some(v.engine, ids, (const float(*)[9])corners, few, &v.fault) ==
                          PLT_OK,
                      "%s: %s", name, v.fault.message);
                free(corners);
                corners = mover_corners(&m);
                for (uint32_t i = 0; i < m.triangles - few; i++) {
                    ids[i] = i;
                }
                CHECK(plt_move_some(v.engine, ids, (const float(*)[9])corners,
                                    (uint32_t)m.triangles - few, &v.fault) == PLT_OK,
                      "%s: %s", name, v.fault.message);
            } else {
                CHECK(mover_move(&v, &m) == PLT_OK, "%s: %s", name, v.fault.message);
            }
            free(corners);
            status = plt_rebuild_begin(v.engine, &v.fault);
            CHECK(status == PLT_OK, "%s: %s", name, v.fault.message);
            mover_compare(&v, &m, config, name);
            status = plt_rebuild_step(v.engine, step, &v.fault);
            CHECK(status >= PLT_OK, "%s: %s", name, v.fault.message);
            plt_motion_get(v.engine, &motion);
            CHECK(motion.is_building == (status == PLT_MORE), "%s: status %d", name, status);
            mover_compare(&v, &m, config, name);
        }
        CHECK(motion.rebuilds > 0, "%s: no tree was finished", rig_name(config));
    }
    mover_close(&v);
    mesh_free(&m);
}

static void between_steps(void) {
    static const uint32_t steps[] = {70, 150, 299, 301, 1000, 0xFFFFFFFFu};
    for (unsigned i = 0; i < sizeof steps / sizeof *steps; i++) {
        for (uint32_t k = 1; k <= 4; k *= 2) {
            rig_config c = config_of(k, 16, (uint8_t)(i % 2), PLT_SPLIT_SAH);
            while_moving(&c, steps[i], 0);
            c.run.moves_some = 1;
            while_moving(&c, steps[i], 1);
            c.run.moves_some = 0;
        }
    }
}

/* A move at each phase of a rebuild, all or some. */
static void at_every_phase(void) {
    for (unsigned steps = 0; steps < 24; steps++) {
        for (int some = 0; some < 2; some++) {
            mesh m = {0};
            mover v = {.bytes = 0};
            rig_config c = config_of(2, 16, PLT_BUILD_HOST, PLT_SPLIT_SAH);
            c.run.moves_some = (uint8_t)some;
            shape_soup(&m, rig_triangles(200, 2), 0.15f, steps);
            if (mover_open(&v, &m, &c, 1) == PLT_OK) {
                char name[64];
                snprintf(name, sizeof name, "after %u steps, some %d", steps, some);
                mover_deform(&m, 5);
                CHECK(mover_move(&v, &m) == PLT_OK, "%s", name);
                plt_rebuild_begin(v.engine, &v.fault);
                for (unsigned i = 0; i < steps; i++) {
                    plt_rebuild_step(v.engine, 120, &v.fault);
                }
                if (some) {
                    float to[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
                    const uint32_t id = 7;
                    for (int i = 0; i < 9; i++) {
                        m.vertex[3 * (size_t)m.triangle[3 * id + (uint32_t)i / 3] + i % 3] = to[i];
                    }
                    CHECK(plt_move_some(v.engine, &id, (const float(*)[9]) & to, 1, &v.fault) ==
                              PLT_OK,
                          "%s", v.fault.message);
                } else {
                    mover_deform(&m, 2);
                    CHECK(mover_move(&v, &m) == PLT_OK, "%s", name);
                }
                mover_compare(&v, &m, &c, name);
                while (plt_rebuild_step(v.engine, 120, &v.fault) == PLT_MORE) {
                }
                mover_compare(&v, &m, &c, name);
                rebuild(&v, 500, name);
                mover_compare(&v, &m, &c, name);
            }
            mover_close(&v);
            mesh_free(&m);
        }
    }
}

/* A frame that is being rendered is completed by the old tree. */
static void while_rendering(void) {
    static const float eye[3] = {0.5f, 0.4f, 3.0f}, look[3] = {0.5f, 0.5f, 0.5f};
    const plt_frame f = frame_of(eye, look, 33, 27, PLT_SHADE_TRIANGLE);
    const rig_config c = config_of(2, 16, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    mesh m = {0};
    mover v = {.bytes = 0};
    shape_soup(&m, rig_triangles(300, 2), 0.15f, 3);
    if (mover_open(&v, &m, &c, 1) == PLT_OK) {
        plt_motion motion;
        uint32_t tiles = 0, steps = 0;
        int status;
        CHECK(plt_rebuild_begin(v.engine, &v.fault) == PLT_OK, "%s", v.fault.message);
        CHECK(plt_render_begin(v.engine, &f) == PLT_OK, "begins");
        while ((status = plt_render_step(v.engine, 1)) > PLT_OK) {
            tiles += status == PLT_TILE;
            steps += plt_rebuild_step(v.engine, 1000, &v.fault) == PLT_MORE;
        }
        plt_motion_get(v.engine, &motion);
        CHECK(tiles == plt_render_tiles(v.engine) || tiles > 0, "%u tiles", tiles);
        CHECK(steps > 20 && motion.rebuilds == 0 && motion.is_building, "%u steps", steps);
        CHECK(plt_rebuild_step(v.engine, 1, &v.fault) == PLT_OK, "swapped behind the frame");
        plt_motion_get(v.engine, &motion);
        CHECK(motion.rebuilds == 1 && !motion.is_building, "%u rebuilds", motion.rebuilds);
        mover_compare(&v, &m, &c, "after the frame");
    }
    mover_close(&v);
    mesh_free(&m);
}

/* Arenas of less than the need: opened with fewer slots, or refused; a tree that does not fit is
 * given up, and the old one goes on. */
static void tight_arenas(uint8_t build) {
    const rig_config c = config_of(1, 16, build, PLT_SPLIT_MEDIAN);
    mesh m = {0};
    unsigned opened = 0, refused = 0, too_many = 0;
    shape_soup(&m, rig_triangles(400, 1), 0.15f, 3);
    mover v = {.bytes = 0};
    mover_open(&v, &m, &c, 0);
    const size_t need = v.bytes;
    mover_close(&v);
    for (size_t less = 0; less + 1024 < need; less += 512) {
        mesh moved = {0};
        shape_soup(&moved, rig_triangles(400, 1), 0.15f, 3);
        v.bytes = need - less;
        const int status = mover_open(&v, &m, &c, 0);
        if (status == PLT_OK) {
            opened++;
            for (unsigned way = 1; way < MOVER_WAYS; way++) {
                mover_deform(&moved, way);
                CHECK(mover_move(&v, &moved) == PLT_OK, "%s", v.fault.message);
                plt_rebuild_begin(v.engine, &v.fault);
                int step;
                while ((step = plt_rebuild_step(v.engine, 200, &v.fault)) == PLT_MORE) {
                }
                CHECK(step == PLT_OK || (step == PLT_ERR_ARENA && v.fault.need_bytes == need &&
                                         strstr(v.fault.message, "old one stays")),
                      "%zu bytes: status %d, %s", v.bytes, step, v.fault.message);
                too_many += step == PLT_ERR_ARENA;
                if (less % 4096 == 0) {
                    mover_compare(&v, &moved, &c, "in a tight arena");
                }
            }
        } else {
            refused++;
            CHECK(status == PLT_ERR_ARENA && v.fault.need_bytes == need, "%zu bytes: %d, %zu",
                  v.bytes, status, v.fault.need_bytes);
        }
        mover_close(&v);
        mesh_free(&moved);
    }
    CHECK(opened > 0 && refused > 0, "%u opened, %u refused", opened, refused);
    CHECK(too_many > 0 || rig_is_tiny(), "every new tree fitted");
    mesh_free(&m);
}

/* Half of the triangles go, in pairs or what was near, a way up: nodes grow, triangles do not. */
static void part(mesh *m) {
    for (uint32_t i = 0; i < m->triangles; i++) {
        for (uint32_t c = 0; c < 3 && m->vertex[3 * (size_t)m->triangle[3 * i]] > 0.5f; c++) {
            m->vertex[3 * (size_t)m->triangle[3 * i + c] + 1] += 1.5f * (float)(i % 3);
        }
    }
}

/* Counters of rays, as a frame leaves them. */
static void work(mover *v, uint64_t groups, uint64_t triangles) {
    v->engine->traversal.stats.group_tests += groups;
    v->engine->traversal.stats.triangle_tests += triangles;
}

static int open_soup(mover *v, mesh *m) {
    const rig_config c = config_of(2, 16, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    shape_soup(m, rig_triangles(400, 2), 0.1f, 9);
    return mover_open(v, m, &c, 1);
}

static void policies(void) {
    mesh m = {0};
    mover v = {.bytes = 0};
    if (open_soup(&v, &m) == PLT_OK) {
        plt_engine *e = v.engine;
        plt_motion q;
        plt_motion_get(e, &q);
        CHECK(q.degradation == 0.0f && q.moves == 0 && q.rebuilds == 0 && q.excess_work == 0 &&
                  q.build_work == (uint64_t)PLT_REBUILD_WORK * m.triangles,
              "at first");
        CHECK(!plt_rebuild_due(e, PLT_REBUILD_NEVER, 0) &&
                  plt_rebuild_due(e, PLT_REBUILD_ALWAYS, 0),
              "never, always");
        work(&v, 100 * q.build_work, 0);
        CHECK(!plt_rebuild_due(e, PLT_REBUILD_COST, 0), "a new tree has no excess");
        part(&m);
        CHECK(mover_move(&v, &m) == PLT_OK, "moves");
        plt_motion_get(e, &q);
        CHECK(q.growth > 0.1f && q.moves == 1 && q.excess_work == 0, "%g", (double)q.growth);
        CHECK(q.degradation > 0.02f || rig_is_tiny(), "%g", (double)q.degradation); /* few nodes */
        const unsigned percent = q.degradation > 0.01f ? (unsigned)(100.0f * q.degradation) : 0;
        CHECK((percent == 0 || plt_rebuild_due(e, PLT_REBUILD_THRESHOLD, percent)) &&
                  !plt_rebuild_due(e, PLT_REBUILD_THRESHOLD, percent + 1) &&
                  !plt_rebuild_due(e, 77, percent),
              "a threshold of %u", percent);
        const float worse = 0.01f * (float)PLT_GROWTH_WORK * q.growth;
        const float share = worse / (1.0f + worse);
        const uint64_t enough = (uint64_t)((float)q.build_work / share);
        work(&v, enough / 2, enough / 5);
        CHECK(!plt_rebuild_due(e, PLT_REBUILD_COST, 0), "not yet");
        plt_stats_reset(e);
        work(&v, enough / 8, 0);
        CHECK(plt_rebuild_due(e, PLT_REBUILD_COST, 0), "with what was before the reset");
        CHECK(mover_move(&v, &m) == PLT_OK, "moves");
        CHECK(plt_rebuild_due(e, PLT_REBUILD_COST, 0), "... and after a move");
        CHECK(plt_rebuild_begin(e, &v.fault) == PLT_OK, "%s", v.fault.message);
        CHECK(!plt_rebuild_due(e, PLT_REBUILD_ALWAYS, 0), "one has begun");
        rebuild(&v, 100, "due");
        plt_motion_get(e, &q);
        CHECK(q.degradation == 0.0f && q.excess_work == 0 && q.rebuilds == 1, "anew");
        part(&m);
        plt_rebuild_begin(e, &v.fault);
        while (e->moving.rebuild.phase < PLT_REBUILD_COLLECTS) {
            plt_rebuild_step(e, 100, &v.fault);
        }
        CHECK(mover_move(&v, &m) == PLT_OK, "swapped by a move");
        plt_motion_get(e, &q);
        CHECK(q.degradation == 0.0f && q.rebuilds == 2 && !q.is_building, "%g",
              (double)q.degradation);
    }
    mover_close(&v);
    mesh_free(&m);
}

/* Begun and split until there is no room for more nodes. */
static void give_up(mover *v, const char *name) {
    int status;
    CHECK(plt_rebuild_begin(v->engine, &v->fault) == PLT_OK, "%s", v->fault.message);
    do {
        status = plt_rebuild_step(v->engine, 100, &v->fault);
    } while (status == PLT_MORE);
    CHECK(status == PLT_ERR_ARENA, "%s: status %d", name, status);
}

/* A tree that does not fit has cost what one costs: it is tried again when as much is lost anew. */
static void after_giving_up(void) {
    mesh m = {0};
    mover v = {.bytes = 0};
    if (open_soup(&v, &m) == PLT_OK) {
        plt_engine *e = v.engine;
        plt_motion q;
        unsigned given_up = 0;
        float tried = 0.0f;
        e->moving.rebuild.room = 4; /* slots: as if the arena had no more */
        for (unsigned i = 0; i < 12; i++) {
            part(&m);
            CHECK(mover_move(&v, &m) == PLT_OK, "moves");
            plt_motion_get(e, &q);
            const int is_due = 1.0f + q.degradation >= 1.01f * (1.0f + tried);
            CHECK(plt_rebuild_due(e, PLT_REBUILD_THRESHOLD, 1) == is_due, "%g, at the last try %g",
                  (double)q.degradation, (double)tried);
            if (is_due) {
                give_up(&v, "threshold");
                CHECK(!plt_rebuild_due(e, PLT_REBUILD_THRESHOLD, 1), "at %g, due at once",
                      (double)q.degradation);
                tried = q.degradation;
                given_up++;
            }
        }
        CHECK(given_up > 1 || rig_is_tiny() || PLT_SAH_BINS < 32, "%u trees given up", given_up);
        for (unsigned i = 0; i < 3; i++) {
            CHECK(!plt_rebuild_due(e, PLT_REBUILD_COST, 0), "due with no work done");
            work(&v, 100 * q.build_work, 0);
            CHECK(plt_rebuild_due(e, PLT_REBUILD_COST, 0), "not due");
            give_up(&v, "cost");
            plt_motion_get(e, &q);
            CHECK(q.excess_work == 0 && q.rebuilds == 0 && !q.is_building, "given up");
        }
        CHECK(plt_rebuild_due(e, PLT_REBUILD_ALWAYS, 0), "always is always");
    }
    mover_close(&v);
    mesh_free(&m);
}

/* A tree that is rebuilt is as good as one that is packed: the sum of all areas' ratios. */
static void refusals(void) {
    mesh m = {0};
    mover v = {.bytes = 0};
    rig_config c = config_of(2, 16, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    shape_soup(&m, rig_triangles(60, 2), 0.3f, 3);
    c.run.rebuild = 0;
    if (mover_open(&v, &m, &c, 1) == PLT_OK) {
        CHECK(plt_rebuild_begin(v.engine, &v.fault) == PLT_ERR_ARGUMENT &&
                  strstr(v.fault.message, "to be rebuilt"),
              "%s", v.fault.message);
        CHECK(plt_rebuild_step(v.engine, 1, &v.fault) == PLT_OK, "nothing to do");
        CHECK(!plt_rebuild_due(v.engine, PLT_REBUILD_ALWAYS, 0), "there is no room");
        plt_options o = c.run;
        o.rebuild = 1;
        CHECK(plt_arena_need(&v.image.info, 1, &o) == 0, "not movable");
        o.movable = 1;
        CHECK(plt_arena_need(&v.image.info, 1, &o) > v.bytes, "a second tree takes room");
        o.rebuild = 2;
        CHECK(plt_arena_need(&v.image.info, 1, &o) == 0, "an unknown option");
        o.rebuild = 0;
        o.moves_some = 2;
        CHECK(plt_arena_need(&v.image.info, 1, &o) == 0, "an unknown option");
    }
    mover_close(&v);
    v.bytes = 0;
    c = config_of(2, 16, PLT_BUILD_NONE, PLT_SPLIT_SAH);
    if (mover_open(&v, &m, &c, 1) == PLT_OK) {
        CHECK(plt_rebuild_begin(v.engine, &v.fault) == PLT_ERR_ARGUMENT, "a list has no tree");
    }
    mover_close(&v);
    mesh_free(&m);
}

int main(void) {
    test("rebuilt in steps of any size: hits, frames and trees are those of a scene packed anew");
    every_tree();
    test("... of few triangles");
    small_scenes();
    test("... by the wave, with blocks that are counted");
    in_waves();
    test("triangles move between all steps: the old tree serves until the new one is whole");
    between_steps();
    test("... at every phase");
    at_every_phase();
    test("a frame that is being rendered keeps its tree");
    while_rendering();
    test(
        "an arena of less than the need: fewer slots, and a tree that does not fit changes "
        "nothing");
    tight_arenas(PLT_BUILD_HOST);
    tight_arenas(PLT_BUILD_DEVICE);
    test("when a rebuild is due: never, always, from a threshold, when its cost is reached");
    policies();
    test("a tree that was given up is not due again at once");
    after_giving_up();
    test("what cannot be rebuilt is refused");
    refusals();
    return test_done();
}
