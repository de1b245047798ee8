/* test_compact_arena - the arena of compact scenes: size, peak, guards, steps
 *
 * Arenas are heap blocks of exactly their size, with a pattern before them, and images are
 * compared afterwards; sanitizers see accesses beyond the end.
 *
 * SPDX-License-Identifier: MIT */
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "engine/builder/blocks.h"
#include "engine/engine.h"
#include "engine/layout.h"
#include "engine/scene/build_compact.h"
#include "tests/reference/compact_check.h"
#include "tests/reference/compact_hostile.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/room.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { ZONE = 64, PATTERN = 0xC3 };

static packed image_of(uint32_t triangles, const compact_config *config) {
    mesh m = {0};
    shape_soup(&m, triangles, 0.5f, triangles);
    return compact_packed(&m, config);
}

typedef struct opened {
    int status;
    plt_fault fault;
    size_t used, peak;
} opened;

/* Opens in `bytes` and traces if that works. */
static opened open_in(const packed *image, size_t bytes, int streamed, uint8_t side) {
    opened o = {0, {0, 0, 0, 0, NULL}, 0, 0};
    hostile_stream stream = {image->bytes, image->size, 0};
    const plt_source fetched = {NULL, image->size, &stream, hostile_start, hostile_wait};
    const plt_source source = streamed ? fetched : rig_source(image);
    const plt_options options = {.packet_side = side, .count_touched = 1};
    unsigned char *zone = room_get(bytes + ZONE);
    plt_engine *e = NULL;
    memset(zone, PATTERN, bytes + ZONE);
    o.status = plt_open(&e, zone + ZONE, bytes, &source, &options, &o.fault);
    if (o.status == PLT_OK) {
        const char *sentence = compact_trace(e, compact_ids_end(plt_engine_info(e)));
        CHECK(sentence == NULL, "%s", sentence);
        o.used = plt_arena_used(e);
        o.peak = plt_arena_peak(e);
    }
    CHECK((e != NULL) == (o.status == PLT_OK), "status %d", o.status);
    for (int i = 0; i < ZONE; i++) {
        CHECK(zone[i] == PATTERN, "byte %d before the arena was written", ZONE - i);
    }
    CHECK(!stream.beyond, "the source was read beyond its end");
    free(zone);
    return o;
}

static void every_size(const packed *image, int streamed, uint8_t side) {
    const plt_options options = {.packet_side = side, .count_touched = 1};
    const size_t need = plt_arena_need(&image->info, !streamed, &options);
    const int device = image->info.build == PLT_BUILD_DEVICE;
    size_t least = 0;
    for (size_t bytes = 0; bytes <= need + 16; bytes += bytes + 600 < need ? 112 : 16) {
        const opened o = open_in(image, bytes, streamed, side);
        if (bytes >= need || (device && o.status == PLT_OK)) {
            CHECK(o.status == PLT_OK, "%zu bytes of %zu: %s", bytes, need, o.fault.message);
            CHECK(o.used <= o.peak && o.peak <= bytes, "used %zu, peak %zu of %zu", o.used, o.peak,
                  bytes);
            least = least == 0 ? bytes : least;
        } else {
            CHECK(o.status == PLT_ERR_ARENA && o.fault.need_bytes == need && least == 0,
                  "%zu bytes of %zu: status %d, need %zu; %s", bytes, need, o.status,
                  o.fault.need_bytes, o.fault.message);
        }
    }
    const opened exact = open_in(image, need, streamed, side);
    CHECK(exact.status == PLT_OK && (device || exact.peak == need), "need %zu, peak %zu", need,
          exact.peak);
}

static void sizes(void) {
    static const uint32_t triangles[4] = {0, 1, 9, 120};
    for (int i = 0; i < 4; i++) {
        for (uint8_t build = PLT_BUILD_HOST; build <= PLT_BUILD_DEVICE; build++) {
            for (uint8_t floats = 0; floats <= (build == PLT_BUILD_HOST); floats++) {
                compact_config config =
                    compact_config_of(1u << i % 3, i == 3 ? 21 : 14, build, floats);
                config.pack.floats = floats;
                packed image = image_of(triangles[i], &config);
                every_size(&image, 0, 2);
                every_size(&image, 1, PLT_PACKET_SIDE_MAX);
                pack_free(&image);
            }
        }
    }
}

/* What a device build needs at any time: the engine, scratch (and a record cache for corners
 * that are not mapped), the finished blocks and at most one block more (or, with few triangles,
 * their permutation). */
