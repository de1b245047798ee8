/* test_wire_wrap - numbers of reports that pass 2^32
 *
 * A session reaches that number after months; here both peers are put there.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/wire_rig.h"
#include "tests/test.h"

static wire_rig rig;

static const rig_shape shape = {160, 128, WIRE_RGB565, 64, 64, 16, 0};

/* A session whose next reports have the number `next`, with nothing on the way. */
static void open_at(uint32_t next) {
    wire_rig_open(&rig, shape, 1);
    for (int ms = 0; ms < 300; ms++) {
        fake_cable_step(&rig.cable);
    }
    CHECK(wire_is_up(&rig.host) && wire_is_up(&rig.device), "no session");
    CHECK(rig.host.out_number == rig.device.in_number &&
              rig.device.out_number == rig.host.in_number,
          "reports are on the way");
    rig.host.out_number = rig.host.out_acked = rig.host.out_asks = rig.device.in_number = next;
    rig.device.out_number = rig.device.out_acked = rig.device.out_asks = rig.host.in_number = next;
}

/* Sends a data report every 5 ms that nobody answers; the milliseconds from the
 * first until the host asks for an acknowledgement, 0: never. */
static uint32_t first_ping(void) {
    uint8_t report[64];
    const uint32_t begun = rig.cable.now_ms + 1;
    for (uint32_t ms = 0; ms < 75; ms += 5) {
        const uint32_t pings = rig.host.stats.pings_out;
        wire_poll(&rig.host, begun + ms);
        wire_next_report(&rig.host, report, begun + ms);
        if (rig.host.stats.pings_out != pings) {
            return ms;
        }
    }
    return 0;
}

static void test_ping(void) {
    test("a silent peer is asked after WIRE_PING_MS, whatever the numbers of the reports");
    for (uint32_t before = 0; before < 24; before++) {
        open_at(12 - before);
        wire_rig_draw(&rig, 1);
        CHECK(wire_rig_show(&rig), "no session");
        const uint32_t ms = first_ping();
        CHECK(ms == WIRE_PING_MS, "%u ms when the first number is %d", ms, 12 - (int)before);
        wire_rig_close(&rig);
    }
}

/* The wait begins with the first report on the way, not with the last answer. */
static void test_no_early_ping(void) {
    test("nobody is asked before that, when what was asked for last has long been answered");
    for (uint32_t before = 0; before < 4; before++) {
        open_at(2 - before);
        rig.host.out_asks = 1 - before - 2; /* answered: the two reports since asked for nothing */
        wire_rig_draw(&rig, 1);
        CHECK(wire_rig_show(&rig), "no session");
        rig.host.asked_ms = rig.cable.now_ms - 10 * WIRE_PING_MS;
        const uint32_t ms = first_ping();
        CHECK(ms == WIRE_PING_MS, "%u ms when the first number is %d", ms, 2 - (int)before);
        wire_rig_close(&rig);
    }
}

static void test_frames(void) {
    test("frames that pass 2^32 come whole: one session, nothing lost, nothing sent twice");
    open_at(UINT32_MAX - 100);
    for (int kind = 0; kind < 3; kind++) {
        wire_rig_draw(&rig, kind);
        CHECK(wire_rig_show(&rig) && wire_rig_wait(&rig, 20000) >= 0, "not acknowledged");
        CHECK(wire_rig_differences(&rig) == 0, "%u bytes differ", wire_rig_differences(&rig));
    }
    CHECK(rig.host.out_number < 100000, "number %u: it did not wrap", rig.host.out_number);
    CHECK(rig.host.stats.sessions == 1 && rig.device.stats.sessions == 1 &&
              rig.device.stats.reports_lost == 0 && rig.host.stats.reports_lost == 0 &&
              rig.host.stats.frames_bad == 0,
          "%u sessions, %u reports lost", rig.host.stats.sessions, rig.device.stats.reports_lost);
    wire_rig_close(&rig);
}

int main(void) {
    test_ping();
    test_no_early_ping();
    test_frames();
    return test_done();
}
