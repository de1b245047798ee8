/* test_board_firmware - the firmware of every board, run on the fake board
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "board/fake/fake.h"
#include "board/hash.h"
#include "host_tools/pack/pack.h"
#include "host_tools/scenes/scenes.h"
#include "tests/test.h"

static packed scene;

static fake_link fresh(enum fake_failure failure, uint32_t at_call) {
    size_t arena_bytes;
    const fake_link link = {.image = scene.bytes,
                            .bytes = scene.size,
                            .arena = board_arena(&arena_bytes),
                            .arena_bytes = FAKE_ARENA_BYTES,
                            .failure = failure,
                            .at_call = at_call};
    return link;
}

static int run_mapped(const char *parameters) {
    fake_reset();
    fake.source.mapped = scene.bytes;
    fake.source.bytes = scene.size;
    return firmware(parameters);
}

static int run_fetched(fake_link *link, const char *parameters) {
    fake_reset();
    fake.source = fake_source(link);
    return firmware(parameters);
}

static uint64_t frame_hash(void) {
    const fake_frame *f = fake_last_frame();
    return hash_bytes(f->rgb, 3u * f->width * f->height);
}

/* On a board that fails so. */
static int run_failing(enum fake_board_failure failure, const char *parameters) {
    fake_reset();
    fake.source.mapped = scene.bytes;
    fake.source.bytes = scene.size;
    fake.failure = failure;
    return firmware(parameters);
}

/* The value of name=value or NAME=hex in the printed text; 0 when absent. */
static unsigned long long printed(const char *name, int base) {
    const char *at = strstr(fake.text, name);
    return at ? strtoull(at + strlen(name), NULL, base) : 0;
}

static void test_frame(void) {
    test("a frame of odd size arrives whole, each pixel once, and its hash is printed");
    CHECK(run_mapped("size=77x53") == FIRMWARE_DONE, "%s", fake.text);
    const fake_frame *f = fake_last_frame();
    CHECK(f->width == 77 && f->height == 53, "%ux%u", f->width, f->height);
    CHECK(fake.frames_begun == 1 && fake.frames_ended == 1, "%u frames", fake.frames_begun);
    CHECK(fake.broken == 0, "the firmware broke the contract: %s", fake.sentence);
    CHECK(printed("frame_hash=", 16) == frame_hash(), "%s", fake.text);
    CHECK(printed("rays=", 10) == 77 * 53, "%s", fake.text);
    CHECK(printed("tiles=", 10) == fake.tile_count, "%s", fake.text);
    CHECK(frame_hash() != hash_bytes(f->rgb, 3), "a picture");
    test("a board that keeps no frame gets no hash, and all else");
    CHECK(run_failing(FAKE_KEEPS_NO_FRAME, "size=16x16") == FIRMWARE_DONE, "%s", fake.text);
    CHECK(!strstr(fake.text, "frame_hash") && strstr(fake.text, "stats"), "%s", fake.text);
}

static void test_same_picture(void) {
    test("packet side, order, step length and source do not change the picture");
    run_mapped("size=60x44");
    const uint64_t want = frame_hash();
    static const char *const ways[] = {
        "packet=2",          "packet=4",      "packet=8",          "walk=two",
        "walk=two packet=2", "visits=1",      "visits=4000000000", "walk=depth visits=7",
        "structure=grid",    "structure=tree"};
    char line[80];
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        const char *packet = strstr(ways[i], "packet=");
        if (packet && packet[7] - '0' > PLT_PACKET_SIDE_MAX) {
            continue; /* the tiny build */
        }
        snprintf(line, sizeof line, "size=60x44 %s", ways[i]);
        CHECK(run_mapped(line) == FIRMWARE_DONE && frame_hash() == want, "%s", ways[i]);
        fake_link link = fresh(FAKE_WORKS, 0);
        CHECK(run_fetched(&link, line) == FIRMWARE_DONE && frame_hash() == want, "fetched %s: %s",
              ways[i], fake.text);
        CHECK(link.broken == 0, "%s", link.sentence);
        CHECK(fake_unfinished(&link) == 0, "%u transfers never waited for", fake_unfinished(&link));
    }
}

static void test_camera(void) {
    test("a camera in decimal and the same in bits give the same picture");
    CHECK(run_mapped("size=40x30 eye=1.5,40,60 look=0,0.25,0 up=0,1,0 tan=0.5") == FIRMWARE_DONE,
          "%s", fake.text);
    const uint64_t want = frame_hash();
    CHECK(run_mapped("size=40x30 eye=0x3fc00000,0x42200000,0x42700000 look=0x0,0x3e800000,0x0 "
                     "up=0x0,0x3f800000,0x0 tan=0x3f000000") == FIRMWARE_DONE,
          "%s", fake.text);
    CHECK(frame_hash() == want, "pictures differ");
    test("shaders differ");
    run_mapped("size=40x30 shader=eyelight");
    const uint64_t eyelight = frame_hash();
    run_mapped("size=40x30 shader=normal");
    CHECK(frame_hash() != eyelight, "normal is eyelight");
    run_mapped("size=40x30 shader=triangle");
    CHECK(frame_hash() != eyelight, "triangle is eyelight");
}

