/* test_board_fake - the fake source keeps the contract, and breaks it on order
 *
 * SPDX-License-Identifier: MIT */
#include "board/fake/fake.h"
#include "board/wired/serial.h"
#include "platform/wire/wire_bytes.h"
#include "tests/test.h"

static unsigned char image[256], to[256];

static fake_link fresh(enum fake_failure failure, uint32_t at_call) {
    for (unsigned i = 0; i < sizeof image; i++) {
        image[i] = (unsigned char)(i + 1);
    }
    memset(to, 0, sizeof to);
    fake_link link = {.image = image,
                      .bytes = sizeof image,
                      .arena = to,
                      .arena_bytes = sizeof to,
                      .failure = failure,
                      .at_call = at_call};
    return link;
}

/* Fetches 64 bytes four times; the number of the first failing fetch, or 0. */
static int fetch_all(fake_link *link) {
    const plt_source s = fake_source(link);
    for (int i = 0; i < 4; i++) {
        if (s.start(s.context, (unsigned)i, (uint32_t)i * 64, to + i * 64, 64) < 0 ||
            s.wait(s.context, 1u << i) < 0) {
            return i + 1;
        }
    }
    return 0;
}

static void test_works(void) {
    test("what works brings every byte, at the wait and not before");
    fake_link link = fresh(FAKE_WORKS, 0);
    const plt_source s = fake_source(&link);
    CHECK(s.start(s.context, 5, 0, to, 256) == 0, "start");
    CHECK(to[0] == 0xA5 && to[255] == 0xA5, "garbage before the wait");
    CHECK(fake_unfinished(&link) == 1, "one on its way");
    CHECK(s.wait(s.context, ~(1u << 5)) == 0 && to[0] == 0xA5, "other tags");
    CHECK(s.wait(s.context, 1u << 5) == 0 && memcmp(to, image, 256) == 0, "bytes");
    CHECK(fake_unfinished(&link) == 0 && link.broken == 0, "%u", link.broken);
    CHECK(link.starts == 1 && link.waits == 2 && link.bytes_moved == 256, "counts");
    link.at_once = 1;
    CHECK(s.start(s.context, 0, 16, to, 16) == 0 && memcmp(to, image + 16, 16) == 0, "at once");
}

static void test_failures(void) {
    test("each failure comes at the call it was ordered for, and at no other");
    for (uint32_t i = 1; i <= 4; i++) {
        fake_link link = fresh(FAKE_FAILS_AT_START, i);
        CHECK(fetch_all(&link) == (int)i && link.starts == i, "start %u", i);
        link = fresh(FAKE_FAILS_AT_WAIT, i);
        CHECK(fetch_all(&link) == (int)i && link.waits == i, "wait %u", i);
        link = fresh(FAKE_SHORT_AT_START, i);
        CHECK(fetch_all(&link) == (int)i && to[i * 64 - 1] == 0xA5 && to[i * 64 - 64] != 0xA5,
              "short %u", i);
    }
    for (uint32_t i = 1; i <= 8; i++) {
        fake_link link = fresh(FAKE_FAILS_AT_CALL, i);
        CHECK(fetch_all(&link) == (int)(i + 1) / 2, "call %u", i);
        CHECK(fetch_all(&link) == 0, "only once");
        link = fresh(FAKE_FAILS_FROM_CALL, i);
        CHECK(fetch_all(&link) == (int)(i + 1) / 2 && fetch_all(&link) == 1, "for good");
    }
    test("wrong and missing bytes go unnoticed by the source");
    for (uint32_t i = 1; i <= 4; i++) {
        fake_link link = fresh(FAKE_GARBLED_AT_START, i);
        unsigned wrong = 0;
        CHECK(fetch_all(&link) == 0, "status");
        for (unsigned k = 0; k < 256; k++) {
            wrong += image[k] != to[k];
        }
        CHECK(wrong == 1, "%u wrong bytes", wrong);
        link = fresh(FAKE_SILENT_AT_START, i);
        CHECK(fetch_all(&link) == 0 && to[i * 64 - 64] == 0xA5, "silent %u", i);
    }
}

