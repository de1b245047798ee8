/* test_compact_build - what the builder of compact blocks promises of every tree
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "engine/builder/blocks.h"
#include "engine/engine.h"
#include "engine/scene/worst_tree.h"
#include "host_tools/pack/lattice_snap.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/compact_check.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/random.h"
#include "tests/reference/room.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { SCENES = 9, GUARD = 64, PATTERN = 0xC3 };

static uint32_t deepest, closed_early;

static mesh make(int scene) {
    mesh m = {0};
    fail f = {""};
    switch (scene) {
    case 0:
        shape_soup(&m, compact_triangles(900, 1), 1.5f, 3); /* hardly any shared vertex */
        break;
    case 1:
        shape_soup(&m, compact_triangles(1500, 1), 0.003f, 4); /* tiny */
        break;
    case 2:
    case 3:
        shape_sheet(&m, rig_is_tiny() ? 7 : 17, scene - 1);
        break;
    case 4:
        shape_coincident(&m, compact_triangles(300, 1) - 2);
        break;
    case 5:
        shape_degenerate(&m);
        break;
    case 6:
        shape_exponential(&m, compact_triangles(300, 1));
        break;
    case 7:
        scene_knot(&m, compact_triangles(4000, 1), &f);
        break;
    default:
        scene_terrain(&m, compact_triangles(4000, 1), &f);
    }
    return m;
}

/* ---- trees ---------------------------------------------------------------------- */

static void look(const rig *r, const snapped *s, const char *name) {
    const plt_block_tree *tree = compact_tree(r);
    const compact_facts f = compact_check(tree, s);
    const plt_info *i = plt_engine_info(r->engine);
    CHECK(f.broken == 0, "%s, %u triangles: %s (%u times)", name, s->count, f.sentence, f.broken);
    CHECK(f.longest_leaf <= 2 * i->leaf_triangles, "%s: a leaf of %u", name, f.longest_leaf);
    CHECK(f.depth <= PLT_DEPTH_MAX && f.depth == i->depth_stack_entries,
          "%s: depth %u, reported %u", name, f.depth, i->depth_stack_entries);
    CHECK(f.nodes == i->nodes && f.blocks == i->treelets && f.pairs == i->intermediate_lists &&
              f.leaves - f.pairs == i->leaf_lists,
          "%s: %u nodes, %u blocks, %u leaves", name, f.nodes, f.blocks, f.leaves);
    CHECK(i->node_bytes + i->triangle_bytes == tree->used, "%s: bytes", name);
    deepest = f.depth > deepest ? f.depth : deepest;
    closed_early += f.most_vertices > 600;
}

static void build_and_look(const mesh *m, const char *scene, compact_config config) {
    snapped s;
    fail f = {""};
    char name[128];
    CHECK(lattice_snap(&s, m, config.pack.lattice_bits, "test", &f) == 0, "%s", f.text);
    for (uint8_t build = PLT_BUILD_HOST; build <= PLT_BUILD_DEVICE; build++) {
        rig r;
        config.pack.build = build;
        snprintf(name, sizeof name, "%s, %s", scene, compact_name(&config));
        const int status = compact_open(&r, m, &config);
        CHECK(status == PLT_OK, "%s: %s", name, r.fault.message);
        if (status == PLT_OK) {
            look(&r, &s, name);
        }
        rig_close(&r);
    }
    snapped_free(&s);
}

static void every_scene(void) {
    static const uint8_t bits[5] = {12, 14, 16, 17, 21};
    for (int scene = 0; scene < SCENES; scene++) {
        mesh m = make(scene);
        char name[16];
        snprintf(name, sizeof name, "scene %d", scene);
        for (uint32_t i = 0; i < 15; i++) {
            build_and_look(
                &m, name, compact_config_of(1u << i % 3, bits[i / 3], PLT_BUILD_HOST, (i / 3) & 1));
        }
        mesh_free(&m);
    }
    CHECK(rig_is_tiny() || closed_early > 0, "no block ran out of vertices");
}

static void few_triangles(void) {
    for (uint32_t count = 0; count <= 40; count++) {
        mesh m = {0};
        char name[24];
        shape_soup(&m, count, 0.5f, count);
        snprintf(name, sizeof name, "%u in a soup", count);
        for (uint32_t k = 1; k <= 4; k *= 2) {
            build_and_look(&m, name, compact_config_of(k, 14, PLT_BUILD_HOST, PLT_SPLIT_SAH));
            build_and_look(&m, name, compact_config_of(k, 21, PLT_BUILD_HOST, PLT_SPLIT_MEDIAN));
        }
        mesh_free(&m);
    }
}