static void test_usage(void) {
    test("a wrong parameter is named, and ends with status 2 before anything is drawn");
    static const char *const wrong[] = {
        "size=0x10",  "size=10",        "size=65536x1", "size=axb",  "eye=1,2",    "eye=1,2,3,4",
        "eye=1,2,x",  "tan=",           "packet=32",    "packet=-4", "walk=three", "shader=pink",
        "visits=0",   "arena=99999999", "colour=red",   "size",      "up=nan,0,0", "=3",
        "frames=0:3", "structure=cube", "show=a"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        CHECK(run_mapped(wrong[i]) == FIRMWARE_USAGE, "%s: %s", wrong[i], fake.text);
        CHECK(strncmp(fake.text, "error: ", 7) == 0, "%s: %s", wrong[i], fake.text);
        CHECK(strchr(fake.text, '\n') == fake.text + fake.text_used - 1, "one line");
        CHECK(fake.frames_begun == 0, "%s", wrong[i]);
    }
}

static void test_arena(void) {
    char line[80];
    test("an arena that is too small is refused with the bytes that are enough");
    CHECK(run_mapped("arena=1000") == FIRMWARE_FAILED, "%s", fake.text);
    const unsigned long long need = printed("need_bytes=", 10);
    CHECK(need > 1000, "%s", fake.text);
    snprintf(line, sizeof line, "size=20x20 arena=%llu", need);
    CHECK(run_mapped(line) == FIRMWARE_DONE, "%llu were not enough: %s", need, fake.text);
    CHECK(printed("peak=", 10) <= need, "%s", fake.text);
}

static void test_failures(void) {
    test("garbage for an image, no image, no room for the frame: one line, status 1");
    static _Alignas(PLT_ALIGN) unsigned char garbage[4096];
    fake_reset();
    fake.source.mapped = garbage;
    fake.source.bytes = sizeof garbage;
    CHECK(firmware("") == FIRMWARE_FAILED && strstr(fake.text, "rule=R"), "%s", fake.text);
    CHECK(run_failing(FAKE_HAS_NO_SCENE, "") == FIRMWARE_FAILED && strstr(fake.text, "error: "),
          "%s", fake.text);
    CHECK(run_failing(FAKE_REFUSES_FRAME, "") == FIRMWARE_FAILED && strstr(fake.text, "error: "),
          "%s", fake.text);
    CHECK(fake.tile_count == 0 && fake.frames_ended == 0, "tiles");
}

static void test_board_fails(void) {
    test("an arena that is small, not aligned or not there is refused by one line");
    CHECK(run_failing(FAKE_ARENA_IS_SMALL, "size=16x16") == FIRMWARE_FAILED, "%s", fake.text);
    CHECK(printed("need_bytes=", 10) > FAKE_SMALL_BYTES &&
              printed("arena_bytes=", 10) == FAKE_SMALL_BYTES,
          "both sizes: %s", fake.text);
    static const enum fake_board_failure wrong[] = {FAKE_ARENA_IS_SHIFTED, FAKE_ARENA_IS_NULL};
    for (unsigned i = 0; i < 2; i++) {
        CHECK(run_failing(wrong[i], "size=16x16") == FIRMWARE_FAILED &&
                  strstr(fake.text, "error: ") && fake.frames_begun == 0,
              "a board that %s: %s", fake_board_failure_name[wrong[i]], fake.text);
    }
    test("a clock that stands or wraps changes the time alone");
    run_mapped("size=16x16");
    const uint64_t want = frame_hash();
    const unsigned long long ticks = printed(" ticks=", 10);
    CHECK(run_failing(FAKE_CLOCK_WRAPS, "size=16x16") == FIRMWARE_DONE && frame_hash() == want &&
              printed(" ticks=", 10) == ticks,
          "%s", fake.text);
    CHECK(run_failing(FAKE_CLOCK_STANDS, "size=16x16") == FIRMWARE_DONE && frame_hash() == want &&
              printed(" ticks=", 10) == 0,
          "%s", fake.text);
    CHECK(fake.broken == 0, "%s", fake.sentence);
}

