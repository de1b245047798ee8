/* test_subtrees - subtrees that are built anew in their own slots, while triangles move
 *
 * Each engine lies in an arena of just its need.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "engine/builder/split.h"
#include "engine/engine.h"
#include "tests/reference/mover.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

static rig_config config_of(uint32_t k, uint32_t nodes, uint8_t build, uint32_t most) {
    rig_config c = rig_config_of(k, mover_treelet(nodes), build, PLT_SPLIT_SAH);
    c.run.rebuild = 1;
    c.run.rebuild_most = most;
    return c;
}

/* Sums of areas, kept from refit to refit, are those of the tree as it is: all of them again. */
static void check_areas(mover *v, const char *name) {
    plt_engine *e = v->engine;
    const plt_subtrees *s = &e->moving.subtrees;
    const plt_areas had = e->moving.areas;
    plt_refit_job whole = {.nodes = (plt_node *)(uintptr_t)e->scene.thesis.nodes,
                           .records = e->scene.thesis.records,
                           .root = e->scene.thesis.root,
                           .levels = e->moving.levels,
                           .areas = had};
    if (s->count == 0) {
        return;
    }
    plt_refit(&whole);
    CHECK(whole.areas.sum == had.sum && whole.areas.ratios == had.ratios, "%s: areas of all", name);
    for (const plt_subtree *p = s->at; p < s->at + s->count; p++) {
        plt_refit_job part = whole;
        part.root = plt_link_make(p->root, 0);
        plt_refit(&part);
        CHECK(part.areas.sum == p->sum && part.areas.ratios == p->ratios,
              "%s: areas of the subtree at %u", name, p->first);
    }
}

/* Disjoint, in order, of the right sizes; each at its parent's link. */
static void check_subtrees(const mover *v, uint32_t most, const char *name) {
    const plt_engine *e = v->engine;
    const plt_subtrees *s = &e->moving.subtrees;
    const uint32_t n = e->scene.info.triangles, t = most < n ? most : n;
    plt_motion q;
    plt_motion_get(e, &q);
    CHECK(q.subtrees == s->count && s->count <= plt_subtrees_most(n, most), "%s: %u", name,
          s->count);
    uint32_t next = 0;
    for (const plt_subtree *p = s->at; p < s->at + s->count; p++) {
        CHECK(p->first >= next && p->count <= t && p->count >= t / 4 && p->first + p->count <= n,
              "%s: a subtree of %u at %u", name, p->count, p->first);
        next = p->first + p->count;
        const uint32_t link =
            p->parent == PLT_SUBTREE_NONE
                ? e->scene.thesis.root
                : plt_node_link(&e->scene.thesis.nodes[p->parent / 2], (int)(p->parent % 2));
        CHECK(!plt_link_is_leaf(link) && plt_link_index(link) == p->root, "%s: its parent", name);
        CHECK(plt_subtrees_of(s, p->first, p->depth) == p &&
                  plt_subtrees_of(s, next - 1, p->depth + 3) == p &&
                  (p->depth == 0 || plt_subtrees_of(s, p->first, p->depth - 1) == NULL) &&
                  plt_subtrees_of(s, next, 0xFFFF) != p,
              "%s: the subtree of a node", name);
    }
}

/* Triangles move between every pair of steps: all, or an eighth of them. */
static void move(mover *v, mesh *m, unsigned way, int some, const char *name) {
    if (!some) {
        mover_deform(m, way);
        CHECK(mover_move(v, m) == PLT_OK, "%s: %s", name, v->fault.message);
        return;
    }
    const uint32_t few = (uint32_t)m->triangles / 8 + 1;
    uint32_t *ids = malloc(few * sizeof *ids);
    for (uint32_t i = 0; i < few; i++) {
        ids[i] = (i * 7 + way) % (uint32_t)m->triangles;
        for (unsigned c = 0; c < 3; c++) {
            m->vertex[3 * (size_t)m->triangle[3 * ids[i] + c]] += 0.3f;
        }
    }
    float(*all)[9] = mover_corners(m);
    float(*corners)[9] = malloc(few * sizeof *corners);
    for (uint32_t i = 0; i < few; i++) {
        memcpy(corners[i], all[ids[i]], sizeof corners[i]);
    }
    CHECK(plt_move_some(v->engine, ids, (const float(*)[9])corners, few, &v->fault) == PLT_OK,
          "%s: %s", name, v->fault.message);
    free(ids);
    free(all);
    free(corners);
}

