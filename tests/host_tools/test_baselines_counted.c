/* test_baselines_counted - what the thesis counts of packets, of the engine, beside its own BPH
 *
 * The same tree, node for node: spatial medians, one triangle per list. Rays end in front of what
 * they hit, so that nothing is hidden by hits, whose order differs; then a packet meets the nodes
 * and triangles that the boxes say, whichever way it goes through the tree.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "host_tools/base/heap.h"
#include "host_tools/baselines/counted/counted_engine.h"
#include "host_tools/baselines/structure.h"
#include "host_tools/pack/pack.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/rig.h"
#include "tests/test.h"

enum { SIDE = 64, RAYS = SIDE * SIDE, TRIANGLES = 900 };

#define ARENA_BYTES (16 << 20)

static _Alignas(PLT_ALIGN) unsigned char arena[ARENA_BYTES];
static const plt_camera camera = {
    .eye = {0.5f, 1, 5}, .look = {0, 0, 0}, .up = {0, 1, 0}, .tan_half_fov = 0.4f};
static mesh knot;
static packed image;
static plt_ray ray[RAYS];
static plt_hit hit[RAYS], again[RAYS];

static void build_knot(size_t triangles) {
    const pack_options options = {.leaf_triangles = 1,
                                  .treelet_nodes = rig_is_tiny() ? 1 : 16,
                                  .splits = PLT_SPLIT_MEDIAN,
                                  .build = PLT_BUILD_HOST};
    fail f = {""};
    scene_knot(&knot, triangles, &f);
    CHECK(pack_mesh(&image, &knot, &options, "knot", &f) == 0, "%s", f.text);
}

static plt_engine *open_engine(unsigned side, unsigned order) {
    const plt_options options = {.packet_side = (uint8_t)side, .order = (uint8_t)order};
    const plt_source source = {.mapped = image.bytes, .bytes = image.size};
    plt_engine *engine = NULL;
    plt_fault fault;
    const int status = plt_open(&engine, arena, sizeof arena, &source, &options, &fault);
    CHECK(status == PLT_OK, "%s", fault.message);
    return status == PLT_OK ? engine : NULL;
}

static built_structure *open_bph(unsigned side) {
    structure_options options = {.packet_side = 0};
    char text[32];
    fail f = {""};
    snprintf(text, sizeof text, "bph:median,leaf-1,%ux%u", side, side);
    const structure_kind *kind = structure_read(text, "a test", &options, &f);
    built_structure *s = kind != NULL ? structure_open(kind, &knot, &options, "knot", &f) : NULL;
    CHECK(s != NULL, "%s", f.text);
    return s;
}

/* From one point through the middle of the scene, in packets that are square; `same` neighbours are
 * one and the same ray. */
static void set_rays(unsigned same) {
    for (uint32_t i = 0; i < RAYS; i++) {
        const uint32_t k = i - i % same;
        uint32_t x = 0, y = 0;
        for (unsigned bit = 0; bit < 6; bit++) {
            x |= (k >> 2 * bit & 1u) << bit;
            y |= (k >> (2 * bit + 1) & 1u) << bit;
        }
        ray[i] = (plt_ray){.org = {0.1f, 0.2f, 5.0f}, .tmax = 1e30f};
        ray[i].dir[0] = ((float)x - 29.3f) / 130.0f;
        ray[i].dir[1] = ((float)y - 33.9f) / 150.0f;
        ray[i].dir[2] = -1.0f;
    }
}

/* Nothing is hit any more. */
static uint32_t end_before_hits(plt_engine *engine) {
    uint32_t ended = 0;
    plt_trace(engine, ray, hit, RAYS, 0);
    for (uint32_t i = 0; i < RAYS; i++) {
        if (hit[i].triangle != PLT_MISS) {
            ray[i].tmax = 0.98f * hit[i].t;
            ended++;
        }
    }
    return ended;
}

static structure_statistics count_engine(plt_engine *engine, const plt_ray *rays, uint32_t count) {
    fail f = {""};
    structure_statistics s = {.rays = 0};
    counted_engine *e = counted_engine_open(engine, "knot", &f);
    CHECK(e != NULL, "%s", f.text);
    if (e != NULL) {
        CHECK(counted_engine_trace(e, rays, again, count, 0, &f) == 0, "%s", f.text);
        s = counted_engine_count(e);
    }
    counted_engine_close(e);
    return s;
}

static structure_statistics count_bph(built_structure *bph, const plt_ray *rays, uint32_t count) {
    fail f = {""};
    structure_forget(bph);
    CHECK(structure_trace(bph, rays, again, count, 0, &f) == 0, "%s", f.text);
    return structure_count(bph);
}

