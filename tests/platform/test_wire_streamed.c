/* test_wire_streamed - a device whose scene stays with its host, over cables that fail
 *
 * Every report of a frame is lost, damaged, cut short, repeated, late or overtaken, one at a
 * time: the frame is that of a direct render. Either peer stands still at every report, or the
 * cable is dead for a while: the frame goes on. The cable dies at every report, the host falls
 * silent, refuses or lies from every request on: the device gives up after a time that is bounded,
 * says why, and renders the next frame.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

enum { WIDTH = 28, HEIGHT = 20, MEMORY = 1 << 17, IMAGE_MOST = 1 << 20 };

#include "tests/reference/compact_rig.h"
#include "tests/reference/shapes.h"
#include "tests/reference/wire_device_rig.h"

/* The engine tries a block three times, and each try ends: wire_block.h. */
enum { CALL_MS_MOST = 3 * WIRE_BLOCK_DEAD_MS + 1000 };

static uint32_t longest_ms; /* call of wire_device_run */
static uint8_t served[IMAGE_MOST];

static rig direct;
static uint8_t due[2][WIDTH * HEIGHT * 3];

static const wire_view views[2] = {
    {.eye = {3, 2, 4}, .up = {0, 1, 0}, .tan_half_fov = 0.3f},
    {.eye = {-3, 1, 4}, .up = {0, 1, 0}, .tan_half_fov = 0.35f, .shader = PLT_SHADE_NORMAL}};

static int pump(void *context) {
    fake_cable_step(context);
    return 0;
}

/* `room`: images above it are streamed. */
static void open_pair(uint64_t seed, uint32_t room) {
    const uint32_t bytes = (uint32_t)direct.image.size;
    memcpy(served, direct.image.bytes, bytes);
    open_rig(served, bytes, 8, seed);
    wire_device_stream(&e.device, pump, &e.cable);
    e.device.scene.room = room;
    longest_ms = 0;
}

static void run_device(void) {
    if (e.cable.stopped == &e.device.peer) {
        return;
    }
    const uint32_t before = e.cable.now_ms;
    wire_device_run(&e.device, 2000);
    const uint32_t lasted = e.cable.now_ms - before;
    longest_ms = lasted > longest_ms ? lasted : longest_ms;
}

/* As `planelet serve`: 1 when a frame of the view came, -1 when the device reported an error (in
 * *code), 0 when neither did within `most` milliseconds. */
static int frame_comes(uint32_t most, unsigned *code) {
    const uint32_t seen = wire_frames_shown(&e.frames), until = e.cable.now_ms + most;
    uint32_t detail;
    while ((int32_t)(until - e.cable.now_ms) > 0) {
        fake_cable_step(&e.cable);
        for (int n = 0; n < 4; n++) {
            run_device();
        }
        *code = wire_error_read(&e.host, &detail);
        if (*code != WIRE_FINE) {
            return -1;
        }
        if (wire_frames_shown(&e.frames) != seen &&
            wire_frames_mark(&e.frames) == e.view.view.number) {
            return 1;
        }
    }
    return 0;
}

static void check_frame(unsigned view, const char *how, uint32_t at) {
    unsigned code;
    wire_view_send(&e.view, &views[view]);
    const int came = frame_comes(60000, &code);
    CHECK(came == 1, "%s %u: %d, code %u", how, at, came, code);
    CHECK(memcmp(e.panel, due[view], sizeof e.panel) == 0, "%s %u: the frame differs", how, at);
}

static void check_bounds(const char *how, uint32_t at) {
    for (unsigned i = 0; i < GUARD; i++) {
        CHECK(e.memory[MEMORY + i] == 0x5A, "%s %u: written behind the memory", how, at);
    }
    CHECK(longest_ms <= CALL_MS_MOST, "%s %u: a call of %u ms", how, at, longest_ms);
}

/* ---- a good cable ------------------------------------------------------------------------ */

static uint32_t reports[2]; /* of a frame over a good cable, by direction */
static uint32_t requests;

