/* test_wire_rate - as many frames per second as asked for, by being off
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/tiles_out.h"
#include "tests/reference/wire_rig.h"
#include "tests/test.h"

static wire_rig rig;

static int up(uint32_t most) {
    while (most-- > 0 && !(wire_is_up(&rig.host) && wire_is_up(&rig.device))) {
        fake_cable_step(&rig.cable);
    }
    return wire_is_up(&rig.host) && wire_is_up(&rig.device);
}

/* Shows `count` frames, each when the one before has been handed over, and
 * returns the milliseconds from the `from`-th on. */
static uint32_t show_film(int kind, unsigned count, unsigned from) {
    uint32_t ms = 0;
    for (unsigned i = 0; i < count; i++) {
        wire_rig_draw(&rig, kind);
        CHECK(wire_rig_show(&rig), "no session");
        for (uint32_t t = 0; t < 2000 && !wire_frames_out_idle(&rig.out); t++) {
            fake_cable_step(&rig.cable);
            ms += i >= from;
        }
    }
    return ms;
}

static void open_film(unsigned format, unsigned goal) {
    const rig_shape shape = {96, 80, format, 64, 64, 16, 1};
    wire_rig_open(&rig, shape, 8);
    rig.cable.paced = 1;
    wire_frames_rate(&rig.out, goal);
    CHECK(up(300), "no session");
}

/* `exact_ms`: of ten exact frames. */
static void rate_of(unsigned format, uint32_t exact_ms) {
    open_film(format, 5000 / exact_ms);
    show_film(1, 20, 10);
    CHECK(rig.out.near == 0, "format %u, half of what is there: near %u", format, rig.out.near);
    wire_rig_close(&rig);
    const unsigned goal = 13000 / exact_ms;
    open_film(format, goal);
    const uint32_t ms = show_film(1, 20, 10);
    CHECK(rig.out.near > 0 && ms * goal <= 10500, "format %u: near %u, 10 frames in %u ms", format,
          rig.out.near, ms);
    CHECK(wire_rig_differences(&rig) > 0, "nothing was near");
    CHECK(wire_rig_wait(&rig, 3000) >= 0, "not refined");
    CHECK(wire_rig_differences(&rig) == 0, "%u bytes differ", wire_rig_differences(&rig));
    show_film(2, 20, 0);
    CHECK(rig.out.near == 0, "format %u: near %u for a few pixels", format, rig.out.near);
    CHECK(wire_rig_wait(&rig, 3000) >= 0 && wire_rig_differences(&rig) == 0, "not exact");
    wire_rig_close(&rig);
}

static void test_rate(void) {
    test(
        "a goal of frames per second is kept by being off, where it must be; at rest the picture "
        "is exact");
    for (unsigned format = WIRE_RGB565; format <= WIRE_GREY8; format++) {
        open_film(format, 0);
        const uint32_t exact_ms = show_film(1, 20, 10);
        CHECK(rig.out.near == 0, "exact: near %u", rig.out.near);
        wire_rig_close(&rig);
        rate_of(format, exact_ms);
    }
    test("a link too slow for the goal shows fewer frames, not ones without colours");
    open_film(WIRE_RGB565, 100);
    show_film(1, 20, 0);
    CHECK(rig.out.near == 6, "near %u", rig.out.near);
    wire_rig_close(&rig);
}

/* `near` after a pass that took `ms`, with `near` before and this goal. */
static unsigned near_after(unsigned near, unsigned goal_fps, uint32_t ms) {
    static wire_peer peer;
    static wire_frames_out out;
    out = (wire_frames_out){.peer = &peer, .format = WIRE_GREY8, .tiles = 1};
    wire_frames_rate(&out, goal_fps);
    out.near = (uint8_t)near;
    wire_rate_begin(&out);
    peer.now_ms += ms;
    wire_rate_end(&out, out.tiles);
    return out.near;
}

static void test_rate_steps(void) {
    test("a pass longer than the goal is one step up, longer than double two, to the ms");
    CHECK(near_after(0, 100, 10) == 0 && near_after(0, 100, 11) == 1, "the goal");
    CHECK(near_after(0, 100, 20) == 1 && near_after(0, 100, 21) == 2, "double");
    test("less than three quarters of it are one step down, also of a goal of 1 ms");
    CHECK(near_after(4, 100, 8) == 4 && near_after(4, 100, 7) == 3, "three quarters");
    CHECK(near_after(3, 1000, 1) == 3 && near_after(3, 1000, 0) == 2, "three quarters of 1 ms");
    test("goals beyond the resolution of a clock of milliseconds are 1 ms, not none");
    CHECK(near_after(0, 5000, 2) == 1 && near_after(0, 5000, 1) == 0, "5000 per second");
    CHECK(near_after(0, 0, 100) == 0, "no goal");
}

int main(void) {
    test_rate();
    test_rate_steps();
    return test_done();
}