static uint64_t active_at_nodes(const structure_statistics *s) {
    return s->rays_at_nodes - s->masked_at_nodes;
}

static uint64_t active_at_triangles(const structure_statistics *s) {
    return s->rays_at_triangles - s->masked_at_triangles;
}

static void check_same(const structure_statistics *a, const structure_statistics *b,
                       unsigned side) {
    CHECK(a->rays == b->rays && a->packets == b->packets && a->one_sign == b->one_sign,
          "%ux%u: %llu, %llu packets", side, side, (unsigned long long)a->packets,
          (unsigned long long)b->packets);
    CHECK(a->packet_nodes == b->packet_nodes && a->rays_at_nodes == b->rays_at_nodes,
          "%ux%u: %llu, %llu nodes", side, side, (unsigned long long)a->packet_nodes,
          (unsigned long long)b->packet_nodes);
    CHECK(a->packet_triangles == b->packet_triangles &&
              a->rays_at_triangles == b->rays_at_triangles,
          "%ux%u: %llu, %llu triangles", side, side, (unsigned long long)a->packet_triangles,
          (unsigned long long)b->packet_triangles);
}

/* Group for group, in two stages: no hull comes in between. */
static void check_groups(void) {
    for (unsigned side = 2; side <= 16 && side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        plt_engine *engine = open_engine(side, PLT_ORDER_TWO_STAGE);
        built_structure *bph = open_bph(side);
        if (engine == NULL || bph == NULL) {
            continue;
        }
        for (unsigned same = 1; same <= 4; same += 3) {
            set_rays(same);
            CHECK(end_before_hits(engine) > RAYS / 50, "few hits");
            const structure_statistics a = count_engine(engine, ray, RAYS);
            const structure_statistics b = count_bph(bph, ray, RAYS);
            CHECK(b.packet_triangles > 100, "few triangles");
            check_same(&a, &b, side);
            CHECK(active_at_nodes(&a) == active_at_nodes(&b) || same == 1, "nodes: %llu, %llu rays",
                  (unsigned long long)active_at_nodes(&a), (unsigned long long)active_at_nodes(&b));
            CHECK(active_at_triangles(&a) == active_at_triangles(&b) || same == 1,
                  "triangles: %llu, %llu rays", (unsigned long long)active_at_triangles(&a),
                  (unsigned long long)active_at_triangles(&b));
            CHECK(active_at_nodes(&a) >= active_at_nodes(&b), "fewer rays at nodes");
            CHECK(active_at_triangles(&a) >= active_at_triangles(&b), "fewer at triangles");
        }
        structure_close(bph);
    }
}

/* Depth first, by hulls where there are some: packet for packet what its rays meet, and what lies
 * between them. */
static void check_hulls(void) {
    for (unsigned side = 2; side <= 16 && side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        plt_engine *engine = open_engine(side, PLT_ORDER_DEPTH_FIRST);
        built_structure *bph = open_bph(side);
        uint64_t nodes[2] = {0, 0}, triangles[2] = {0, 0}, rays[2] = {0, 0}, out = 0;
        if (engine == NULL || bph == NULL) {
            continue;
        }
        set_rays(1);
        end_before_hits(engine);
        for (uint32_t at = 0; at < RAYS; at += side * side) {
            const structure_statistics a = count_engine(engine, ray + at, side * side);
            const structure_statistics b = count_bph(bph, ray + at, side * side);
            CHECK(a.packets == 1 && b.packets == 1, "no packet");
            CHECK(a.packet_nodes >= b.packet_nodes && a.packet_triangles >= b.packet_triangles,
                  "%ux%u: packet at %u meets less than its rays do", side, side, at);
            rays[0] += active_at_nodes(&a), rays[1] += active_at_nodes(&b);
            nodes[0] += a.packet_nodes, nodes[1] += b.packet_nodes;
            triangles[0] += a.packet_triangles, triangles[1] += b.packet_triangles;
            out += a.masked_at_nodes;
        }
        CHECK(10 * nodes[0] <= 16 * nodes[1], "%ux%u: %llu, %llu nodes", side, side,
              (unsigned long long)nodes[0], (unsigned long long)nodes[1]);
        /* A ray along a box's edge may be in for the BPH alone, which takes two distances. */
        CHECK(1000 * rays[0] >= 998 * rays[1], "%ux%u: %llu, %llu rays", side, side,
              (unsigned long long)rays[0], (unsigned long long)rays[1]);
        CHECK(out > 0 || PLT_WITH_HULLS == 0, "%ux%u: no ray is masked out", side, side);
        CHECK(triangles[0] <= 4 * triangles[1], "%ux%u: %llu, %llu triangles", side, side,
              (unsigned long long)triangles[0], (unsigned long long)triangles[1]);
        structure_close(bph);
    }
}