static unsigned finished, given_up;

static void while_moving(const rig_config *config, uint32_t triangles, uint32_t step, int some) {
    mesh m = {0};
    mover v = {.bytes = 0};
    shape_soup(&m, rig_triangles(triangles, config->pack.leaf_triangles), 0.15f, step);
    if (mover_open(&v, &m, config, (int)(step % 2)) == PLT_OK) {
        plt_motion q = {0};
        check_subtrees(&v, config->run.rebuild_most, rig_name(config));
        for (unsigned frame = 0; frame < 24; frame++) {
            char name[200];
            snprintf(name, sizeof name, "%s, most %u, steps of %u, some %d, frame %u",
                     rig_name(config), config->run.rebuild_most, step, some, frame);
            move(&v, &m, frame % 6, some, name);
            CHECK(plt_rebuild_begin(v.engine, &v.fault) == PLT_OK, "%s: %s", name, v.fault.message);
            if (frame % 3 == 0) {
                mover_compare(&v, &m, config, name);
            }
            const int status = plt_rebuild_step(v.engine, step, &v.fault);
            CHECK(status >= PLT_OK || status == PLT_ERR_ARENA, "%s: status %d, %s", name, status,
                  v.fault.message);
            given_up += status < PLT_OK;
            mover_compare(&v, &m, config, name);
            check_areas(&v, name);
            plt_motion_get(v.engine, &q);
            CHECK(q.is_building == (status == PLT_MORE), "%s: status %d", name, status);
        }
        finished += q.rebuilds;
        CHECK((q.rebuilds == 0) == (q.rebuilt == 0) &&
                  q.rebuilt <= (uint64_t)q.rebuilds * config->run.rebuild_most,
              "%s: %u rebuilds of %u", rig_name(config), q.rebuilds, (unsigned)q.rebuilt);
        check_subtrees(&v, config->run.rebuild_most, rig_name(config));
    }
    mover_close(&v);
    mesh_free(&m);
}

static void between_steps(void) {
    static const uint32_t steps[] = {25, 80, 301, 0xFFFFFFFFu};
    static const uint32_t slots[] = {1, 16, 64, 1000};
    for (unsigned i = 0; i < 4; i++) {
        for (uint32_t k = 1; k <= 4; k++) {
            rig_config c = config_of(k, slots[(i + k) % 4], (uint8_t)(i % 2), 100);
            while_moving(&c, 420, steps[i], 0);
            c.run.moves_some = 1;
            while_moving(&c, 420, steps[i], 1);
        }
    }
    CHECK(finished > 100 && given_up == 0, "%u rebuilt, %u given up", finished, given_up);
}

static void sizes(void) {
    static const uint32_t most[] = {PLT_SUBTREE_LEAST, 33, 150, 400, 1000000};
    for (unsigned i = 0; i < 5; i++) {
        for (uint8_t build = PLT_BUILD_HOST; build <= PLT_BUILD_DEVICE; build++) {
            const rig_config c = config_of(1 + i % 2, 16, build, most[i]);
            while_moving(&c, 300, 150, 0);
        }
    }
    for (uint32_t triangles = 1; triangles < 40; triangles += 1 + triangles / 6) {
        const rig_config c = config_of(1 + triangles % 3, 16, PLT_BUILD_HOST, 16);
        while_moving(&c, triangles, 7, 0);
    }
}

/* A move at each phase of a rebuild. */
static void at_every_phase(void) {
    for (unsigned steps = 0; steps < 20; steps++) {
        for (int some = 0; some < 2; some++) {
            mesh m = {0};
            mover v = {.bytes = 0};
            rig_config c = config_of(2, 16, PLT_BUILD_HOST, 120);
            c.run.moves_some = (uint8_t)some;
            shape_soup(&m, rig_triangles(300, 2), 0.15f, steps);
            if (mover_open(&v, &m, &c, 1) == PLT_OK) {
                char name[64];
                snprintf(name, sizeof name, "after %u steps, some %d", steps, some);
                move(&v, &m, 5, 0, name);
                plt_rebuild_begin(v.engine, &v.fault);
                for (unsigned i = 0; i < steps; i++) {
                    plt_rebuild_step(v.engine, 60, &v.fault);
                }
                move(&v, &m, 2, some, name);
                mover_compare(&v, &m, &c, name);
                while (plt_rebuild_step(v.engine, 60, &v.fault) == PLT_MORE) {
                }
                mover_compare(&v, &m, &c, name);
                check_areas(&v, name);
            }
            mover_close(&v);
            mesh_free(&m);
        }
    }
}

