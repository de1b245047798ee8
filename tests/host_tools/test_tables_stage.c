/* test_tables_stage - rays of planelet tables: those of ray_kinds, and no memory for all of them
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "board/hash.h"
#include "host_tools/app/ray_kinds.h"
#include "host_tools/app/view.h"
#include "host_tools/base/heap.h"
#include "host_tools/pack/pack.h"
#include "host_tools/scenes/scenes.h"
#include "host_tools/tables/book.h"
#include "host_tools/tables/racers.h"
#include "tests/test.h"

#define ARENA_BYTES (8 << 20)

static _Alignas(PLT_ALIGN) unsigned char arena[ARENA_BYTES];

/* Few where trees may be 8 nodes deep at most. */
enum { TRIANGLES = PLT_DEPTH_MAX < 16 ? 40 : 400 };

static int set_stage(stage *s, size_t triangles) {
    mesh m = {0};
    fail f = {""};
    const int status =
        triangles > 12 ? scene_knot(&m, triangles, &f) : scene_terrain(&m, triangles, &f);
    CHECK(status == 0, "%s", f.text);
    stage_set(s, "knot", &m);
    return status;
}

/* All views, one behind the other, as they are made with an engine. */
static uint64_t hash_of_kinds(const stage *s, unsigned side, unsigned views, uint64_t *rays) {
    const pack_options options = {.leaf_triangles = 4, .treelet_nodes = 64};
    const plt_options run = {.packet_side = 2};
    packed image = {0};
    plt_engine *engine = NULL;
    plt_fault fault;
    plt_frame frame = {.width = (uint16_t)side, .height = (uint16_t)side};
    plt_camera first;
    uint64_t hash = HASH_BASIS;
    fail f = {""};
    CHECK(pack_mesh(&image, &s->m, &options, "knot", &f) == 0, "%s", f.text);
    const plt_source source = {.mapped = image.bytes, .bytes = image.size};
    CHECK(plt_open(&engine, arena, sizeof arena, &source, &run, &fault) == PLT_OK, "%s",
          fault.message);
    view_of_all(plt_engine_info(engine), side, side, &first);
    *rays = 0;
    for (unsigned i = 0; i < views; i++) {
        ray_kinds kinds;
        view_orbit(&first, (double)i / views, &frame.camera);
        CHECK(ray_kinds_make(&kinds, 1u << RAYS_PRIMARY, engine, &frame, "knot", &f) == 0, "%s",
              f.text);
        const ray_set *set = &kinds.of[RAYS_PRIMARY];
        hash = hash_update(hash, (const uint8_t *)set->rays, set->count * sizeof *set->rays);
        *rays += set->count;
        ray_kinds_free(&kinds);
    }
    pack_free(&image);
    return hash;
}

/* In pieces of `most`, which cut views and tiles anywhere. */
static uint64_t hash_of_stage(stage *s, uint32_t most) {
    const turns_rays rays = stage_rays(s);
    uint64_t hash = HASH_BASIS;
    for (uint64_t at = 0; at < rays.count; at += most) {
        const uint64_t left = rays.count - at;
        const uint32_t now = left < most ? (uint32_t)left : most;
        hash = hash_update(hash, (const uint8_t *)rays.at(rays.context, at, now),
                           now * sizeof(plt_ray));
    }
    return hash;
}

static void check_rays(void) {
    static const struct { unsigned side, views; } looks[] = {{16, 1}, {48, 3}, {144, 5}, {32, 16}};
    test("rays of all views are those of the engine's pictures, bit for bit, in any pieces");
    for (unsigned i = 0; i < 4; i++) {
        const stage_options look = {looks[i].side, looks[i].views};
        stage s;
        fail f = {""};
        uint64_t count;
        if (set_stage(&s, TRIANGLES) == 0) {
            CHECK(stage_look(&s, &look, &f) == 0, "%s", f.text);
            const uint64_t due = hash_of_kinds(&s, look.side, look.views, &count);
            CHECK(stage_rays(&s).count == count, "%u x %u", look.side, look.views);
            CHECK(hash_of_stage(&s, TURNS_BATCH) == due, "%u x %u", look.side, look.views);
            CHECK(hash_of_stage(&s, 1000) == due, "%u x %u", look.side, look.views);
            CHECK(hash_of_stage(&s, 7) == due, "%u x %u", look.side, look.views);
        }
        stage_free(&s);
    }
}