static void test_slips(void) {
    test("a byte that is lost moves those behind it up, one that comes twice moves them down");
    for (uint32_t i = 1; i <= 4; i++) {
        fake_link link = fresh(FAKE_LOSES_BYTE, i);
        const unsigned char *part = to + i * 64 - 64, *due = image + i * 64 - 64;
        unsigned at = 0;
        CHECK(fetch_all(&link) == 0, "the wait is content");
        while (at < 63 && part[at] == due[at]) {
            at++;
        }
        CHECK(memcmp(part + at, due + at + 1, 63 - at) == 0 && part[63] == 0xA5, "lost at %u", at);
        link = fresh(FAKE_REPEATS_BYTE, i);
        CHECK(fetch_all(&link) == 0, "the wait is content");
        for (at = 0; at < 63 && part[at] == due[at];) {
            at++;
        }
        CHECK(at > 0 && memcmp(part + at, due + at - 1, 64 - at) == 0, "twice at %u", at);
    }
}

static void test_order(void) {
    test("a transfer that never ends fails every wait for its tag, and no other");
    fake_link link = fresh(FAKE_NEVER_ENDS, 2);
    const plt_source s = fake_source(&link);
    CHECK(fetch_all(&link) == 2, "the second");
    CHECK(s.start(s.context, 0, 0, to, 64) == 0 && s.wait(s.context, 1) == 0, "another tag");
    CHECK(s.start(s.context, 1, 0, to, 64) == 0 && s.wait(s.context, 2) < 0, "its tag, again");
    CHECK(fake_unfinished(&link) == 0 && link.broken == 0, "nothing is on its way");
    test("a source that is busy is so for two starts");
    link = fresh(FAKE_STALLS_AT_START, 2);
    CHECK(fetch_all(&link) == 2 && fetch_all(&link) == 1 && fetch_all(&link) == 0, "%u starts",
          link.starts);
    test("transfers that end in the other order: of one tag to one place the first is left");
    link = fresh(FAKE_LAST_FIRST, 0);
    CHECK(s.start(s.context, 3, 0, to, 64) == 0 && s.start(s.context, 3, 64, to, 64) == 0, "two");
    CHECK(s.wait(s.context, 1u << 3) == 0 && memcmp(to, image, 64) == 0, "the first was last");
    link = fresh(FAKE_WORKS, 0);
    CHECK(s.start(s.context, 3, 0, to, 64) == 0 && s.start(s.context, 3, 64, to, 64) == 0, "two");
    CHECK(s.wait(s.context, 1u << 3) == 0 && memcmp(to, image + 64, 64) == 0, "else it is first");
}

static void test_names(void) {
    test("every mode has a name of its own");
    for (unsigned i = 0; i < FAKE_FAILURES; i++) {
        for (unsigned k = 0; k < i; k++) {
            CHECK(strcmp(fake_failure_name[i], fake_failure_name[k]) != 0, "%u, %u", i, k);
        }
    }
    for (unsigned i = 0; i < FAKE_BOARD_FAILURES; i++) {
        CHECK(fake_board_failure_name[i], "board %u", i);
    }
    for (unsigned i = 0; i < FAKE_LINE_FAILURES; i++) {
        CHECK(fake_line_failure_name[i], "line %u", i);
    }
}