/* With hits, nearest or any: the traversal is the engine's own. */
static void check_traversal(void) {
    fail f = {""};
    for (unsigned i = 0; i < 32; i++) {
        const unsigned side = 2u << i / 8, order = i & 1, any = i >> 1 & 1, is_wide = i >> 2 & 1;
        plt_engine *engine = side <= PLT_PACKET_SIDE_MAX ? open_engine(side, order) : NULL;
        plt_stats due;
        if (engine == NULL) {
            continue;
        }
        set_rays(1);
        for (uint32_t k = 0; k < RAYS && is_wide; k++) {
            ray[k].dir[0] *= 3.0f;
            ray[k].dir[1] *= 3.0f;
        }
        ray[7].dir[0] = NAN;
        plt_stats_reset(engine);
        plt_trace(engine, ray, hit, RAYS - 3, (int)any);
        plt_stats_get(engine, &due);
        counted_engine *e = counted_engine_open(engine, "knot", &f);
        CHECK(counted_engine_trace(e, ray, again, RAYS - 3, (int)any, &f) == 0, "%s", f.text);
        const structure_statistics s = counted_engine_count(e);
        counted_engine_close(e);
        CHECK(memcmp(hit, again, (RAYS - 3) * sizeof *hit) == 0, "%ux%u, %u: other hits", side,
              side, order);
        CHECK(s.rays == due.rays && s.packets == due.packets && s.node_visits == due.node_visits &&
                  s.box_tests == due.group_tests && s.triangle_tests == due.triangle_tests,
              "%ux%u, %u: other visits", side, side, order);
        CHECK(s.packets - s.one_sign == due.mixed_packets && s.one_sign > 0, "signs");
        CHECK(s.packets > s.one_sign || side == 2, "no packet of mixed signs");
        CHECK(s.packet_nodes <= s.node_visits && s.packet_nodes > 0, "%llu nodes, %llu visits",
              (unsigned long long)s.packet_nodes, (unsigned long long)s.node_visits);
        CHECK(s.packet_triangles <= s.triangle_tests && s.packet_triangles > 0, "triangles");
        CHECK(4 * s.triangle_tests >= active_at_triangles(&s), "more rays than tests have lanes");
        plt_stats now;
        plt_stats_get(engine, &now);
        CHECK(memcmp(&now, &due, sizeof now) == 0, "the engine has counted");
    }
}

static void check_frame(void) {
    const plt_frame frame = {.width = 37, .height = 50, .camera = camera};
    fail f = {""};
    for (unsigned side = 2; side <= 16 && side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        plt_engine *engine = open_engine(side, PLT_ORDER_DEPTH_FIRST);
        counted_engine *e = engine != NULL ? counted_engine_open(engine, "knot", &f) : NULL;
        plt_stats due;
        int status = PLT_MORE;
        if (e == NULL) {
            continue;
        }
        plt_stats_reset(engine);
        CHECK(plt_render_begin(engine, &frame) == PLT_OK, "not begun");
        while (status > PLT_OK) {
            status = plt_render_step(engine, 100000);
        }
        plt_stats_get(engine, &due);
        CHECK(counted_engine_frame(e, &frame, &f) == 0, "%s", f.text);
        const structure_statistics s = counted_engine_count(e);
        CHECK(s.rays == 37 * 50, "%llu rays", (unsigned long long)s.rays);
        CHECK(s.packets == ((37 + side - 1) / side) * ((50 + side - 1) / side), "%llu packets",
              (unsigned long long)s.packets);
        CHECK(PLT_WITH_HULLS == 0 ||
                  (s.node_visits == due.node_visits && s.triangle_tests == due.triangle_tests),
              "%ux%u: %llu visits, not %llu", side, side, (unsigned long long)s.node_visits,
              (unsigned long long)due.node_visits);
        CHECK(s.packet_nodes > 0 && s.packet_nodes <= s.node_visits && s.packet_triangles > 0,
              "no nodes");
        plt_frame dot = frame, wrong = frame;
        dot.width = dot.height = 1;
        CHECK(counted_engine_frame(e, &dot, &f) == 0, "%s", f.text);
        const structure_statistics more = counted_engine_count(e);
        const uint64_t nodes = more.packet_nodes - s.packet_nodes;
        CHECK(more.packets == s.packets + 1 && nodes > 0, "no packet of one ray");
        CHECK(more.rays_at_nodes - s.rays_at_nodes == nodes &&
                  more.masked_at_nodes == s.masked_at_nodes,
              "rays behind the edge are counted");
        wrong.camera.look[0] = NAN;
        CHECK(counted_engine_frame(e, &wrong, &f) == -1, "a camera that is none");
        counted_engine_close(e);
    }
}

