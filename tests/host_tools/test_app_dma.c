/* test_app_dma - a simulated DMA engine takes its time, holds its limits and fails on order
 *
 * Also traces a streamed scene over it, with and without prefetch, with every transfer failing in
 * every way: the hits are the same.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "board/fake/fake.h"
#include "engine/engine.h"
#include "host_tools/app/dma.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/rays.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { BYTES = 4096, RAYS = 256 };

static unsigned char image[BYTES], to[4 * BYTES];

static void fill_image(void) {
    for (unsigned i = 0; i < BYTES; i++) {
        image[i] = (unsigned char)(i * 7 + (i >> 8));
    }
}

typedef struct bench {
    fake_link link;
    dma board;
    plt_source source;
} bench;

/* 1 us and 168 MB/s: 168 cycles, and one per byte. */
static void open_bench(bench *b, unsigned outstanding, enum dma_failure failure) {
    const dma_config c = {.latency_us = 1,
                          .mb_per_s = 168,
                          .outstanding = outstanding,
                          .failure = failure,
                          .at_transfer = 2};
    *b = (bench){.link = {.image = image, .bytes = BYTES}};
    const plt_source from = fake_source(&b->link);
    b->source = dma_source(&b->board, &from, &c);
}

static int start(bench *b, unsigned tag, uint32_t offset, uint32_t at, uint32_t count) {
    return b->source.start(b->source.context, tag, offset, to + at, count);
}

static int wait(bench *b, uint32_t tags) {
    return b->source.wait(b->source.context, tags);
}

static void takes_its_time(void) {
    bench b;
    open_bench(&b, 4, DMA_WORKS);
    CHECK(start(&b, 3, 100, 0, 1000) == 0 && memcmp(to, image + 100, 8) != 0,
          "bytes are there at once");
    CHECK(wait(&b, 1u << 3) == 0 && memcmp(to, image + 100, 1000) == 0, "bytes are not there");
    CHECK(b.board.stalled == 168 + 1000 && b.board.worked == 0, "%u cycles stalled",
          (unsigned)b.board.stalled);
    CHECK(start(&b, 0, 0, 0, 100) == 0 && start(&b, 1, 0, 200, 100) == 0, "two do not start");
    CHECK(wait(&b, 2) == 0 && b.board.stalled == 1168 + 2 * 268, "the second waits for the first");
    CHECK(dma_unfinished(&b.board) == 1, "the first was not waited for");
    CHECK(wait(&b, 1) == 0 && b.board.stalled == 1168 + 2 * 268, "the first had ended");
    CHECK(dma_unfinished(&b.board) == 0 && b.board.transfers == 3 && b.board.bytes == 1200,
          "counts");
}

static void holds_its_limits(void) {
    bench b;
    open_bench(&b, 2, DMA_WORKS);
    CHECK(start(&b, 0, 0, 0, 100) == 0 && start(&b, 1, 0, 200, 100) == 0 && b.board.stalled == 0,
          "two start at once");
    CHECK(start(&b, 2, 0, 400, 100) == 0 && b.board.stalled == 268,
          "the third waits for the first");
    CHECK(wait(&b, 7) == 0 && b.board.stalled == 3 * 268, "all have ended");
    open_bench(&b, DMA_OUTSTANDING_MOST, DMA_WORKS);
    for (unsigned i = 0; i < DMA_OUTSTANDING_MOST; i++) {
        CHECK(start(&b, i % 32, 0, 16 * i, 16) == 0, "transfer %u", i);
    }
    CHECK(start(&b, 0, 0, 0, 16) < 0 && b.board.failed == 1, "more than it has room for");
    CHECK(wait(&b, UINT32_MAX) == 0 && dma_unfinished(&b.board) == 0, "some are left");
}

/* The second of three transfers fails. */
static void fails_on_order(void) {
    static const struct {
        enum dma_failure failure;
        int starts, waits;
        unsigned whole; /* bytes that are right */
    } due[] = {
        {DMA_WORKS, 0, 0, 100}, {DMA_FAILS_AT_START, -1, 0, 0}, {DMA_FAILS_AT_WAIT, 0, -1, 100},
        {DMA_SHORT, 0, -1, 50}, {DMA_SILENT, 0, 0, 0},          {DMA_GARBLED, 0, 0, 50},
        {DMA_LATE, 0, -1, 0}};
    for (unsigned i = 0; i < sizeof due / sizeof *due; i++) {
        bench b;
        open_bench(&b, 4, due[i].failure);
        memset(to, 0, sizeof to);
        CHECK(start(&b, 0, 0, 0, 100) == 0, "the first");
        CHECK(start(&b, 1, 500, 200, 100) == due[i].starts, "failure %u: start", i);
        CHECK(wait(&b, 2) == due[i].waits, "failure %u: wait", i);
        unsigned whole = 0;
        while (whole < 100 && to[200 + whole] == image[500 + whole]) {
            whole++;
        }
        CHECK(whole == due[i].whole, "failure %u: %u bytes are right", i, whole);
        CHECK(due[i].failure != DMA_LATE || b.board.stalled == 168ull * DMA_LIMIT_US, "late");
        CHECK(wait(&b, 1) == 0 && start(&b, 1, 500, 200, 100) == 0 && wait(&b, 2) == 0 &&
                  memcmp(to + 200, image + 500, 100) == 0,
              "failure %u: the third", i);
        CHECK(b.board.failed == (due[i].starts < 0 || due[i].waits < 0), "failure %u: count", i);
    }
}