/* ---- jobs for the builder alone -------------------------------------------------- */

typedef struct work {
    plt_blocks_job job;
    unsigned char *corners;
    uint32_t steps;
    int status;
} work;

/* Triangles with corners on `range` coordinates of each axis: many share a centre. */
static work random_work(uint64_t seed, uint32_t k, uint32_t most) {
    random_state r = {seed};
    static const uint32_t bits[5] = {12, 14, 16, 17, 21};
    const uint32_t b = bits[random_below(&r, 5)], n = 1 + random_below(&r, most);
    const uint32_t range = random_below(&r, 2) ? 8u << random_below(&r, 5) : 1u << b;
    work w = {.job = {.triangles = {NULL, n, plt_corner_width(b), 0},
                      .bits = b,
                      .leaf_triangles = k,
                      .splits = (uint8_t)random_below(&r, 2)}};
    w.corners = malloc((size_t)n * 9 * w.job.triangles.width);
    w.job.triangles.bytes = w.corners;
    unsigned char *at = w.corners;
    for (uint32_t i = 0; i < 9 * n; i++, at += w.job.triangles.width) {
        const uint32_t q = random_below(&r, range);
        if (w.job.triangles.width == 2) {
            at[0] = (unsigned char)q;
            at[1] = (unsigned char)(q >> 8);
        } else {
            plt_put_u32(at, q);
        }
    }
    return w;
}

/* Builds in `bytes` of memory that has guards on both sides. */
static void run(work *w, size_t bytes, unsigned char **memory) {
    unsigned char *zone = aligned_alloc(16, (bytes + 2 * GUARD + 15) / 16 * 16);
    memset(zone, PATTERN, bytes + 2 * GUARD);
    w->job.memory = zone + GUARD;
    w->job.bytes = bytes;
    w->job.scratch = room_get(plt_blocks_scratch_bytes(w->job.triangles.count));
    w->steps = 0;
    w->status = plt_blocks_begin(&w->job);
    w->status = w->status == PLT_OK ? PLT_MORE : w->status;
    while (w->status == PLT_MORE) {
        w->status = plt_blocks_step(&w->job);
        w->steps++;
    }
    int whole = 1;
    for (int i = 0; i < GUARD; i++) {
        whole &= zone[i] == PATTERN && zone[GUARD + bytes + (size_t)i] == PATTERN;
    }
    CHECK(whole, "bytes around the memory were written");
    free(w->job.scratch);
    memmove(zone, zone + GUARD, bytes);
    *memory = zone;
}

static size_t bound_of(const plt_blocks_job *job) {
    const plt_info info = {.triangles = job->triangles.count,
                           .treelet_nodes = PLT_BLOCK_NODES_MOST,
                           .leaf_triangles = job->leaf_triangles,
                           .lattice_bits = (uint8_t)job->bits,
                           .nodes_format = PLT_NODES_COMPACT,
                           .geometry_format = PLT_GEOMETRY_LATTICE,
                           .build = PLT_BUILD_DEVICE};
    const plt_info worst = plt_worst_tree(&info);
    return (size_t)worst.node_bytes + worst.triangle_bytes;
}

/* The tree's counts are those of its blocks, also where blocks were restarted; memory and steps
 * stay within their bounds. */