static void test_good(void) {
    test("a scene that has no room is streamed, and the frame is that of a direct render");
    open_pair(1, 0);
    check_frame(0, "first", 0);
    memcpy(reports, e.cable.carried, sizeof reports);
    requests = e.blocks.asked;
    CHECK(e.device.is_streamed && requests > 5, "%u requests", requests);
    CHECK(e.blocks.sent < direct.image.size, "%llu bytes", (unsigned long long)e.blocks.sent);
    check_frame(1, "second", 0);
    check_bounds("good", 0);
    printf("    %u bytes of image, %llu streamed in %u requests; %u and %u reports\n",
           direct.image.size, (unsigned long long)e.blocks.sent, e.blocks.asked, reports[0],
           reports[1]);
    test("one that has room comes whole; without room for the engine beside it, it is streamed");
    open_pair(1, MEMORY);
    check_frame(0, "whole", 0);
    CHECK(!e.device.is_streamed && e.blocks.asked == 0, "it is streamed");
    open_pair(1, MEMORY);
    e.device.memory_bytes = direct.image.size + 1000;
    e.device.memory_bytes = e.device.memory_bytes < 65536 ? 65536 : e.device.memory_bytes;
    e.device.scene.room = (uint32_t)e.device.memory_bytes;
    check_frame(0, "beside", 0);
    CHECK(e.device.is_streamed == (direct.image.size + direct.arena_bytes > 65536), "%d",
          e.device.is_streamed);
    test("a host without blocks to give is told that the scene is too large");
    open_pair(1, 0);
    e.host.own.features &= (uint8_t)~WIRE_SCENES;
    unsigned code;
    uint32_t has;
    CHECK(frame_comes(1000, &code) == 0, "a frame came");
    CHECK(wire_scene_out_state(&e.scene, &has) == WIRE_SCENE_LARGE, "taken");
}

/* ---- one report -------------------------------------------------------------------------- */

static void test_strikes(void) {
    static const char *const names[FAKE_BLOWS] = {"nothing", "lost", "damaged",  "short",
                                                  "again",   "late", "overtaken"};
    test("every report of either direction may be lost, damaged, short, repeated or out of order");
    for (unsigned blow = FAKE_LOSES; blow <= FAKE_SWAPS; blow++) {
        for (uint32_t i = 1; i <= reports[0] + reports[1]; i++) {
            const int to_host = i > reports[0];
            open_pair(i, 0);
            e.cable.strike =
                (fake_strike){to_host ? i - reports[0] : i, (uint8_t)blow, (uint8_t)to_host, 0};
            check_frame(0, names[blow], i);
            check_bounds(names[blow], i);
        }
    }
    test("at every report the cable may die: the device gives up, and goes on with the next host");
    for (uint32_t i = 1; i <= reports[0] + reports[1]; i++) {
        const int to_host = i > reports[0];
        unsigned code;
        open_pair(i, 0);
        e.cable.strike =
            (fake_strike){to_host ? i - reports[0] : i, FAKE_ENDS, (uint8_t)to_host, 0};
        wire_view_send(&e.view, &views[0]);
        const int came = frame_comes(20000, &code);
        CHECK(came == 0 || (i >= reports[0] && came == 1), "%u: %d", i, came);
        e.cable.is_dead = 0;
        e.cable.strike.blow = FAKE_NOTHING;
        check_frame(1, "after its end", i);
        check_bounds("dead", i);
    }
}

/* ---- silence ------------------------------------------------------------------------------- */

/* How often the frame was rendered, to the pixel. */
static uint64_t rays_cast(void) {
    plt_stats stats = {0};
    if (e.device.engine != NULL) {
        plt_stats_get(e.device.engine, &stats);
    }
    return stats.rays;
}

/* With every report an outage of `ms` begins. Returns after how many the frame was rendered once,
 * in one session. */
