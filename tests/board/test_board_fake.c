/* test_board_fake - the fake source keeps the contract, and breaks it on order
 *
 * SPDX-License-Identifier: MIT */
#include "board/fake/fake.h"
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
    test_contract();
    return test_done();
}
