/* test_wave - incoherent rays by the wave: hits of packets, bit for bit
 *
 * Scenes and rays contain whatever could make a difference: ties, slivers, flat and doubled
 * triangles, triangles without area, huge and tiny scales; rays along axes, at edges and
 * corners, from surfaces and inside boxes, and rays that are none.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "engine/engine.h"
#include "engine/layout.h"
#include "engine/trace/child_order.h"
#include "engine/trace/coherence.h"
#include "engine/trace/wave.h"
#include "engine/trace/wave_state.h"
#include "engine/trace/wide_form.h"
#include "host_tools/scenes/scenes.h"
#include "tests/hostile/images.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/rays.h"
#include "tests/reference/room.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

#if defined(__SANITIZE_ADDRESS__)
enum { EACH = 96 };
#else
enum { EACH = 400 };
#endif
enum { KINDS = 6, RAYS = KINDS * EACH, SCENES = 11 };

static plt_ray rays[RAYS];
static plt_hit expected[2][RAYS]; /* nearest, any */
static uint64_t compared, met;

/* ---- scenes and rays ---------------------------------------------------------------- */

static const char *make(int number, uint32_t k, mesh *m) {
    static const char *const name[SCENES] = {
        "soup",        "small soup", "sheet",   "coincident", "degenerate", "knot",
        "far terrain", "icosphere",  "needles", "huge soup",  "exponential"};
    fail f = {""};
    switch (number) {
    case 0:
        shape_soup(m, rig_triangles(300, k), 0.7f, 1);
        break;
    case 1:
        shape_soup(m, rig_triangles(900, k), 0.02f, 2);
        break;
    case 2:
        shape_sheet(m, rig_is_tiny() ? 7 : 15, (int)k % 3);
        break;
    case 3:
        shape_coincident(m, rig_triangles(40, k) - 2);
        break;
    case 4:
        shape_degenerate(m);
        break;
    case 5:
        scene_knot(m, rig_triangles(900, k), &f);
        break;
    case 6:
        scene_terrain(m, rig_triangles(900, k), &f);
        shape_transform(m, 37.0f, 30.0f, -77.0f, 21.0f);
        break;
    case 7:
        shape_icosphere(m, rig_is_tiny() ? 1 : 2);
        shape_transform(m, 1e-6f, 1e-6f, 0.0f, 1e-7f);
        break;
    case 8:
        shape_needles(m, 13);
        break;
    case 9:
        shape_soup(m, rig_triangles(300, k), 0.3f, 5);
        shape_transform(m, 1e11f, 3e11f, 0.0f, -2e11f);
        break;
    default:
        shape_exponential(m, rig_triangles(100, k));
    }
    return name[number];
}

/* A scene that no limit refuses. */
static const char *make_any(int number, mesh *m) {
    if (rig_is_tiny()) {
        shape_cube(m);
        return "cube";
    }
    return make(number, 2, m);
}

/* From a random point of a triangle, in any direction. */
static void rays_from_surfaces(plt_ray *to, uint32_t count, const mesh *m, random_state *r) {
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t triangle = random_below(r, m->triangles);
        const float u = random_float(r, 0.0f, 0.5f), v = random_float(r, 0.0f, 0.5f);
        float org[3], dir[3];
        for (int a = 0; a < 3; a++) {
            const float p0 = shape_corner(m, triangle, 0)[a], p1 = shape_corner(m, triangle, 1)[a],
                        p2 = shape_corner(m, triangle, 2)[a];
            org[a] = (1.0f - u - v) * p0 + u * p1 + v * p2;
            dir[a] = random_float(r, -1.0f, 1.0f);
        }
        to[i] = ray_make(org, dir, i % 3 == 0 ? 1e-4f : 0.0f, i % 5 == 0 ? 0.5f : RAYS_FAR);
    }
}

/* Makes rays odd: NaN, infinite, out of range, directions of 0, empty intervals. */
static void spoil(plt_ray *to, uint32_t count, random_state *r) {
    static const float odd[] = {NAN,    INFINITY, -INFINITY, 0.0f,  -0.0f,
                                1e-40f, 1e13f,    -1e13f,    1e30f, 1e-30f};
    for (uint32_t i = 0; i < count; i++) {
        float *ray = to[i].org; /* org tmin dir tmax, without gaps */
        if (i % 7 == 0) {
            to[i].tmin = 2.0f;
            to[i].tmax = 1.0f;
            continue;
        }
        for (uint32_t n = 1 + random_below(r, 2); n > 0; n--) {
            ray[random_below(r, 8)] = odd[random_below(r, sizeof odd / sizeof odd[0])];
        }
    }
}