/* A new subtree is as good as the old one was when it was packed, or what it is now. */
static void trees_get_better(void) {
    for (uint32_t k = 1; k <= 4; k++) {
        mesh m = {0};
        mover v = {.bytes = 0};
        const rig_config c = config_of(k, 16, PLT_BUILD_HOST, 150);
        shape_soup(&m, rig_triangles(600, k), 0.1f, k);
        if (mover_open(&v, &m, &c, 1) == PLT_OK) {
            plt_motion before, after;
            move(&v, &m, 5, 0, rig_name(&c));
            plt_motion_get(v.engine, &before);
            for (uint32_t i = 0; i < before.subtrees; i++) {
                plt_rebuild_begin(v.engine, &v.fault);
                while (plt_rebuild_step(v.engine, 100, &v.fault) == PLT_MORE) {
                }
            }
            uint64_t now = 0, was = 0;
            for (uint32_t i = 0; i < before.subtrees; i++) {
                now += v.engine->moving.subtrees.at[i].sum;
            }
            plt_motion_get(v.engine, &after);
            const uint64_t sum = v.engine->moving.areas.sum;
            move(&v, &m, 0, 0, rig_name(&c));
            CHECK(v.engine->moving.areas.sum == sum, "%s: the sum is kept", rig_name(&c));
            for (uint32_t i = 0; i < before.subtrees; i++) {
                was += v.engine->moving.subtrees.at[i].sum_built;
            }
            CHECK(after.rebuilds == before.subtrees || rig_is_tiny(), "%u of %u", after.rebuilds,
                  before.subtrees);
            CHECK(now == was, "%s: each was rebuilt once", rig_name(&c));
            CHECK(after.rebuilds == 0 || after.growth < before.growth, "%s: growth %g, before %g",
                  rig_name(&c), (double)after.growth, (double)before.growth);
        }
        mover_close(&v);
        mesh_free(&m);
    }
}

/* Counters of rays, as a frame leaves them. */
static void work(mover *v, uint64_t groups) {
    v->engine->traversal.stats.group_tests += groups;
}

/* Triangles of one subtree fly apart: it is the one that is chosen, when it pays. */
static void the_worst(void) {
    mesh m = {0};
    mover v = {.bytes = 0};
    const rig_config c = config_of(2, 16, PLT_BUILD_HOST, 100);
    shape_soup(&m, rig_triangles(500, 2), 0.1f, 9);
    if (mover_open(&v, &m, &c, 1) == PLT_OK && v.engine->moving.subtrees.count > 1) {
        plt_engine *e = v.engine;
        const plt_subtree *p = &e->moving.subtrees.at[1], had = *p;
        plt_motion q;
        work(&v, 1000000000);
        CHECK(!plt_rebuild_due(e, PLT_REBUILD_COST, 0), "nothing has grown");
        CHECK(plt_rebuild_due(e, PLT_REBUILD_ALWAYS, 0) && !plt_rebuild_due(e, 0, 0), "always");
        CHECK(!plt_rebuild_due(e, PLT_REBUILD_THRESHOLD, 1), "no ratio has grown");
        for (uint32_t i = had.first; i < had.first + had.count; i++) {
            const uint32_t id = plt_primitive_id(e->scene.thesis.records[i].word[9]);
            for (unsigned corner = 0; corner < 3; corner++) {
                m.vertex[3 * (size_t)m.triangle[3 * id + corner] + i % 3] += (float)(i % 7);
            }
        }
        CHECK(mover_move(&v, &m) == PLT_OK, "%s", v.fault.message);
        plt_motion_get(e, &q);
        CHECK(p->sum > 2 * had.sum && q.excess_work == 0 &&
                  q.build_work == (uint64_t)PLT_REBUILD_WORK * had.count,
              "excess %g, build %g", (double)q.excess_work, (double)q.build_work);
        CHECK(!plt_rebuild_due(e, PLT_REBUILD_COST, 0), "nothing was traced since");
        const float share = 0.01f * (float)PLT_GROWTH_WORK * (float)(p->sum - p->sum_built) /
                            (float)e->moving.areas.sum;
        const uint64_t enough = (uint64_t)((float)q.build_work / (share < 1.0f ? share : 1.0f));
        work(&v, enough * 9 / 10);
        CHECK(!plt_rebuild_due(e, PLT_REBUILD_COST, 0), "not yet");
        work(&v, enough / 5);
        CHECK(plt_rebuild_due(e, PLT_REBUILD_COST, 0), "due");
        plt_stats_reset(e);
        CHECK(plt_rebuild_due(e, PLT_REBUILD_COST, 0), "... after a reset");
        CHECK(plt_rebuild_begin(e, &v.fault) == PLT_OK && e->moving.rebuild.part == p, "it begins");
        while (plt_rebuild_step(e, 50, &v.fault) == PLT_MORE) {
        }
        plt_motion_get(e, &q);
        CHECK(q.rebuilds == 1 && q.rebuilt == had.count && p->sum_built == p->sum &&
                  p->excess == 0 && !plt_rebuild_due(e, PLT_REBUILD_COST, 0),
              "%u rebuilds", q.rebuilds);
        mover_compare(&v, &m, &c, "the worst subtree");
        CHECK(p->first == had.first && p->count == had.count && p->slots == had.slots, "its slots");
    }
    mover_close(&v);
    mesh_free(&m);
}