/* ---- a scene -------------------------------------------------------------- */

typedef struct traced {
    plt_hit hits[RAYS];
    plt_stats stats;
    uint64_t worked, stalled, transfers;
    int status;
} traced;

static void trace(const packed *scene, const plt_ray *rays, uint8_t ahead, uint8_t side,
                  const dma_config *c, traced *t) {
    const plt_options o = {.packet_side = side,
                           .residency = PLT_RESIDENCY_STREAMED,
                           .prefetch = ahead,
                           .store_bytes = PLT_STORE_LEAST};
    const size_t bytes = plt_arena_need(&scene->info, 0, &o);
    fake_link link = {.image = scene->bytes, .bytes = scene->size};
    const plt_source from = fake_source(&link);
    dma board;
    plt_engine *engine;
    plt_fault fault;
    void *arena = aligned_alloc(PLT_ALIGN, (bytes + PLT_ALIGN - 1) / PLT_ALIGN * PLT_ALIGN);
    const dma_config works = {c->latency_us, c->mb_per_s, c->outstanding, DMA_WORKS, 0};
    const plt_source source = dma_source(&board, &from, &works);
    t->status = plt_open(&engine, arena, bytes, &source, &o, &fault);
    if (t->status == PLT_OK) {
        dma_reset(&board, engine); /* transfers are counted from here */
        board.config = *c;
        t->status = plt_trace(engine, rays, t->hits, RAYS, 0);
        dma_settle(&board);
        plt_stats_get(engine, &t->stats);
    }
    t->worked = board.worked;
    t->stalled = board.stalled;
    t->transfers = board.transfers;
    CHECK(dma_unfinished(&board) == 0 && fake_unfinished(&link) == 0 && link.broken == 0,
          "something is on its way still");
    free(arena);
}

static void scene_over_it(void) {
    static plt_ray rays[RAYS];
    static traced without, with, failed;
    mesh m = {0};
    random_state r = {5};
    compact_config c = compact_config_of(2, 14, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    shape_soup(&m, compact_triangles(4000, 2), 0.1f, 3);
    rays_mixed(rays, RAYS, &m, &r);
    c.pack.numbers = 0; /* primitive ids have no check: SPEC.md, 5.5 */
    packed scene = compact_packed(&m, &c);
    const dma_config works = {.latency_us = 1, .mb_per_s = 20, .outstanding = 4};
    for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        trace(&scene, rays, 0, side, &works, &without);
        trace(&scene, rays, 4, side, &works, &with);
        CHECK(without.status == PLT_OK && with.status == PLT_OK, "side %u: status", side);
        CHECK(memcmp(without.hits, with.hits, sizeof with.hits) == 0, "side %u: hits", side);
        /* Where transfers are tiny, no part is few enough of them. */
        CHECK(without.stalled > 0 && with.stalled < without.stalled + (PLT_TRANSFER_BYTES < 256),
              "side %u: prefetch stalls for %llu cycles, %llu without", side,
              (unsigned long long)with.stalled, (unsigned long long)without.stalled);
        CHECK(with.worked > 0, "side %u: no work", side);
        for (unsigned mode = DMA_FAILS_AT_START; mode <= DMA_LATE; mode++) {
            for (uint32_t at = 1; at <= with.transfers; at += 1 + with.transfers / 24) {
                const dma_config fails = {1, 20, 4, (enum dma_failure)mode, at};
                trace(&scene, rays, 4, side, &fails, &failed);
                CHECK(failed.status == PLT_OK, "mode %u, transfer %u: status %d", mode, at,
                      failed.status);
                CHECK(memcmp(failed.hits, with.hits, sizeof with.hits) == 0,
                      "mode %u, transfer %u: hits", mode, at);
                CHECK(failed.stats.fetch_retries <= 1, "mode %u, transfer %u: %u retries", mode, at,
                      (unsigned)failed.stats.fetch_retries);
            }
        }
    }
    pack_free(&scene);
    mesh_free(&m);
}

int main(void) {
    fill_image();
    test("transfers take latency and bandwidth, one after the other");
    takes_its_time();
    test(
        "a start beyond those that may be outstanding waits, or is refused where there is no room");
    holds_its_limits();
    test("each failure is what its name says, and the next transfer works");
    fails_on_order();
    test("a scene over it: the same hits with prefetch, fewer cycles stalled, whatever fails");
    scene_over_it();
    return test_done();
}