static void test_source_fails(void) {
    fake_link link = fresh(FAKE_WORKS, 0);
    run_fetched(&link, "size=16x16");
    const uint64_t want = frame_hash();
    const uint32_t calls = link.starts + link.waits;
    test("a source that fails at its i-th call is reported, for every i");
    for (uint32_t i = 1; i <= calls; i++) {
        link = fresh(FAKE_FAILS_AT_CALL, i);
        CHECK(run_fetched(&link, "size=16x16") == FIRMWARE_FAILED, "call %u of %u", i, calls);
        CHECK(strstr(fake.text, "error: "), "%s", fake.text);
        CHECK(link.broken == 0, "call %u: %s", i, link.sentence);
    }
    test("a source that comes up short at its i-th transfer is reported, for every i");
    const uint32_t starts = link.starts;
    for (uint32_t i = 1; i <= starts; i++) {
        link = fresh(FAKE_SHORT_AT_START, i);
        CHECK(run_fetched(&link, "size=16x16") == FIRMWARE_FAILED, "start %u", i);
    }
    test("transfers that end in the other order are as good as others");
    link = fresh(FAKE_LAST_FIRST, 0);
    CHECK(run_fetched(&link, "size=16x16") == FIRMWARE_DONE && frame_hash() == want, "%s",
          fake.text);
    test("a source whose i-th transfer never ends is reported, for every i");
    for (uint32_t i = 1; i <= starts; i++) {
        link = fresh(FAKE_NEVER_ENDS, i);
        CHECK(run_fetched(&link, "size=16x16") == FIRMWARE_FAILED && link.broken == 0, "start %u",
              i);
    }
    link = fresh(FAKE_WORKS, 0);
    run_fetched(&link, "size=16x16");
    test("one wrong bit in any transfer is found out, or was never looked at");
    for (uint32_t i = 1; i <= link.starts; i++) {
        fake_link bad = fresh(FAKE_GARBLED_AT_START, i);
        const int status = run_fetched(&bad, "size=16x16");
        CHECK(status == FIRMWARE_FAILED || frame_hash() == want, "start %u went unnoticed", i);
    }
    test("a byte that is lost or comes twice is found out, or was never looked at");
    static const enum fake_failure slips[] = {FAKE_LOSES_BYTE, FAKE_REPEATS_BYTE};
    for (uint32_t i = 1; i <= 2 * link.starts; i++) {
        fake_link bad = fresh(slips[i % 2], (i + 1) / 2);
        const int status = run_fetched(&bad, "size=16x16");
        CHECK(status == FIRMWARE_FAILED || frame_hash() == want, "a source that %s went unnoticed",
              fake_failure_name[bad.failure]);
    }
}

/* Rendered while its parts come, some ahead: what fails once is fetched again, and what fails for
 * good is said; a picture is never another. */
static void test_streamed(void) {
    static const char parameters[] = "size=24x16 residency=streamed prefetch=8";
    static const enum fake_failure once[] = {FAKE_STALLS_AT_START, FAKE_LOSES_BYTE,
                                             FAKE_REPEATS_BYTE, FAKE_SHORT_AT_START};
    run_mapped("size=24x16");
    const uint64_t want = frame_hash();
    fake_link link = fresh(FAKE_WORKS, 0);
    test("a streamed scene gives the same picture, in whatever order transfers end");
    CHECK(run_fetched(&link, parameters) == FIRMWARE_DONE && frame_hash() == want, "%s", fake.text);
    const uint32_t starts = link.starts;
    link = fresh(FAKE_LAST_FIRST, 0);
    CHECK(run_fetched(&link, parameters) == FIRMWARE_DONE && frame_hash() == want, "%s", fake.text);
    CHECK(link.pending_most > 1, "only one at a time");
    test("what fails once is got over, but at the header; what never ends is said");
    for (unsigned k = 0; k < sizeof once / sizeof *once; k++) {
        unsigned got_over = 0;
        for (uint32_t i = 1; i <= starts; i++) {
            link = fresh(once[k], i);
            const int is_done = run_fetched(&link, parameters) == FIRMWARE_DONE;
            CHECK(!is_done || frame_hash() == want, "a source that %s: another picture, start %u",
                  fake_failure_name[once[k]], i);
            CHECK(link.broken == 0 && fake_unfinished(&link) == 0, "%s", link.sentence);
            got_over += is_done;
        }
        CHECK(got_over > starts / 2 && got_over + 4 >= starts, "a source that %s: %u of %u",
              fake_failure_name[once[k]], got_over, starts);
    }
    for (uint32_t i = 1; i <= starts; i++) {
        link = fresh(FAKE_NEVER_ENDS, i);
        const int is_done = run_fetched(&link, parameters) == FIRMWARE_DONE;
        CHECK(is_done ? frame_hash() == want : strstr(fake.text, "error: ") != NULL, "start %u", i);
        CHECK(link.broken == 0 && fake_unfinished(&link) == 0, "%s", link.sentence);
    }
}

int main(void) {
    const int tiny = PLT_GLOBAL_STACK_MAX < 100; /* the tiny build */
    fail f = {""};
    mesh m = {0};
    const pack_options options = {.leaf_triangles = tiny ? 4 : 2, .treelet_nodes = 64};
    test("a scene to render is made and packed");
    CHECK(scene_knot(&m, tiny ? 24 : 600, &f) == 0, "%s", f.text);
    CHECK(pack_mesh(&scene, &m, &options, "knot", &f) == 0, "%s", f.text);
    mesh_free(&m);
    if (scene.size) {
        test_frame();
        test_same_picture();
        test_camera();
        test_usage();
        test_arena();
        test_failures();
        test_board_fails();
        test_source_fails();
        if (!tiny) { /* whose 24 triangles come with the header, or soon after */
            test_streamed();
        }
    }
    pack_free(&scene);
    return test_done();
}