/* As if its slots were fewer: it is given up, and due again when as much has been lost. */
static void without_room(void) {
    mesh m = {0};
    mover v = {.bytes = 0};
    const rig_config c = config_of(2, 16, PLT_BUILD_HOST, 100);
    shape_soup(&m, rig_triangles(500, 2), 0.1f, 9);
    if (mover_open(&v, &m, &c, 1) == PLT_OK && v.engine->moving.subtrees.count > 0) {
        plt_engine *e = v.engine;
        plt_motion q;
        move(&v, &m, 5, 0, "scattered");
        work(&v, 1000000);
        CHECK(plt_rebuild_begin(e, &v.fault) == PLT_OK, "%s", v.fault.message);
        plt_subtree *p = e->moving.rebuild.part;
        e->moving.rebuild.build.room = 3;
        int status;
        while ((status = plt_rebuild_step(e, 30, &v.fault)) == PLT_MORE) {
        }
        CHECK(status == PLT_ERR_ARENA && strstr(v.fault.message, "old one stays") != NULL &&
                  v.fault.need_bytes == 0,
              "status %d, %s", status, v.fault.message);
        plt_motion_get(e, &q);
        CHECK(p->excess == 0 && p->tried == plt_subtree_degradation(p) * (p->tried > 0.0f) &&
                  q.rebuilds == 0 && !q.is_building,
              "given up");
        mover_compare(&v, &m, &c, "given up");
        work(&v, 1000000000);
        CHECK(plt_rebuild_due(e, PLT_REBUILD_COST, 0), "due again");
    }
    mover_close(&v);
    mesh_free(&m);
}

static void refusals(void) {
    mesh m = {0};
    mover v = {.bytes = 0};
    rig_config c = config_of(2, 16, PLT_BUILD_HOST, 64);
    shape_soup(&m, rig_triangles(600, 2), 0.1f, 3);
    if (mover_open(&v, &m, &c, 1) == PLT_OK) {
        plt_options o = c.run;
        o.movable = 1;
        const size_t parts = plt_arena_need(&v.image.info, 1, &o);
        o.rebuild_most = 0;
        CHECK(parts > 0 && (parts < plt_arena_need(&v.image.info, 1, &o) || rig_is_tiny()),
              "subtrees take less");
        o.rebuild_most = PLT_SUBTREE_LEAST - 1;
        CHECK(plt_arena_need(&v.image.info, 1, &o) == 0, "too few triangles");
        o.rebuild_most = PLT_SUBTREE_LEAST;
        CHECK(plt_arena_need(&v.image.info, 1, &o) > 0, "just enough");
        o.order = PLT_ORDER_TWO_STAGE;
        CHECK(plt_arena_need(&v.image.info, 1, &o) == 0, "in two stages");
        o.order = PLT_ORDER_DEPTH_FIRST;
        o.rebuild = 0;
        CHECK(plt_arena_need(&v.image.info, 1, &o) == 0, "without rebuilds");
    }
    mover_close(&v);
    v.bytes = 0;
    c.pack.build = PLT_BUILD_NONE;
    if (mover_open(&v, &m, &c, 1) == PLT_OK) {
        CHECK(plt_rebuild_begin(v.engine, &v.fault) == PLT_ERR_ARGUMENT, "a list has no tree");
    }
    mover_close(&v);
    mesh_free(&m);
}