static void set_rays(const mesh *m, uint64_t seed) {
    random_state r = {seed};
    rays_mixed(rays, EACH, m, &r);
    rays_edges(rays + EACH, EACH, m, &r);
    rays_camera(rays + 2 * EACH, EACH, m, &r);
    rays_axis(rays + 3 * EACH, EACH, m, &r);
    rays_from_surfaces(rays + 4 * EACH, EACH, m, &r);
    rays_mixed(rays + 5 * EACH, EACH, m, &r);
    spoil(rays + 5 * EACH, EACH, &r);
    for (uint32_t i = RAYS; i > 1; i--) { /* no two neighbours alike */
        const uint32_t other = random_below(&r, i);
        const plt_ray ray = rays[i - 1];
        rays[i - 1] = rays[other];
        rays[other] = ray;
    }
}

/* ---- a wave against packets ------------------------------------------------------------- */

static void compare(const char *name, int any, const plt_hit *hits, uint32_t count) {
    for (uint32_t i = 0; i < count; i++) {
        const plt_hit *e = &expected[any][i], *h = &hits[i];
        compared++;
        met += e->triangle != PLT_MISS;
        CHECK(memcmp(e, h, sizeof *e) == 0,
              "%s, any %d, ray %u: triangle %u t %a u %a v %a, not triangle %u t %a u %a v %a",
              name, any, i, h->triangle, (double)h->t, (double)h->u, (double)h->v, e->triangle,
              (double)e->t, (double)e->u, (double)e->v);
    }
}

/* Traces all rays, nearest and any hit, and counts that do not fill the wave. */
static void trace(const char *name, plt_engine *engine) {
    static const uint32_t counts[] = {0, 1, 2, 3, 5, 17, 63, RAYS - 1, RAYS};
    static plt_hit hits[RAYS + 1];
    for (int any = 0; any < 2; any++) {
        for (unsigned i = 0; i < sizeof counts / sizeof counts[0]; i++) {
            plt_stats stats;
            memset(hits, 0x55, sizeof hits);
            plt_stats_reset(engine);
            const int status = plt_trace(engine, rays, hits, counts[i], any);
            plt_stats_get(engine, &stats);
            CHECK(status == PLT_OK, "%s: status %d", name, status);
            CHECK(stats.rays == counts[i] && stats.wave_rays == counts[i] && stats.packets == 0,
                  "%s: %llu of %llu rays by the wave", name, (unsigned long long)stats.wave_rays,
                  (unsigned long long)stats.rays);
            CHECK(((const unsigned char *)&hits[counts[i]])[0] == 0x55, "%s: writes beyond", name);
            compare(name, any, hits, counts[i]);
        }
    }
}

static void set_wave(plt_options *run, int wide, uint8_t rays_in_flight) {
    run->wide = (uint8_t)wide;
    run->rays_in_flight = rays_in_flight;
    run->rays = PLT_RAYS_INCOHERENT;
}

static void expect(plt_engine *engine) {
    for (int any = 0; any < 2; any++) {
        memset(expected[any], 0x55, sizeof expected[any]);
        plt_trace(engine, rays, expected[any], RAYS, any);
    }
}

/* ---- workers on one scene ----------------------------------------------------------------- */

enum { WORKERS = 3 };

/* A traversal, a wave and a packet of its own over a scene that all read. */
typedef struct worker {
    plt_engine *engine;
    plt_traversal traversal;
    plt_packet packet;
    void *part[PLT_PARTS_COUNT], *packets;
    plt_hit hits[RAYS];
} worker;

static void worker_open(worker *w, plt_engine *e, plt_options options) {
    plt_layout layout;
    memset(w, 0, sizeof *w);
    w->engine = e;
    plt_layout_set(&layout, &e->scene.info, &e->scene.info, 1, &options);
    w->part[PLT_PART_STACK] = room_get((size_t)layout.bytes[PLT_PART_STACK]);
    w->part[PLT_PART_LEAVES] = room_get((size_t)layout.bytes[PLT_PART_LEAVES]);
    w->part[PLT_PART_FORMAT] = room_get((size_t)layout.bytes[PLT_PART_FORMAT]);
    w->part[PLT_PART_WAVE] = room_get((size_t)layout.bytes[PLT_PART_WAVE]);
    w->packets = room_get(plt_packet_bytes(options.packet_side));
    options.count_touched = 0;
    plt_traversal_init(&w->traversal, &e->scene, &options, w->part);
    plt_packet_init(&w->packet, w->packets, options.packet_side);
    const int wide = e->scene.bvh4 != NULL;
    w->traversal.wave = w->part[PLT_PART_WAVE];
    plt_wave_init(w->traversal.wave, options.rays_in_flight,
                  wide ? PLT_WAVE_BVH4 : plt_wave_tree_of((enum plt_format)e->scene.format),
                  wide ? e->scene.bvh4->depth : e->scene.info.depth_stack_entries);
}

static void worker_close(worker *w) {
    free(w->part[PLT_PART_STACK]);
    free(w->part[PLT_PART_LEAVES]);
    free(w->part[PLT_PART_FORMAT]);
    free(w->part[PLT_PART_WAVE]);
    free(w->packets);
}

static void *work(void *argument) {
    worker *w = argument;
    plt_wave_trace(&w->traversal, &w->packet, 4, 1, rays, w->hits, RAYS, 0);
    return NULL;
}