static void peak_of(uint32_t triangles, uint32_t k, uint8_t bits, int streamed) {
    const compact_config config = compact_config_of(k, bits, PLT_BUILD_DEVICE, PLT_SPLIT_SAH);
    packed image = image_of(triangles, &config);
    hostile_stream stream = {image.bytes, image.size, 0};
    const plt_source fetched = {NULL, image.size, &stream, hostile_start, hostile_wait};
    const plt_source source = streamed ? fetched : rig_source(&image);
    const size_t need = plt_arena_need(&image.info, !streamed, &config.run);
    void *arena = room_get(need);
    plt_engine *e = NULL;
    plt_fault fault;
    CHECK(plt_open(&e, arena, need, &source, &config.run, &fault) == PLT_OK, "%s", fault.message);
    if (e != NULL) {
        const plt_block_tree *tree = &e->scene.compact;
        const compact_facts f = compact_check(tree, NULL);
        const size_t fixed = sizeof *e + plt_compact_build_bytes(triangles) + 64 +
                             (streamed ? plt_record_cache_bytes(plt_corners_bytes(bits)) + 64 : 0);
        const size_t blocks = (size_t)tree->used + f.largest_block;
        CHECK(f.broken == 0 && f.triangles == triangles, "%u of %u: %s", f.triangles, triangles,
              f.sentence);
        CHECK(plt_arena_peak(e) <= fixed + (blocks > 2 * triangles ? blocks : 2 * triangles),
              "%u triangles: peak %zu, fixed %zu, image %u and a block %u", triangles,
              plt_arena_peak(e), fixed, tree->used, f.largest_block);
        CHECK(plt_arena_used(e) >= sizeof *e + tree->used, "used %zu", plt_arena_used(e));
        if (!streamed && triangles == 3000) {
            printf("    %u triangles, K %u: peak %zu = engine and scratch %zu, image %u, and %ld\n",
                   triangles, k, plt_arena_peak(e), fixed - 64, tree->used,
                   (long)plt_arena_peak(e) - (long)(fixed - 64) - (long)tree->used);
        }
    }
    free(arena);
    pack_free(&image);
}

/* In steps of any size: the blocks of plt_open, in a bounded number of steps. */
static void in_steps(uint32_t k, uint32_t splits) {
    const compact_config config = compact_config_of(k, 16, PLT_BUILD_DEVICE, PLT_SPLIT_MEDIAN);
    packed image = image_of(compact_triangles(500, k), &config);
    const plt_source source = rig_source(&image);
    const size_t need = plt_arena_need(&image.info, 1, &config.run);
    void *whole_arena = room_get(need), *arena = room_get(need);
    plt_engine *whole = NULL, *e = NULL;
    plt_fault fault;
    CHECK(plt_open(&whole, whole_arena, need, &source, &config.run, &fault) == PLT_OK, "%s",
          fault.message);
    int status = plt_open_begin(&e, arena, need, &source, &config.run, &fault);
    uint32_t steps = 0;
    CHECK(status == PLT_MORE, "status %d", status);
    while (status == PLT_MORE && steps < 100000) {
        status = plt_open_step(e, splits, &fault);
        steps++;
    }
    CHECK(status == PLT_OK, "%s", fault.message);
    if (whole != NULL && status == PLT_OK) {
        const plt_block_tree *a = &whole->scene.compact, *b = &e->scene.compact;
        const plt_info *info = plt_engine_info(e);
        const uint32_t work = info->nodes + 2 * info->treelets;
        CHECK(a->used == b->used && memcmp(a->bytes, b->bytes, a->used) == 0, "blocks differ");
        /* Every field; the padding after the last is not compared. */
        const size_t fields =
            offsetof(plt_info, primitive_id_bits) + sizeof info->primitive_id_bits;
        CHECK(memcmp(plt_engine_info(whole), info, fields) == 0, "counts differ");
        CHECK(plt_arena_peak(whole) == plt_arena_peak(e), "peaks differ");
        CHECK(steps >= work / splits && steps <= 3 * work / splits + 1,
              "%u steps of %u for %u nodes and %u blocks", steps, splits, info->nodes,
              info->treelets);
        CHECK(plt_open_step(e, 1, &fault) == PLT_OK, "one more step is an error");
        CHECK(compact_trace(e, info->triangles) == NULL, "cannot be traced");
    }
    free(whole_arena);
    free(arena);
    pack_free(&image);
}