typedef struct part_of_tree {
    uint32_t first, count, nodes;
} part_of_tree;

/* Every node that could be rebuilt is in a subtree that is. */
static part_of_tree check_covered(const plt_engine *e, uint32_t link, uint32_t depth,
                                  uint32_t first, uint32_t room, unsigned *uncovered) {
    part_of_tree t = {first, 0, 0};
    const plt_tree *tree = &e->scene.thesis;
    if (plt_link_is_leaf(link)) {
        for (uint32_t lists = plt_link_lists(link); lists > 0; t.count++) {
            lists -= (uint32_t)plt_record_is_last(&tree->records[first + t.count]);
        }
        return t;
    }
    t.nodes = 1;
    for (int c = 0; c < 2; c++) {
        const part_of_tree child =
            check_covered(e, plt_node_link(&tree->nodes[plt_link_index(link)], c), depth + 1,
                          first + t.count, room, uncovered);
        t.count += child.count;
        t.nodes += child.nodes;
    }
    const uint32_t most = plt_subtree_triangles(tree->records_count, e->options.rebuild_most);
    const int fits =
        t.count <= most && t.count >= most / 4 && t.nodes <= room &&
        t.count > 2 * e->scene.info.leaf_triangles &&
        depth + plt_levels_needed(t.count, e->scene.info.leaf_triangles) < PLT_DEPTH_MAX;
    *uncovered += fits && plt_subtrees_of(&e->moving.subtrees, first, depth) == NULL;
    return t;
}

/* Some triangles are twice as far away as the one before: each of them takes a node. */
static void uneven_trees(void) {
    unsigned dense = 0;
    for (uint32_t most = 32; most <= 128; most += 16) {
        mesh m = {0};
        mover v = {.bytes = 0};
        rig_config c = rig_config_of(4, 1, PLT_BUILD_HOST, PLT_SPLIT_MEDIAN);
        c.run.rebuild = 1;
        c.run.rebuild_most = most;
        shape_soup(&m, rig_triangles(800, 4), 0.05f, most);
        for (size_t i = 0; i < m.triangles; i++) {
            for (unsigned k = 0; k < 9; k++) {
                float *p = &m.vertex[3 * (size_t)m.triangle[3 * i + k / 3] + k % 3];
                *p = i < 36 ? (*p + 3.0f) * ldexpf(1.0f, (int)i - 36) : *p + 10.0f;
            }
        }
        if (mover_open(&v, &m, &c, 1) == PLT_OK) {
            const plt_engine *e = v.engine;
            const plt_info *info = &e->scene.info;
            const uint32_t room = plt_subtree_room(info->triangles, info->nodes, most);
            unsigned uncovered = 0;
            const part_of_tree all = check_covered(e, e->scene.thesis.root, 0, 0, room, &uncovered);
            CHECK(all.count == info->triangles && all.nodes == info->nodes && uncovered == 0,
                  "most %u: %u nodes could be rebuilt, and are not", most, uncovered);
            dense += e->moving.subtrees.count;
            check_subtrees(&v, most, "uneven");
        }
        mover_close(&v);
        mesh_free(&m);
    }
    CHECK(dense > 0 || rig_is_tiny(), "%u subtrees", dense);
}

int main(void) {
    test("subtrees rebuilt in steps while triangles move: hits, frames, trees and areas");
    between_steps();
    test("... of every size, and of few triangles");
    sizes();
    test("whatever could be rebuilt can be, also where nodes lead to few triangles");
    uneven_trees();
    test("a move at every phase of it");
    at_every_phase();
    test("all of them rebuilt: the tree is better, and the sum of its areas is kept");
    trees_get_better();
    test("the worst subtree comes first, when it has cost what it costs");
    the_worst();
    test("a subtree that does not fit is given up");
    without_room();
    test("options that are refused");
    refusals();
    return test_done();
}