static void workers_of(const char *name, rig wave, plt_options run) {
    static worker w[WORKERS];
    pthread_t thread[WORKERS];
    for (int i = 0; i < WORKERS && wave.engine != NULL; i++) {
        worker_open(&w[i], wave.engine, run);
    }
    for (int i = 0; i < WORKERS && wave.engine != NULL; i++) {
        pthread_create(&thread[i], NULL, work, &w[i]);
    }
    for (int i = 0; i < WORKERS && wave.engine != NULL; i++) {
        pthread_join(thread[i], NULL);
        plt_trace(wave.engine, rays, expected[0], RAYS, 0);
        compare(name, 0, w[i].hits, RAYS);
        worker_close(&w[i]);
    }
    rig_close(&wave);
}

static void workers(int wide) {
    mesh m = {0};
    rig wave;
    rig_config config = rig_config_of(2, 8, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    const char *name = make_any(0, &m);
    set_wave(&config.run, wide, 16);
    config.run.packet_side = 2;
    set_rays(&m, 3);
    CHECK(rig_open(&wave, &m, &config) == PLT_OK, "%s", wave.fault.message);
    workers_of(name, wave, config.run);
    mesh_free(&m);
}

#if PLT_WITH_WAVE_COMPACT
static void workers_over_compact(void) {
    mesh m = {0};
    rig wave;
    compact_config config = compact_config_of(2, 14, PLT_BUILD_HOST, 0);
    const char *name = make_any(0, &m);
    set_wave(&config.run, 0, 16);
    config.run.packet_side = 2;
    set_rays(&m, 3);
    CHECK(compact_open(&wave, &m, &config) == PLT_OK, "%s", wave.fault.message);
    workers_of(name, wave, config.run);
    mesh_free(&m);
}
#endif

/* ---- the wide form itself ------------------------------------------------------------------ */

static int encloses(const plt_bvh4_node *n, int child, const float p[3]) {
    int inside = 1;
    for (int a = 0; a < 3; a++) {
        inside &= n->plane[a][0][child] <= p[a] && p[a] <= n->plane[a][1][child];
    }
    return inside;
}

typedef struct tree_check {
    const plt_bvh4 *tree;
    const char *name;
    unsigned char *seen; /* per triangle */
    uint32_t triangles, depth;
} tree_check;

/* The blocks that `link` leads to: `path` are the boxes around them. */
static void check_blocks(tree_check *w, uint32_t link, const plt_bvh4_node *const path[],
                         const int child[], uint32_t depth) {
    const plt_bvh4_block *b = plt_bvh4_block_at(plt_bvh4_at(w->tree->nodes, link));
    const uint32_t more = link >> PLT_BVH4_MORE_SHIFT & PLT_BVH4_MORE_MOST;
    for (const plt_bvh4_block *last = b + more; b <= last; b++) {
        CHECK(b >= w->tree->blocks && b < w->tree->blocks + w->tree->blocks_count,
              "%s: a block that is none", w->name);
        for (int lane = 0; lane < 4; lane++) {
            if (b->longest[lane] == -INFINITY) {
                continue;
            }
            w->seen[plt_primitive_id(b->word[lane])]++;
            for (uint32_t d = 0; d < depth; d++) {
                for (int c = 0; c < 3; c++) {
                    const float p[3] = {b->corner[c][0][lane], b->corner[c][1][lane],
                                        b->corner[c][2][lane]};
                    CHECK(encloses(path[d], child[d], p), "%s: a corner is outside", w->name);
                }
            }
        }
    }
}

/* Left to right, without recursion. */
static void check_tree(tree_check *w) {
    const plt_bvh4_node *path[PLT_DEPTH_MAX + 32] = {NULL};
    int child[PLT_DEPTH_MAX + 32] = {0};
    uint32_t depth = 0;
    if (w->tree->root & PLT_BVH4_LEAF) {
        if (w->tree->root != PLT_BVH4_NONE) {
            check_blocks(w, w->tree->root, path, child, 0);
        }
        return;
    }
    path[0] = plt_bvh4_node_at(plt_bvh4_at(w->tree->nodes, w->tree->root));
    child[0] = -1;
    for (depth = 1; depth > 0;) {
        w->depth = depth > w->depth ? depth : w->depth;
        if (++child[depth - 1] == 4) {
            depth--;
            continue;
        }
        const uint32_t link = path[depth - 1]->link[child[depth - 1]];
        if (link == PLT_BVH4_NONE) {
            continue;
        }
        if (link & PLT_BVH4_LEAF) {
            check_blocks(w, link, path, child, depth);
            continue;
        }
        path[depth] = plt_bvh4_node_at(plt_bvh4_at(w->tree->nodes, link));
        child[depth++] = -1;
    }
}

static void check_form(const char *name, const plt_engine *engine, uint32_t source_triangles) {
    const plt_bvh4 *tree = engine->scene.bvh4;
    const plt_info *info = &engine->scene.info;
    CHECK(tree != NULL, "%s: no wide form", name);
    if (tree == NULL) {
        return;
    }
    tree_check w = {tree, name, calloc(source_triangles + 1, 1), 0, 0};
    check_tree(&w);
    uint32_t once = 0;
    for (uint32_t i = 0; i < source_triangles; i++) {
        CHECK(w.seen[i] <= 1, "%s: triangle %u is there %u times", name, i, w.seen[i]);
        once += w.seen[i];
    }
    CHECK(once == info->triangles, "%s: %u of %u triangles", name, once, info->triangles);
    CHECK(w.depth == tree->depth && tree->depth <= plt_wide_depth_bound(info), "%s: depth %u", name,
          tree->depth);
    CHECK(tree->nodes_count <= plt_wide_nodes_bound(info) &&
              tree->blocks_count <= plt_wide_blocks_bound(info),
          "%s: %u nodes, %u blocks", name, tree->nodes_count, tree->blocks_count);
    CHECK((uintptr_t)tree->nodes % PLT_BVH4_ALIGN == 0, "%s: not aligned", name);
    free(w.seen);
}

/* ---- formats ----------------------------------------------------------------------------- */

static void with_thesis(int number, uint32_t k, uint8_t build, int wide) {
    mesh m = {0};
    rig packets, wave;
    const char *name = make(number, k, &m);
    rig_config config = rig_config_of(k, 8, build, (uint8_t)(number & 1));
    set_rays(&m, 100u * (uint64_t)number + k);
    int status = rig_open(&packets, &m, &config);
    set_wave(&config.run, wide, (uint8_t)(PLT_WAVE_LEAST + 7 * number % 48));
    const int other = rig_open(&wave, &m, &config);
    CHECK(status == other, "%s, %s: %d and %d, %s", name, rig_name(&config), status, other,
          wave.fault.message);
    CHECK(status == PLT_OK || (rig_is_tiny() && status == PLT_ERR_LIMIT), "%s: %s", name,
          packets.fault.message);
    if (status == PLT_OK && other == PLT_OK) {
        expect(packets.engine);
        trace(name, wave.engine);
        if (wide) {
            check_form(name, wave.engine, m.triangles);
        }
    }
    rig_close(&packets);
    rig_close(&wave);
    mesh_free(&m);
}

static void with_compact(int number, uint32_t k, uint8_t bits, int floats, int numbers,
                         uint8_t build, int wide) {
    mesh m = {0};
    rig packets, wave;
    const char *name = make(number, k, &m);
    compact_config config = compact_config_of(k, bits, build, (uint8_t)(number & 1));
    config.pack.floats = (uint8_t)floats;
    config.pack.numbers = (uint8_t)numbers;
    set_rays(&m, 100u * (uint64_t)number + k);
    const int status = compact_open(&packets, &m, &config);
    set_wave(&config.run, wide, wide ? 32 : (uint8_t)(PLT_WAVE_LEAST + 7 * number % 48));
    const int other = compact_open(&wave, &m, &config);
    CHECK(status == other, "%s, %s: %d and %d, %s", name, compact_name(&config), status, other,
          wave.fault.message);
    if (status == PLT_OK && other == PLT_OK) {
        expect(packets.engine);
        trace(name, wave.engine);
        if (wide) {
            check_form(name, wave.engine, m.triangles);
        }
    }
    rig_close(&packets);
    rig_close(&wave);
    mesh_free(&m);
}

/* ---- properties -------------------------------------------------------------------------- */

static void wide_over_thesis(void) {
    for (int scene = 0; scene < SCENES; scene++) {
        for (uint32_t k = 1; k <= 4; k *= 2) {
            with_thesis(scene, k, PLT_BUILD_HOST, 1);
        }
        with_thesis(scene, 2, PLT_BUILD_DEVICE, 1);
    }
}

static void over_thesis(void) {
    for (int scene = 0; scene < SCENES; scene++) {
        for (uint32_t k = 1; k <= 4; k *= 2) {
            with_thesis(scene, k, PLT_BUILD_HOST, 0);
        }
        with_thesis(scene, 2, PLT_BUILD_DEVICE, 0);
    }
    with_thesis(0, 33, PLT_BUILD_HOST, 0);
    with_thesis(1, 700, PLT_BUILD_HOST, 0);
}

static void wide_over_compact(void) {
    for (int scene = 0; scene < 9; scene++) {
        with_compact(scene, 2, 14, 0, 1, PLT_BUILD_HOST, 1);
        with_compact(scene, 4, 21, 0, 0, PLT_BUILD_HOST, 1);
        with_compact(scene, 1, 12, 1, 1, PLT_BUILD_HOST, 1);
    }
}

#if PLT_WITH_WAVE_COMPACT
/* Strips with ids and without, records; bounds of 12 bytes and of 16. */
static void over_compact(void) {
    for (int scene = 0; scene < 9; scene++) {
        for (uint32_t k = 1; k <= 4; k *= 2) {
            with_compact(scene, k, 14, 0, 1, PLT_BUILD_HOST, 0);
            with_compact(scene, k, 21, 1, 1, PLT_BUILD_HOST, 0);
        }
        with_compact(scene, 4, 21, 0, 0, PLT_BUILD_HOST, 0);
        with_compact(scene, 1, 12, 1, 0, PLT_BUILD_HOST, 0);
        with_compact(scene, 2, 16, 0, 1, PLT_BUILD_DEVICE, 0);
    }
}
#endif

/* Lists as long as there are triangles: runs of blocks, and leaves too long for a link. */
static void long_lists(void) {
    static const uint32_t lengths[] = {3, 9, 33, 130, 700};
    for (unsigned i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        with_thesis(0, lengths[i], PLT_BUILD_HOST, 1);
        with_thesis(1, lengths[i], PLT_BUILD_HOST, 1);
    }
}

/* An image that is fetched, in an arena of exactly its need. */
static void fetched(void) {
    mesh m = {0};
    rig mapped;
    const rig_config config = rig_config_of(2, 8, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    const char *name = make_any(5, &m);
    set_rays(&m, 77);
    CHECK(rig_open(&mapped, &m, &config) == PLT_OK, "%s", mapped.fault.message);
    if (mapped.engine != NULL) {
        hostile_stream stream = {mapped.image.bytes, mapped.image.size, 0};
        const plt_source source = {NULL, mapped.image.size, &stream, hostile_start, hostile_wait};
        plt_options options = config.run;
        plt_engine *engine;
        plt_fault fault;
        set_wave(&options, 1, 24);
        expect(mapped.engine);
        const size_t need = plt_arena_need(&mapped.image.info, 0, &options);
        void *arena = aligned_alloc(PLT_ALIGN, need);
        CHECK(plt_open(&engine, arena, need, &source, &options, &fault) == PLT_OK, "%s",
              fault.message);
        if (engine != NULL) {
            trace(name, engine);
        }
        CHECK(plt_open(&engine, arena, need - PLT_ALIGN, &source, &options, &fault) ==
                      PLT_ERR_ARENA &&
                  fault.need_bytes == need,
              "an arena too small: %s, %zu", fault.message, fault.need_bytes);
        free(arena);
    }
    rig_close(&mapped);
    mesh_free(&m);
}

/* Scenes of no triangles, and lists without a tree: packets serve. */
static void nothing_to_widen(void) {
    mesh m = {0}, none = {0};
    rig list, empty;
    rig_config config = rig_config_of(2, 8, PLT_BUILD_NONE, PLT_SPLIT_SAH);
    plt_hit hit;
    shape_cube(&m);
    set_wave(&config.run, 1, 32);
    const plt_ray ray = {{0, 0, -3}, 0, {0, 0.1f, 1}, 100};
    CHECK(rig_open(&list, &m, &config) == PLT_OK, "%s", list.fault.message);
    if (list.engine != NULL) {
        CHECK(plt_trace(list.engine, &ray, &hit, 1, 0) == PLT_OK && hit.triangle != PLT_MISS,
              "a list is not hit");
    }
    config.pack.build = PLT_BUILD_HOST;
    CHECK(rig_open(&empty, &none, &config) == PLT_OK, "%s", empty.fault.message);
    if (empty.engine != NULL) {
        CHECK(plt_trace(empty.engine, &ray, &hit, 1, 0) == PLT_OK && hit.triangle == PLT_MISS,
              "nothing is hit");
    }
    rig_close(&list);
    rig_close(&empty);
    compact_config blocks = compact_config_of(2, 14, PLT_BUILD_HOST, 0);
    for (int wide = 0; wide < 2; wide++) {
        set_wave(&blocks.run, wide, 32);
        CHECK(compact_open(&empty, &none, &blocks) == PLT_OK, "%s", empty.fault.message);
        if (empty.engine != NULL) {
            hit.triangle = 0;
            CHECK(plt_trace(empty.engine, &ray, &hit, 1, 0) == PLT_OK && hit.triangle == PLT_MISS,
                  "nothing is hit in blocks, wide %d", wide);
        }
        rig_close(&empty);
    }
    mesh_free(&m);
}

/* A single triangle is in both leaves of its block; an arena for less than the worst tree is
 * enough, or refused. */
static void one_triangle_anywhere(void) {
    compact_config config = compact_config_of(2, 12, PLT_BUILD_DEVICE, 0);
    const plt_ray ray = {{0, 0, -3}, 0, {0, 0, 1}, 100};
    uint32_t opened = 0, refused = 0;
    mesh m = {0};
    shape_soup(&m, 1, 0.5f, 1);
    set_wave(&config.run, 1, 64);
    packed image = compact_packed(&m, &config);
    const plt_source source = rig_source(&image);
    const size_t need = plt_arena_need(&image.info, 1, &config.run);
    unsigned char *arena = aligned_alloc(64, (need / 64 + 2) * 64);
    for (size_t shift = 0; shift < 64 && arena != NULL && image.bytes != NULL; shift += 16) {
        for (size_t bytes = 16; bytes <= need; bytes += bytes < need / 2 ? 16 : 4096) {
            plt_engine *engine;
            plt_fault fault;
            plt_hit hit;
            const int status =
                plt_open(&engine, arena + shift, bytes, &source, &config.run, &fault);
            opened += status == PLT_OK;
            refused += status == PLT_ERR_ARENA;
            CHECK(status == PLT_OK || status == PLT_ERR_ARENA, "%zu bytes: %s", bytes,
                  fault.message);
            if (status == PLT_OK) {
                plt_trace(engine, &ray, &hit, 1, 0);
            }
        }
    }
    CHECK(opened > 0 && refused > 0, "%u opened, %u refused", opened, refused);
    free(arena);
    pack_free(&image);
}

/* ---- which rays go which way ------------------------------------------------------------- */

/* From one point, within a cone: a beam. */
static void rays_beam(plt_ray *to, uint32_t count, float spread, random_state *r) {
    for (uint32_t i = 0; i < count; i++) {
        const float org[3] = {0.0f, 0.0f, -4.0f};
        const float dir[3] = {random_float(r, -spread, spread), random_float(r, -spread, spread),
                              1.0f};
        to[i] = ray_make(org, dir, 0.0f, RAYS_FAR);
    }
}

/* Windows of beams and of others in turn, `beams` of `of` in all; the last is cut short. */
static uint32_t mix(uint32_t beams, uint32_t of, const mesh *m, uint32_t *coherent) {
    const uint32_t window = PLT_COHERENCE_WINDOW; /* no packet of a rig is larger */
    random_state r = {11};
    uint32_t count = 0;
    *coherent = 0;
    for (uint32_t i = 0; count + window + 5 <= RAYS; i++) {
        const uint32_t now = count + 2 * window + 5 <= RAYS ? window : window - 3;
        if (i % of < beams) {
            rays_beam(rays + count, now, 0.01f, &r);
            *coherent += now;
        } else {
            rays_random(rays + count, now, m, &r);
        }
        count += now;
    }
    return count;
}

static void by_their_looks(void) {
    static plt_hit hits[RAYS];
    mesh m = {0};
    rig packets, wave;
    rig_config config = rig_config_of(2, 8, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    const char *name = make_any(0, &m);
    CHECK(rig_open(&packets, &m, &config) == PLT_OK, "%s", packets.fault.message);
    set_wave(&config.run, 1, 32);
    config.run.rays = PLT_RAYS_AUTO;
    CHECK(rig_open(&wave, &m, &config) == PLT_OK, "%s", wave.fault.message);
    for (uint32_t of = 1; of <= 4 && packets.engine != NULL && wave.engine != NULL; of++) {
        for (uint32_t beams = 0; beams <= of; beams++) {
            uint32_t coherent;
            plt_stats stats;
            const uint32_t count = mix(beams, of, &m, &coherent);
            for (int any = 0; any < 2; any++) {
                memset(hits, 0x55, sizeof hits);
                plt_trace(packets.engine, rays, expected[any], count, any);
                plt_stats_reset(wave.engine);
                plt_trace(wave.engine, rays, hits, count, any);
                plt_stats_get(wave.engine, &stats);
                compare(name, any, hits, count);
                CHECK(stats.rays == count && stats.wave_rays == count - coherent,
                      "%u of %u beams: %u of %u rays are coherent, %llu went by the wave", beams,
                      of, coherent, count, (unsigned long long)stats.wave_rays);
            }
        }
    }
    rig_close(&packets);
    rig_close(&wave);
    mesh_free(&m);
}

/* ---- where packets are dense ------------------------------------------------------------- */

/* Packets of 2x2 are dense above 2.75 * 2.1 visits per ray; a window counts as twice that at most.
 */
enum { WINDOW = 64, WINDOWS = 220, DENSE = 12, PACKETS = WINDOW / 4 };

static plt_ray many[2][WINDOWS * WINDOW]; /* dense; those that visit the root at most */

static void set_many(void) {
    random_state r = {7};
    for (int coarse = 0; coarse < 2; coarse++) {
        for (uint32_t i = 0; i < WINDOWS * WINDOW; i++) {
            const float org[3] = {0.0f, 0.0f, -4.0f};
            const float dir[3] = {random_float(&r, -0.2f, 0.2f), random_float(&r, -0.2f, 0.2f),
                                  coarse ? -1.0f : 1.0f};
            many[coarse][i] = ray_make(org, dir, 0.0f, RAYS_FAR);
        }
    }
}

/* Traces `calls` times `count` rays: so many packets, and so many rays by the wave. */
static void expect_ways_of(plt_engine *e, const char *what, int coarse, uint32_t calls,
                           uint32_t count, uint64_t packets, uint64_t wave_rays, int any) {
    static plt_hit hits[WINDOWS * WINDOW];
    plt_stats s;
    plt_stats_reset(e);
    for (uint32_t i = 0; i < calls; i++) {
        plt_trace(e, many[coarse] + i * count, hits, count, any);
    }
    plt_stats_get(e, &s);
    CHECK(s.packets == packets && s.wave_rays == wave_rays && s.rays == (uint64_t)calls * count,
          "%s: %llu packets and %llu rays by the wave, not %llu and %llu", what,
          (unsigned long long)s.packets, (unsigned long long)s.wave_rays,
          (unsigned long long)packets, (unsigned long long)wave_rays);
    CHECK(wave_rays > 0 || (coarse ? s.node_visits == (PLT_WITH_HULLS ? packets : 0)
                                   : any || s.node_visits > DENSE * s.rays),
          "%s: %llu visits", what, (unsigned long long)s.node_visits);
}

static void expect_ways(plt_engine *e, const char *what, int coarse, uint32_t calls, uint32_t count,
                        uint64_t packets, uint64_t wave_rays) {
    expect_ways_of(e, what, coarse, calls, count, packets, wave_rays, 0);
}

static void open_dense(rig *r) {
    mesh m = {0};
    rig_config config = rig_config_of(2, 8, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    shape_soup(&m, 20000, 0.05f, 3);
    set_wave(&config.run, 1, 32);
    config.run.packet_side = 2;
    config.run.rays = PLT_RAYS_AUTO;
    CHECK(rig_open(r, &m, &config) == PLT_OK, "%s", r->fault.message);
    mesh_free(&m);
}

/* The average is 2 - 2^(1 - n) times the limit after n dense windows: above it for n >= 2. Then one
 * window goes by the wave, and if the next is dense 3, then 7, 15, 31, 63. After 7 dense ones it is
 * 1.98. A coarse window ends a run, but for the first of a call: by the wave it visits less than
 * two nodes per ray. One in packets makes that 0.99, and by hulls, where it visits the root, 1.01:
 * one run more, of one window. */
static void dense_windows(void) {
    const uint32_t by_wave = PLT_WITH_HULLS ? 3 : 2;
    rig r;
    open_dense(&r);
    if (r.engine != NULL) {
        expect_ways(r.engine, "dense", 0, 1, 3 * WINDOW, 2 * PACKETS, WINDOW);
        expect_ways_of(r.engine, "any hits have their own", 1, 1, 9 * WINDOW, 9 * PACKETS, 0, 1);
        expect_ways(r.engine, "still", 0, 1, 64 * WINDOW, 5 * PACKETS, 59 * WINDOW);
        expect_ways(r.engine, "coarse", 1, 1, 220 * WINDOW, (220 - by_wave) * PACKETS,
                    by_wave * WINDOW);
        expect_ways(r.engine, "still", 1, 1, 100 * WINDOW, 100 * PACKETS, 0);
    }
    rig_close(&r);
}

/* 64 calls of one ray count as a window, and take as much of those that go by the wave. */
static void short_windows(void) {
    rig r;
    open_dense(&r);
    if (r.engine != NULL) {
        expect_ways(r.engine, "single rays", 0, 40, 1, 40, 0);
        expect_ways(r.engine, "packets stay", 1, 1, 100 * WINDOW, 100 * PACKETS, 0);
    }
    rig_close(&r);
    open_dense(&r);
    if (r.engine != NULL) {
        expect_ways(r.engine, "a window of them", 0, WINDOW, 1, WINDOW, 0);
        expect_ways(r.engine, "another", 0, 1, WINDOW, PACKETS, 0);
        expect_ways(r.engine, "half a window", 0, WINDOW / 2, 1, 0, WINDOW / 2);
        expect_ways(r.engine, "the rest, and three", 0, 1, 5 * WINDOW, PACKETS, 4 * WINDOW);
    }
    rig_close(&r);
}

/* Beams of any width and length, and with rays in them that are none. */
static void beams(void) {
    const plt_box scene = {{-1, -1, -1}, {1, 1, 1}};
    random_state r = {5};
    for (int power = -60; power <= 60; power += 12) {
        const float length = ldexpf(1.0f, power);
        for (int wide = 0; wide < 2; wide++) {
            rays_beam(rays, 64, wide ? 1.0f : 0.1f, &r);
            for (uint32_t i = 0; i < 64; i++) {
                for (int a = 0; a < 3; a++) {
                    rays[i].dir[a] *= length;
                }
            }
            CHECK(plt_rays_are_coherent(rays, 64, &scene) == !wide, "2^%d, wide %d", power, wide);
        }
    }
    rays_beam(rays, 64, 0.1f, &r);
    rays[3].org[1] = rays[9].dir[0] = rays[11].tmin = NAN;
    rays[12].tmax = rays[13].tmax = INFINITY;
    CHECK(plt_rays_are_coherent(rays, 64, &scene), "what is not a number counts");
    CHECK(plt_rays_are_coherent(rays, 1, &scene), "a single ray");
    rays[5].dir[0] = INFINITY; /* 0 * infinity, of one origin */
    CHECK(!plt_rays_are_coherent(rays, 64, &scene), "an infinite direction from one origin");
    rays[5].dir[0] = 0.1f;
    rays[5].org[2] += 3.0f;
    CHECK(!plt_rays_are_coherent(rays, 64, &scene), "an origin elsewhere does not");
}

static void options_refused(void) {
    static const struct {
        uint8_t rays_in_flight, wide, rays;
        int valid;
    } cases[] = {{0, 0, 0, 1},  {0, 1, 0, 0},  {15, 0, 0, 0}, {16, 0, 0, 1}, {64, 1, 2, 1},
                 {65, 0, 0, 0}, {32, 2, 0, 0}, {32, 1, 3, 0}, {0, 0, 2, 1}};
    mesh m = {0};
    rig r;
    rig_config config = rig_config_of(2, 8, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    shape_cube(&m);
    CHECK(rig_open(&r, &m, &config) == PLT_OK, "%s", r.fault.message);
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        plt_options o = config.run;
        o.rays_in_flight = cases[i].rays_in_flight;
        o.wide = cases[i].wide;
        o.rays = cases[i].rays;
        CHECK((plt_arena_need(&r.image.info, 1, &o) > 0) == cases[i].valid, "case %u", i);
    }
    rig_close(&r);
    mesh_free(&m);
}

/* The widest form that its links must reach, and one triangle more. */
static void too_large(void) {
    static const uint8_t builds[2] = {PLT_BUILD_HOST, PLT_BUILD_DEVICE};
    for (int i = 0; i < 2; i++) {
        plt_options with = {.packet_side = 2, .rays_in_flight = 16, .wide = 1}, without = with;
        plt_info info = {.triangles = PLT_WIDE_TRIANGLES_MOST,
                         .leaf_triangles = i == 0 ? 1 : 1000,
                         .treelet_nodes = 64,
                         .depth_stack_entries = PLT_DEPTH_MAX,
                         .build = builds[i]};
        info.nodes = info.node_slots = info.triangles - 1;
        info.leaf_lists = info.triangles;
        without.wide = 0;
        const uint64_t bytes = plt_wide_bytes(&info);
        CHECK(bytes < 0x100000000u, "%llu bytes", (unsigned long long)bytes);
        CHECK(plt_arena_need(&info, 1, &with) > plt_arena_need(&info, 1, &without) + bytes / 2,
              "it has a wide form");
        info.triangles++;
        CHECK(plt_arena_need(&info, 1, &with) == plt_arena_need(&info, 1, &without), "it has none");
    }
}

/* Every order of four numbers, with every tie. */
static void every_order(void) {
    for (unsigned i = 0; i < 256; i++) {
        const float v[4] = {(float)(i & 3) - 1, (float)(i >> 2 & 3) - 1, (float)(i >> 4 & 3) - 1,
                            (float)(i >> 6) - 1};
        const uint8_t *place = plt_child_orders.descending[plt_descending(f4_load(v))];
        float sorted[4] = {NAN, NAN, NAN, NAN};
        for (unsigned lane = 0; lane < 4; lane++) {
            sorted[place[lane]] = v[lane];
        }
        CHECK(sorted[0] >= sorted[1] && sorted[1] >= sorted[2] && sorted[2] >= sorted[3],
              "%g %g %g %g", (double)v[0], (double)v[1], (double)v[2], (double)v[3]);
    }
    for (unsigned i = 0; i < 16; i++) {
        CHECK(plt_child_orders.ones_less_one[i] + 1 ==
                  (int)((i & 1) + (i >> 1 & 1) + (i >> 2 & 1) + (i >> 3)),
              "%u", i);
    }
}

int main(void) {
    test("four numbers are sorted by their comparisons, with every tie");
    every_order();
    test("options of the wave out of their range are refused");
    options_refused();
    test("a wide form is no larger than its links reach");
    too_large();
    test("beams are told from other rays, however long");
    beams();
    test("windows of coherent rays go in packets, all others by the wave, and hits are the same");
    by_their_looks();
    if (!rig_is_tiny()) {
        set_many();
        test("where packets are dense a window is tried now and then, until they are coarse again");
        dense_windows();
        test("... short windows count by their rays");
        short_windows();
    }
    test("over thesis nodes the wave has the hits of packets, bit for bit");
    over_thesis();
    test("the wide form of thesis nodes is a tree of all triangles; hits are those of packets");
    wide_over_thesis();
    test("a single triangle has one in any arena that holds it");
    one_triangle_anywhere();
    test("so is that of compact blocks, of strips and of records");
    wide_over_compact();
#if PLT_WITH_WAVE_COMPACT
    test("over compact blocks as they are the wave has the hits of packets, bit for bit");
    over_compact();
    workers_over_compact();
#endif
    test("and lists of any length");
    long_lists();
    test("an image that is fetched has the same hits, in exactly its need, and no less");
    fetched();
    test("workers on one scene, each with a wave of its own, have the same hits");
    workers(1);
    workers(0);
    test("what has no tree is traced all the same");
    nothing_to_widen();
    CHECK(met > compared / 10, "hardly any hit");
    printf("    %llu hits compared, %llu of them of triangles\n", (unsigned long long)compared,
           (unsigned long long)met);
    return test_done();
}