static uint32_t outages(unsigned blow, uint32_t ms, const char *how) {
    uint32_t once = 0;
    for (uint32_t i = 1; i <= reports[0] + reports[1]; i++) {
        const int to_host = i > reports[0];
        open_pair(i, 0);
        e.cable.strike =
            (fake_strike){to_host ? i - reports[0] : i, (uint8_t)blow, (uint8_t)to_host, ms};
        check_frame(0, how, i);
        longest_ms = blow == FAKE_STOPS_DEVICE ? 0 : longest_ms; /* it stood still in a call */
        check_bounds(how, i);
        once += rays_cast() == WIDTH * HEIGHT && e.device.peer.stats.sessions == 1 &&
                e.host.stats.sessions == 1;
    }
    return once;
}

static void test_silence(void) {
    const uint32_t all = reports[0] + reports[1];
    test("a device that stands still at any report costs time, and no pixel is rendered twice");
    uint32_t once = outages(FAKE_STOPS_DEVICE, 2000, "device stops");
    CHECK(once == all, "%u of %u", once, all);
    once = outages(FAKE_STOPS_DEVICE, 30000, "device stops for long");
    CHECK(once == all, "%u of %u", once, all);
    test("so does a host; after 15 s the device begins the frame again, and tells of no error");
    once = outages(FAKE_STOPS_HOST, 2000, "host stops");
    CHECK(once == all, "%u of %u", once, all);
    outages(FAKE_STOPS_HOST, 30000, "host stops for long");
    test("a cable that dies at any report and comes back: the frame goes on, in the same session");
    once = outages(FAKE_ENDS, 1500, "the cable comes back");
    CHECK(once > all * 3 / 4, "%u of %u", once, all);
    outages(FAKE_ENDS, 30000, "... after long");
}

/* ---- a host that fails ------------------------------------------------------------------- */

static void expect_error(unsigned wanted, uint32_t at, const char *how) {
    unsigned code;
    char kind;
    wire_view_send(&e.view, &views[0]);
    const int came = frame_comes(40000, &code);
    const uint32_t place = wire_error_place(&e.host, &kind);
    CHECK(came == -1 && code == wanted, "%s %u: %d, code %u", how, at, came, code);
    CHECK(place < direct.image.size && (at == 1 || place > 0), "%s %u: byte %u", how, at, place);
}

static uint32_t fail_at; /* request from which on the host fails */
static unsigned fails;   /* how */
enum { IS_SILENT, REFUSES, LIES, LIES_ONCE };

static int is_serving(void) {
    int live = 0;
    for (unsigned i = 0; i < WIRE_BLOCKS; i++) {
        live |= e.blocks.order[i].live;
    }
    return live;
}

static void mend(void) {
    fail_at = UINT32_MAX;
    e.host.blocks_out = &e.blocks;
    e.blocks.bytes = (uint32_t)direct.image.size;
    memcpy(served, direct.image.bytes, direct.image.size);
}

/* What the host does is looked at after each step of the cable. */
static int failing_pump(void *context) {
    if (e.blocks.asked + 1 >= fail_at && fails == IS_SILENT) {
        e.host.blocks_out = NULL;
    } else if (e.blocks.asked + 1 >= fail_at && fails == REFUSES) {
        e.blocks.bytes = 0;
    } else if (e.blocks.asked + 1 >= fail_at) {
        for (uint32_t i = 0; i < direct.image.size; i++) {
            served[i] = (uint8_t)~direct.image.bytes[i];
        }
    }
    if (e.blocks.asked >= fail_at && fails == LIES_ONCE && !is_serving()) {
        mend();
    }
    fake_cable_step(context);
    return 0;
}

static void open_failing(uint32_t at, unsigned how) {
    open_pair(at, 0);
    fail_at = at;
    fails = how;
    e.device.pump = failing_pump;
}