static void check_work(work *w, uint64_t seed) {
    unsigned char *memory;
    const size_t bound = bound_of(&w->job);
    run(w, bound, &memory);
    CHECK(w->status == PLT_OK, "seed %llu: status %d", (unsigned long long)seed, w->status);
    if (w->status == PLT_OK) {
        const plt_block_tree tree = {.bytes = memory,
                                     .used = w->job.used,
                                     .root = w->job.root,
                                     .leaf_triangles = w->job.leaf_triangles,
                                     .leaf_kind = PLT_LEAF_STRIPS,
                                     .lattice = {{0, 0, 0}, 1, w->job.bits},
                                     .box = w->job.box};
        const snapped s = {.corners = w->corners,
                           .width = w->job.triangles.width,
                           .count = w->job.triangles.count};
        const compact_facts f = compact_check(&tree, &s);
        CHECK(f.broken == 0, "seed %llu: %s", (unsigned long long)seed, f.sentence);
        CHECK(f.depth == w->job.depth && f.nodes == w->job.nodes && f.blocks == w->job.blocks &&
                  f.leaves == w->job.leaves && f.pairs == w->job.pairs,
              "seed %llu: depth %u, reported %u", (unsigned long long)seed, f.depth, w->job.depth);
        const size_t permutation = w->job.triangles.count * 2u;
        CHECK(w->job.peak <= bound && w->job.peak >= w->job.used &&
                  (w->job.peak <= (size_t)w->job.used + f.largest_block ||
                   w->job.peak == permutation),
              "seed %llu: peak %zu, used %u, largest block %u", (unsigned long long)seed,
              w->job.peak, w->job.used, f.largest_block);
        /* One split or one block per step, one check per block; a block with too many vertices
         * is restarted, with half the nodes each time. */
        CHECK(w->steps >= w->job.nodes + 2 * w->job.blocks &&
                  w->steps <= 3 * w->job.nodes + 9 * w->job.blocks,
              "seed %llu: %u steps for %u nodes in %u blocks", (unsigned long long)seed, w->steps,
              w->job.nodes, w->job.blocks);
    }
    free(memory);
}

static void random_soups(void) {
    for (uint64_t seed = 1; seed <= 300; seed++) {
        const uint32_t k = 1u << seed % 3, most = seed % 5 == 0 ? 2000 : 400;
        work w = random_work(seed, k, compact_triangles(most, k));
        check_work(&w, seed);
        free(w.corners);
    }
}

/* Memory of every size up to the bound: a build succeeds or is refused, and more memory never
 * makes it fail. */
static void short_of_memory(uint32_t k, uint64_t seed) {
    work w = random_work(seed, k, 60);
    const size_t bound = bound_of(&w.job);
    int built = 0, refused = 0;
    for (size_t bytes = 0; bytes <= bound; bytes += 8) {
        unsigned char *memory;
        run(&w, bytes, &memory);
        CHECK(w.status == PLT_OK || w.status == PLT_ERR_ARENA, "%zu bytes: status %d", bytes,
              w.status);
        CHECK(w.status == PLT_OK || !built, "%zu bytes are refused, fewer were enough", bytes);
        CHECK(w.status != PLT_OK || w.job.peak <= bytes, "peak %zu of %zu", w.job.peak, bytes);
        built += w.status == PLT_OK;
        refused += w.status != PLT_OK;
        free(memory);
    }
    CHECK(built > 0 && refused > 0, "%d built, %d refused", built, refused);
    free(w.corners);
}

/* Halving by count fills all levels: leaves of two below the last nodes. */
static void depth_limit(void) {
    const uint32_t most = rig_is_tiny() ? 2u << PLT_DEPTH_MAX % 31 : 600;
    for (uint32_t count = most / 2; count <= 2 * most; count += most / 2) {
        mesh m = {0};
        rig r;
        const compact_config config = compact_config_of(1, 21, PLT_BUILD_HOST, PLT_SPLIT_MEDIAN);
        shape_coincident(&m, count - 2);
        const int status = compact_open(&r, &m, &config);
        const int fits = !rig_is_tiny() || count <= most;
        CHECK(status == (fits ? PLT_OK : PLT_ERR_LIMIT), "%u triangles: status %d", count, status);
        rig_close(&r);
        compact_config device = config;
        device.pack.build = PLT_BUILD_DEVICE;
        CHECK(compact_open(&r, &m, &device) == status, "%u triangles on the device", count);
        rig_close(&r);
        mesh_free(&m);
    }
}

int main(void) {
    test(
        "each triangle once, boxes and bounds that contain it, leaves of at most 2 K, correct "
        "counts");
    every_scene();
    test("the same for 0 to 40 triangles");
    few_triangles();
    test("the same for corners with many ties; peak and steps within their bounds");
    random_soups();
    test("in memory of any size blocks are built or refused, and nothing else is written");
    short_of_memory(1, 11);
    short_of_memory(2, 12);
    short_of_memory(4, 13);
    test("a scene deeper than PLT_DEPTH_MAX is refused, one of that depth is built");
    depth_limit();
    printf("    the deepest tree has %u levels\n", deepest);
    return test_done();
}