/* Bytes that are in use at most while packets, and then three structures in turn, are measured. */
static uint64_t peak_of(size_t triangles, unsigned side, unsigned views, figures *to) {
    static const char *const names[MEASURE_RACERS] = {
        "wbvh:4x4", "bvh:4x4", PLT_PACKET_SIDE_MAX < 4 ? "tree:2x2" : "tree:4x4"};
    meter m = {.look = {side, views}, .rounds = 1};
    figures raced[MEASURE_RACERS];
    fail f = {""};
    stage s;
    const uint64_t before = heap_used();
    heap_forget_peak();
    counters_open(&m.counters);
    if (set_stage(&s, triangles) == 0) {
        CHECK(measure_job(&m, &s, "trace:wbvh:4x4", to, &f) == 0, "%s", f.text);
        CHECK(measure_race(&m, &s, names, raced, &f) == 0, "%s", f.text);
        CHECK(raced[0].of[FIGURE_RAYS] == (double)side * side * views, "rays");
    }
    counters_close(&m.counters);
    stage_free(&s);
    CHECK(heap_used() == before, "not all is given back");
    return heap_peak() - before;
}

static void check_memory(void) {
    figures few, many;
    test("memory does not grow with the size and number of pictures");
    const uint64_t least = peak_of(TRIANGLES, 256, 1, &few),
                   most = peak_of(TRIANGLES, 512, 16, &many);
    CHECK(many.of[FIGURE_RAYS] == 16.0 * 512 * 512 && few.of[FIGURE_RAYS] == 256.0 * 256, "%g %g",
          many.of[FIGURE_RAYS], few.of[FIGURE_RAYS]);
    CHECK(least == most, "%llu and %llu bytes", (unsigned long long)least,
          (unsigned long long)most);
    CHECK(most < STAGE_RAY_BYTES + 400 * 600 + (1 << 20), "%llu bytes", (unsigned long long)most);
}

/* Frames of an animation add up. */
static void check_sums(void) {
    const stage_options look = {48, 2};
    counters c;
    racers all = {.count = 0};
    fail f = {""};
    stage s;
    test("times, rays and hits of races are sums over all frames");
    counters_open(&c);
    if (set_stage(&s, TRIANGLES) == 0) {
        CHECK(stage_look(&s, &look, &f) == 0 && racers_add(&all, "wbvh", &s.m, "knot", &f) == 0,
              "%s", f.text);
        CHECK(racers_run(&all, &s, 2, &c, &f) == 0, "%s", f.text);
        const racer_time once = all.racer[0].sum;
        CHECK(once.hits > 10.0 && once.hits < once.rays && once.rays == 2.0 * 48 * 48, "%g of %g",
              once.hits, once.rays);
        for (int i = 0; i < 20; i++) {
            CHECK(racers_run(&all, &s, 2, &c, &f) == 0, "%s", f.text);
        }
        const racer_time all_runs = all.racer[0].sum;
        CHECK(all_runs.hits == 21.0 * once.hits && all_runs.rays == 21.0 * once.rays, "%g hits",
              all_runs.hits);
        CHECK(all_runs.seconds > 3.0 * once.seconds, "%g and %g s", once.seconds, all_runs.seconds);
    }
    racers_close(&all);
    counters_close(&c);
    stage_free(&s);
}

static void check_said(void) {
    book b = {.options = {.rows = 1u << 1, .tables = 1u << 2}};
    test("what is said before a run grows with the largest mesh, and with structures that race");
    const uint64_t raced = book_bytes(&b);
    b.options.tables = 1u << 3;
    const uint64_t counted = book_bytes(&b);
    CHECK(counted >= STAGE_RAY_BYTES && raced > counted, "%llu, %llu", (unsigned long long)counted,
          (unsigned long long)raced);
    b.options.rows |= 1u << (PRINTED_SCENES - 1);
    CHECK(book_bytes(&b) > counted + 100ull * 1087716, "%llu", (unsigned long long)book_bytes(&b));
    b.meter.look = (stage_options){2048, 16};
    const uint64_t large = book_bytes(&b);
    b.meter.look = (stage_options){16, 1};
    CHECK(book_bytes(&b) == large, "it grows with pictures");
}

int main(void) {
    check_rays();
    check_memory();
    check_sums();
    check_said();
    return test_done();
}