static void test_hosts(void) {
    static const char *const names[] = {"silent", "refuses", "lies"};
    for (unsigned how = IS_SILENT; how <= LIES; how++) {
        test(how == IS_SILENT ? "a host that is silent from any request on: an error with the byte"
             : how == REFUSES ? "one that refuses from any request on: likewise"
                              : "one that lies from any request on: an error with rule and byte");
        for (uint32_t at = 1; at <= requests; at++) {
            open_failing(at, how);
            expect_error(how == LIES ? WIRE_E_SCENE : WIRE_E_SOURCE, at, names[how]);
            CHECK(how != LIES || e.host.other_detail >> 24 > 0, "%u: no rule", at);
            check_bounds(names[how], at);
            mend();
            if (how == LIES && at == 1) {
                continue; /* the header: this image is refused for good */
            }
            check_frame(1, names[how], at);
        }
    }
    test("one that lies once: the block is asked for again, and the frame is right");
    for (uint32_t at = 2; at <= requests; at++) {
        plt_stats stats;
        open_failing(at, LIES_ONCE);
        check_frame(0, "a lie", at);
        plt_stats_get(e.device.engine, &stats);
        CHECK(stats.fetch_retries >= 1, "%u: %llu retries", at,
              (unsigned long long)stats.fetch_retries);
    }
    test("a frame that fails is not counted as a whole one, and never has the mark of its view");
    for (uint32_t at = 1; at <= requests; at++) {
        unsigned code;
        open_failing(at, REFUSES);
        expect_error(WIRE_E_SOURCE, at, "refused");
        frame_comes(200, &code);
        CHECK(e.device.frames == 0 && !e.device.out.in_frame, "%u: counted", at);
        CHECK(wire_frames_mark(&e.frames) != e.view.view.number, "%u: shown", at);
        mend();
        check_frame(1, "after one that fails", at);
        CHECK(e.device.frames == 1, "%u: %u frames", at, e.device.frames);
    }
    test("the error is told again until the host has heard it");
    open_failing(requests / 2, REFUSES);
    expect_error(WIRE_E_SOURCE, 2, "again");
    unsigned code;
    CHECK(frame_comes(1000, &code) == -1 && code == WIRE_E_SOURCE, "not again");
}

/* ---- hosts that come and go ----------------------------------------------------------------- */

static int replacing_pump(void *context) {
    if (e.blocks.asked == fail_at) {
        fail_at = UINT32_MAX;
        wire_scene_out_open(&e.scene, &e.host, served, 1000); /* no whole image any more */
        wire_blocks_out_open(&e.blocks, &e.host, served, 1000);
    }
    fake_cable_step(context);
    return 0;
}

static void test_replaced(void) {
    test("another scene that is offered while a block is waited for ends the wait, and is taken");
    for (uint32_t at = 1; at <= requests; at++) {
        unsigned code;
        open_pair(at, 0);
        fail_at = at;
        e.device.pump = replacing_pump;
        wire_view_send(&e.view, &views[0]);
        CHECK(frame_comes(3000, &code) == -1 && code == WIRE_E_SCENE, "%u: code %u", at, code);
        CHECK(e.device.scene.bytes == 1000, "%u: not taken", at);
        e.blocks.asked = 0;
        wire_scene_out_open(&e.scene, &e.host, served, (uint32_t)direct.image.size);
        wire_blocks_out_open(&e.blocks, &e.host, served, (uint32_t)direct.image.size);
        check_frame(1, "after another", at);
        check_bounds("replaced", at);
    }
    test("a request for another image than the host's is not answered");
    open_pair(3, 0);
    e.blocks.crc ^= 1;
    expect_error(WIRE_E_SOURCE, 1, "another");
    CHECK(e.blocks.sent == 0, "it was");
}

static void test_streaming(void) {
    mesh m = {0};
    const compact_config config = compact_config_of(2, 14, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    shape_icosphere(&m, 3);
    CHECK(compact_open(&direct, &m, &config) == PLT_OK, "%s", direct.fault.message);
    CHECK(direct.image.size < IMAGE_MOST, "%u bytes", direct.image.size);
    render_direct(direct.engine, &views[0], due[0]);
    render_direct(direct.engine, &views[1], due[1]);
    test_good();
    test_strikes();
    test_silence();
    test_hosts();
    test_replaced();
    rig_close(&direct);
    mesh_free(&m);
}

int main(void) {
    test("a scene for a device that streams it");
    if (PLT_TILE_SIDE == WIRE_TILE_SIDE && PLT_WITH_STREAMED) {
        test_streaming();
    } else {
        CHECK(sizeof e.memory > MEMORY, "such a build has no device: test_wire_device");
    }
    return test_done();
}
