/* test_base_counters - what is counted, or not granted
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/base/counters.h"
#include "tests/test.h"

static volatile unsigned sink;

/* At least four instructions per round. */
static void work(unsigned rounds) {
    for (unsigned i = 0; i < rounds; i++) {
        sink = sink + i;
    }
}

int main(void) {
    counters c;
    test("each count is granted, or it is said why not");
    const int granted = counters_open(&c);
    int files = 0;
    for (int i = 0; i < COUNTERS; i++) {
        files += c.file[i] >= 0;
    }
    CHECK(granted == files, "%d granted, %d files", granted, files);
    CHECK((granted == COUNTERS) == (c.why == NULL), "%d granted, %s", granted, c.why ? c.why : "");
    test("only what runs between go and stop counts, and it adds up");
    counters_clear(&c);
    work(1000000);
    counters_go(&c);
    work(100000);
    counters_stop(&c);
    const uint64_t once = c.count[COUNTER_INSTRUCTIONS];
    counters_go(&c);
    work(100000);
    counters_stop(&c);
    const uint64_t twice = c.count[COUNTER_INSTRUCTIONS];
    if (c.file[COUNTER_INSTRUCTIONS] >= 0) {
        CHECK(once >= 400000 && once < 2000000, "%llu", (unsigned long long)once);
        CHECK(twice > once + once / 2, "%llu after %llu", (unsigned long long)twice,
              (unsigned long long)once);
    } else {
        CHECK(once == 0 && twice == 0, "counted without a counter");
    }
    test("cleared is nothing");
    counters_clear(&c);
    CHECK(c.count[COUNTER_INSTRUCTIONS] == 0 && c.count[COUNTER_CYCLES] == 0, "something");
    counters_close(&c);
    counters_close(&c);
    return test_done();
}