enum { RAYS = 256 };

/* Hits of some rays, and their statistics. */
static plt_stats hits_of(plt_engine *e, plt_hit hits[RAYS]) {
    const plt_info *info = plt_engine_info(e);
    plt_ray rays[RAYS];
    plt_stats s;
    for (uint32_t i = 0; i < RAYS; i++) {
        const float x = info->lo[0] + (info->hi[0] - info->lo[0]) * (float)(i % 16) / 15.0f;
        const float y = info->lo[1] + (info->hi[1] - info->lo[1]) * (float)(i / 16) / 15.0f;
        const plt_ray ray = {{x, y, info->lo[2] - 1.0f}, 0.0f, {0.1f, 0.05f, 1.0f}, 1e30f};
        rays[i] = ray;
    }
    plt_stats_reset(e);
    plt_trace(e, rays, hits, RAYS, 0);
    plt_stats_get(e, &s);
    return s;
}

/* The soup with its axes exchanged: a tree of the same shape with other boxes. */
static packed turned_of(uint32_t triangles, const compact_config *config) {
    mesh m = {0};
    shape_soup(&m, triangles, 0.5f, triangles);
    for (size_t i = 0; i < m.vertices; i++) {
        float *v = m.vertex + 3 * i;
        const float x = v[0];
        v[0] = v[1];
        v[1] = v[2];
        v[2] = x;
    }
    return compact_packed(&m, config);
}

/* Blocks still open from earlier rays change neither hits nor statistics, and those of another
 * scene in the same arena are forgotten. */
static void one_after_another(uint8_t build) {
    const compact_config config = compact_config_of(2, 14, build, PLT_SPLIT_SAH);
    packed image[2] = {image_of(compact_triangles(300, 2), &config),
                       turned_of(compact_triangles(300, 2), &config)};
    const size_t need[2] = {plt_arena_need(&image[0].info, 1, &config.run),
                            plt_arena_need(&image[1].info, 1, &config.run)};
    const size_t bytes = need[0] > need[1] ? need[0] : need[1];
    void *arena = room_get(bytes), *fresh = room_get(bytes);
    for (int i = 0; i < 4; i++) {
        plt_engine *e = NULL, *other = NULL;
        plt_fault fault;
        static plt_hit hit[3][RAYS];
        const plt_source source = rig_source(&image[i % 2]);
        memset(fresh, 0, bytes);
        CHECK(plt_open(&e, arena, bytes, &source, &config.run, &fault) == PLT_OK, "%s",
              fault.message);
        CHECK(plt_open(&other, fresh, bytes, &source, &config.run, &fault) == PLT_OK, "%s",
              fault.message);
        const plt_stats cold = hits_of(e, hit[0]), warm = hits_of(e, hit[1]);
        const plt_stats alone = hits_of(other, hit[2]);
        CHECK(memcmp(hit[0], hit[1], sizeof hit[0]) == 0, "hits of open blocks differ");
        CHECK(memcmp(hit[0], hit[2], sizeof hit[0]) == 0, "hits of a used arena differ");
        CHECK(warm.treelet_fetches == cold.treelet_fetches && cold.treelet_fetches > 0 &&
                  warm.bytes_fetched == cold.bytes_fetched,
              "%llu fetches, then %llu", (unsigned long long)cold.treelet_fetches,
              (unsigned long long)warm.treelet_fetches);
        CHECK(alone.treelet_fetches == cold.treelet_fetches, "other fetches in a fresh arena");
    }
    free(arena);
    free(fresh);
    pack_free(&image[0]);
    pack_free(&image[1]);
}

int main(void) {
    test("exactly the need is enough; with less a device builds, or fails and reports the need");
    sizes();
    test("a device's peak is engine, scratch, the blocks and at most one block");
    for (uint32_t k = 1; k <= 4; k *= 2) {
        for (int streamed = 0; streamed < 2; streamed++) {
            peak_of(2, k, 14, streamed);
            peak_of(compact_triangles(100, k), k, 21, streamed);
            peak_of(compact_triangles(3000, k), k, 14, streamed);
        }
    }
    test("a build in steps gives the same blocks; nodes and blocks bound the number of steps");
    in_steps(1, 1);
    in_steps(2, 1);
    in_steps(4, 7);
    test("scenes and rays one after another in one arena give the hits that they give alone");
    one_after_another(PLT_BUILD_HOST);
    one_after_another(PLT_BUILD_DEVICE);
    return test_done();
}