/* Two frames of a pixel or two, and what went wrong with them. */
static void test_frames(void) {
    static const uint8_t red[6] = {255, 0, 0, 255, 0, 0}, green[3] = {0, 255, 0};
    const plt_tile wide = {red, 0, 0, 2, 1}, left = {green, 0, 0, 1, 1},
                   right = {green, 1, 0, 1, 1};
    test("every frame is kept, with every byte of it");
    fake_reset();
    CHECK(board_frame_begin(2, 1) == 0, "begin");
    board_tile(&wide);
    CHECK(board_frame_end("") != NULL, "end");
    CHECK(board_frame_begin(2, 1) == 0, "begin");
    board_tile(&right);
    board_tile(&left);
    CHECK(board_frame_end("") == fake.frames[1].rgb, "end");
    CHECK(memcmp(fake.frames[0].rgb, red, 6) == 0 && fake.frames[0].tiles == 1, "the first");
    CHECK(memcmp(fake.frames[1].rgb, green, 3) == 0 && fake.frames[1].tiles == 2, "the second");
    CHECK(memcmp(fake.frames[1].rgb + 3, green, 3) == 0 && fake.broken == 0, "%u", fake.broken);
    test("a program that breaks the contract of board.h is found out");
    board_tile(&left);
    CHECK(fake.broken == 1, "a tile behind the end");
    board_frame_end("");
    CHECK(fake.broken == 2, "an end without a beginning");
    board_frame_begin(2, 1);
    board_tile(&left);
    board_tile(&left);
    CHECK(fake.broken == 3, "a pixel twice");
    board_frame_end("");
    CHECK(fake.broken == 4, "a pixel that never came");
    board_frame_begin(1, 1);
    board_tile(&wide);
    CHECK(fake.broken == 5, "a tile that leaves the frame");
    board_frame_begin(1, 1);
    CHECK(fake.broken == 6, "a frame in a frame");
    test("a board fails in each of its ways, and in no other");
    for (unsigned i = 0; i < FAKE_BOARD_FAILURES; i++) {
        size_t bytes;
        plt_source source;
        fake_reset();
        fake.failure = (enum fake_board_failure)i;
        const unsigned char *arena = board_arena(&bytes);
        const char *name = fake_board_failure_name[i];
        CHECK((board_scene("", &source) < 0) == (i == FAKE_HAS_NO_SCENE), "%s", name);
        CHECK((bytes == FAKE_SMALL_BYTES) == (i == FAKE_ARENA_IS_SMALL), "%s", name);
        CHECK((arena == NULL) == (i == FAKE_ARENA_IS_NULL), "%s", name);
        CHECK(((uintptr_t)arena % PLT_ALIGN != 0) == (i == FAKE_ARENA_IS_SHIFTED), "%s", name);
        const uint32_t first = board_ticks(), second = board_ticks();
        CHECK((first == second) == (i == FAKE_CLOCK_STANDS), "%s", name);
        CHECK((second < first) == (i == FAKE_CLOCK_WRAPS), "%s", name);
        CHECK((board_frame_begin(1, 1) < 0) == (i == FAKE_REFUSES_FRAME), "%s", name);
        if (i != FAKE_REFUSES_FRAME) {
            board_tile(&left);
            CHECK((board_frame_end("") == NULL) == (i == FAKE_KEEPS_NO_FRAME), "%s", name);
        }
    }
}

/* ---- the line of bytes -------------------------------------------------------- */

enum { REPORTS = 3, BYTES_EACH = 12 };

/* Three reports on the line; returns their bytes there, each. */
static uint32_t send_reports(enum fake_line_failure failure, uint32_t at) {
    memset(&fake_line, 0, sizeof fake_line);
    for (unsigned r = 0; r < REPORTS; r++) {
        uint8_t report[BYTES_EACH];
        memset(report, (int)(r + 1), sizeof report);
        fake_line.in_bytes +=
            (uint32_t)wire_bytes_put(fake_line.in + fake_line.in_bytes, report, sizeof report);
    }
    fake_line.failure = failure;
    fake_line.at = at;
    fake_line.room_bytes = 64;
    CHECK(board_serial_open() == 64, "room");
    return fake_line.in_bytes / REPORTS;
}