/* What blocks of treelets the engine has touched is its own affair. */
static void check_touched(void) {
    fail f = {""};
    uint64_t touched[2];
    set_rays(1);
    for (int counts = 0; counts < 2; counts++) {
        const plt_options options = {.packet_side = 2, .count_touched = 1};
        const plt_source source = {.mapped = image.bytes, .bytes = image.size};
        plt_engine *engine = NULL;
        plt_fault fault;
        plt_stats s;
        CHECK(plt_open(&engine, arena, sizeof arena, &source, &options, &fault) == PLT_OK, "%s",
              fault.message);
        counted_engine *e = counted_engine_open(engine, "knot", &f);
        CHECK(!counts || counted_engine_trace(e, ray, again, RAYS, 0, &f) == 0, "%s", f.text);
        plt_trace(engine, ray, hit, RAYS, 0);
        plt_stats_get(engine, &s);
        touched[counts] = s.bytes_touched_once;
        counted_engine_close(e);
    }
    CHECK(touched[0] > 0 && touched[1] == touched[0], "%llu, %llu bytes",
          (unsigned long long)touched[0], (unsigned long long)touched[1]);
}

/* Rays that are none are no packets; nor has nothing any nodes. */
static void check_nothing(void) {
    fail f = {""};
    plt_engine *engine = open_engine(2, PLT_ORDER_DEPTH_FIRST);
    set_rays(1);
    for (unsigned i = 0; i < 4; i++) {
        ray[i].tmax = -1.0f;
    }
    structure_statistics s = count_engine(engine, ray, 4);
    CHECK(s.rays == 4 && s.packets == 0 && s.packet_nodes == 0, "a packet of no rays");
    s = count_engine(engine, ray, 8);
    CHECK(s.rays == 8 && s.packets == 1, "%llu packets", (unsigned long long)s.packets);
    const uint64_t before = heap_used();
    counted_engine *e = counted_engine_open(engine, "knot", &f);
    heap_limit(heap_used() + 1000);
    CHECK(counted_engine_trace(e, ray, again, 8, 0, &f) == -1, "without memory");
    CHECK(strstr(f.text, "leave out --counts") != NULL, "%s", f.text);
    heap_limit(UINT64_MAX);
    CHECK(counted_engine_trace(e, ray, again, 8, 0, &f) == 0, "not again");
    CHECK(counted_engine_count(e).packets == 1, "after that");
    counted_engine_close(e);
    CHECK(heap_used() == before, "not given back");
}

/* Boxes that are small beside a hull's lanes, and lie in two of them. */
static void check_split(void) {
    fail f = {""};
    mesh_free(&knot);
    pack_free(&image);
    build_knot(20000);
    plt_engine *engine = open_engine(PLT_PACKET_SIDE_MAX, PLT_ORDER_DEPTH_FIRST);
    counted_engine *e = engine != NULL ? counted_engine_open(engine, "knot", &f) : NULL;
    if (e != NULL) {
        const plt_frame frame = {.width = 64, .height = 64, .camera = camera};
        CHECK(counted_engine_frame(e, &frame, &f) == 0, "%s", f.text);
        const structure_statistics s = counted_engine_count(e);
        CHECK(PLT_WITH_HULLS == 0 || s.packet_nodes < s.node_visits, "%llu nodes, %llu visits",
              (unsigned long long)s.packet_nodes, (unsigned long long)s.node_visits);
        CHECK(10 * s.packet_nodes > 9 * s.node_visits, "nodes are lost");
        CHECK(4 * s.triangle_tests >= active_at_triangles(&s), "tests are lost");
    }
    counted_engine_close(e);
}

int main(void) {
    test("the engine and the BPH have the same tree");
    build_knot(rig_is_tiny() ? 40 : TRIANGLES);
    built_structure *bph = open_bph(2);
    const structure_statistics tree = structure_count(bph);
    structure_close(bph);
    CHECK(tree.nodes == image.info.nodes && tree.intermediates == image.info.intermediate_lists &&
              tree.references == image.info.triangles,
          "%u and %u nodes", tree.nodes, image.info.nodes);
    test("group for group packets meet the nodes and triangles of the BPH's, and the same rays do");
    check_groups();
    test("by hulls they meet those and a few between");
    check_hulls();
    test("hits, visits and tests are those of the engine, which does not count them");
    check_traversal();
    check_touched();
    test("packets of a frame are the engine's");
    check_frame();
    test("what is no ray is no packet, and memory that is out is said");
    check_nothing();
    if (!rig_is_tiny()) {
        test("a node that several hulls come to is met once");
        check_split();
    }
    pack_free(&image);
    mesh_free(&knot);
    return test_done();
}