/* Which of them arrive as they were sent, a bit each. */
static unsigned get_reports(void) {
    static wire_bytes_reader reader;
    unsigned whole = 0;
    memset(&reader, 0, sizeof reader);
    for (unsigned call = 0; call < 1000; call++) {
        const int byte = board_serial_get();
        if (byte < 0 || wire_bytes_read(&reader, (uint8_t)byte) != BYTES_EACH) {
            continue;
        }
        unsigned same = 0;
        for (unsigned i = 0; i < BYTES_EACH; i++) {
            same += reader.report[i] == reader.report[0];
        }
        whole |= same == BYTES_EACH && reader.report[0] >= 1 && reader.report[0] <= REPORTS
                     ? 1u << (reader.report[0] - 1)
                     : 0;
    }
    return whole;
}

/* What is left of three reports when byte `at` fails so: those behind its own arrive, but of a line
 * that dies, and of two that grow together, when what is missing is the zero between them. */
static unsigned due(enum fake_line_failure failure, uint32_t at, uint32_t bytes_each) {
    const unsigned own = (at - 1) / bytes_each;
    switch (failure) {
    case FAKE_LINE_WORKS:
    case FAKE_LINE_STALLS:
    case FAKE_LINE_FILLS:
        return 7;
    case FAKE_LINE_DIES:
        return (1u << own) - 1;
    default:
        return 7u & ~(1u << own);
    }
}

static void test_line(void) {
    test("a line of bytes fails in each of its ways, at every byte");
    for (unsigned i = 0; i < FAKE_LINE_FAILURES; i++) {
        const enum fake_line_failure failure = (enum fake_line_failure)i;
        for (uint32_t at = 1; at <= REPORTS * (BYTES_EACH + 2); at++) {
            const uint32_t each = send_reports(failure, at);
            const int is_end = at % each == 0; /* the zero between two reports */
            const unsigned got = get_reports(), want = due(failure, at, each);
            const unsigned next = is_end ? 1u << at / each : 0;
            CHECK((got & ~(is_end ? 1u << (at / each - 1) | next : 0)) ==
                      (want & ~(is_end ? 1u << (at / each - 1) | next : 0)),
                  "a line that %s at byte %u: %x", fake_line_failure_name[i], at, got);
            CHECK(fake_line.lost == (failure == FAKE_LINE_LOSES) && fake_line.broken == 0,
                  "%u lost", fake_line.lost);
        }
    }
    test("what is sent is recorded, and a line that is full says so for a while");
    send_reports(FAKE_LINE_FILLS, 2);
    unsigned refused = 0;
    for (uint8_t byte = 7; byte < 10; byte++) {
        while (!board_serial_put(byte)) {
            refused++;
        }
    }
    CHECK(refused == FAKE_STALL_CALLS && fake_line.out_bytes == 3 && fake_line.out[2] == 9, "%u",
          refused);
    memset(&fake_line, 0, sizeof fake_line);
    CHECK(board_serial_get() < 0 && board_serial_put(1) == 0 && fake_line.broken == 2, "not open");
}

static void test_contract(void) {
    test("a caller that breaks the contract is refused and counted");
    fake_link link = fresh(FAKE_WORKS, 0);
    const plt_source s = fake_source(&link);
    CHECK(s.start(s.context, 32, 0, to, 16) < 0 && link.broken == 1, "tag 32");
    CHECK(s.start(s.context, 0, 250, to, 7) < 0 && link.broken == 2, "beyond the end");
    CHECK(s.start(s.context, 0, 0xFFFFFFF0u, to, 0x20) < 0 && link.broken == 3, "wrapped");
    CHECK(s.start(s.context, 0, 249, to + 249, 8) < 0 && link.broken == 4, "outside the arena");
    CHECK(s.start(s.context, 0, 0, to, 0) < 0 && link.broken == 5, "nothing");
    CHECK(link.sentence != NULL, "a sentence");
}

int main(void) {
    test_works();
    test_failures();
    test_slips();
    test_order();
    test_contract();
    test_names();
    test_frames();
    test_line();
    return test_done();
}
