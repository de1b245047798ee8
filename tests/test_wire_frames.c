/* test_wire_frames - frames over a good and a bad cable, pixel by pixel
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

static void show_and_compare(int kind, uint32_t most) {
    wire_rig_draw(&rig, kind);
    CHECK(wire_rig_show(&rig), "no session");
    const int ms = wire_rig_settle(&rig, most);
    CHECK(ms >= 0, "not acknowledged");
    CHECK(wire_rig_differences(&rig) == 0, "%u bytes differ", wire_rig_differences(&rig));
    CHECK(rig.wrong_rows == 0, "%u rows of no frame", rig.wrong_rows);
}

static void test_all_sizes(void) {
    static const unsigned sizes[] = {8, 9, 16, 32, 63, 64, 127, 128, 129, 512, 1023, 1024};
    test(
        "in all formats and report sizes every pixel is equal once acknowledged; one session, "
        "nothing lost, nothing sent twice");
    for (unsigned i = 0; i < 12; i++) {
        for (unsigned format = 0; format < WIRE_FORMATS; format++) {
            const rig_shape shape = {
                43, 37, format, sizes[i], sizes[i] < 64 ? sizes[i] : 64, 16, (int)(i + format) & 1};
            wire_rig_open(&rig, shape, i);
            CHECK(up(300), "reports of %u bytes: no session", sizes[i]);
            for (int kind = 0; kind < 3; kind++) {
                show_and_compare(kind, 20000);
            }
            CHECK(rig.host.stats.sessions == 1 && rig.device.stats.reports_lost == 0 &&
                      rig.host.stats.frames_bad == 0 && rig.host.stats.frames_out == 3 &&
                      wire_frames_shown(&rig.in) == 3,
                  "%u sessions, %u frames", rig.host.stats.sessions, rig.host.stats.frames_out);
            wire_rig_close(&rig);
        }
    }
}

static void test_latest_wins(void) {
    const rig_shape shape = {160, 128, WIRE_RGB565, 64, 64, 16, 0};
    test("a frame shown while another is on its way wins: the old one's end is not waited for");
    wire_rig_open(&rig, shape, 3);
    rig.cable.paced = 1;
    CHECK(up(300), "no session");
    for (int i = 0; i < 20; i++) {
        wire_rig_draw(&rig, 1);
        CHECK(wire_rig_show(&rig), "no session");
        for (int ms = 0; ms < 10; ms++) { /* a frame of noise needs 700 */
            fake_cable_step(&rig.cable);
        }
    }
    const int ms = wire_rig_settle(&rig, 2000);
    CHECK(ms > 0 && ms < 1000, "%d ms for the last of 20", ms);
    CHECK(wire_rig_differences(&rig) == 0, "%u bytes differ", wire_rig_differences(&rig));
    test("an unchanged frame costs its end and the tile that is refreshed");
    const uint32_t tiles = rig.host.stats.tiles_out;
    wire_rig_draw(&rig, 3);
    memcpy(rig.rgb, rig.spare, 3 * 160 * 128);
    CHECK(wire_rig_show(&rig) && wire_rig_settle(&rig, 100) >= 0, "not acknowledged");
    CHECK(rig.host.stats.tiles_out == tiles + 1, "%u tiles", rig.host.stats.tiles_out - tiles);
    wire_rig_close(&rig);
}

static void test_refresh(void) {
    const rig_shape shape = {64, 48, WIRE_GREY8, 64, 64, 16, 1};
    test(
        "a tile that is stale behind the sender's back is healed by the refresh in as many "
        "frames as there are tiles");
    wire_rig_open(&rig, shape, 4);
    CHECK(up(300), "no session");
    show_and_compare(0, 1000);
    rig.panel[20 * rig.stride + 20] ^= 0x55; /* as an equal hash would leave it */
    for (int i = 0; i < 12; i++) {
        wire_rig_draw(&rig, 3);
        memcpy(rig.rgb, rig.spare, 3 * 64 * 48);
        CHECK(wire_rig_show(&rig) && wire_rig_settle(&rig, 100) >= 0, "not acknowledged");
    }
    CHECK(wire_rig_differences(&rig) == 0, "%u bytes differ", wire_rig_differences(&rig));
    wire_rig_close(&rig);
}

static void test_near(void) {
    const rig_shape shape = {96, 80, WIRE_RGB565, 64, 64, 16, 1};
    test("near tiles go out again exactly when nothing newer is shown, and not before");
    wire_rig_open(&rig, shape, 5);
    rig.cable.paced = 1;
    wire_frames_near(&rig.out, 4);
    CHECK(up(300), "no session");
    uint32_t coarse = 0;
    for (int i = 0; i < 6; i++) {
        wire_rig_draw(&rig, i < 5 ? 0 : 1);
        CHECK(wire_rig_show(&rig), "no session");
        for (int ms = 0; ms < 300 && !wire_frames_out_idle(&rig.out); ms++) {
            fake_cable_step(&rig.cable);
        }
        for (int ms = 0; ms < 80; ms++) {
            fake_cable_step(&rig.cable);
        }
        coarse += wire_rig_differences(&rig) > 0;
    }
    CHECK(wire_rig_settle(&rig, 3000) >= 0, "not refined");
    CHECK(wire_rig_differences(&rig) == 0, "%u bytes differ", wire_rig_differences(&rig));
    CHECK(coarse == 6, "%u of 6 frames were near", coarse);
    wire_rig_close(&rig);
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
    CHECK(wire_rig_settle(&rig, 3000) >= 0, "not refined");
    CHECK(wire_rig_differences(&rig) == 0, "%u bytes differ", wire_rig_differences(&rig));
    show_film(2, 20, 0);
    CHECK(rig.out.near == 0, "format %u: near %u for a few pixels", format, rig.out.near);
    CHECK(wire_rig_settle(&rig, 3000) >= 0 && wire_rig_differences(&rig) == 0, "not exact");
    wire_rig_close(&rig);
}

static void test_rate(void) {
    test(
        "a goal of frames a second is kept by being off, where it must be; at rest the picture "
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
    static wire_end end;
    static wire_frames_out out;
    out = (wire_frames_out){.end = &end, .format = WIRE_GREY8, .tiles = 1};
    wire_frames_rate(&out, goal_fps);
    out.near = (uint8_t)near;
    wire_rate_begin(&out);
    end.now_ms += ms;
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
    test("goals beyond what a clock of milliseconds can tell are 1 ms, not none");
    CHECK(near_after(0, 5000, 2) == 1 && near_after(0, 5000, 1) == 0, "5000 a second");
    CHECK(near_after(0, 0, 100) == 0, "no goal");
}

static void test_silence(void) {
    const rig_shape shape = {64, 48, WIRE_RGB565, 64, 64, 16, 0};
    test("a pulled plug forgets the session at once; the picture is whole 1.5 s after it is back");
    wire_rig_open(&rig, shape, 6);
    CHECK(up(300), "no session");
    show_and_compare(1, 2000);
    fake_cable_unplug(&rig.cable, 500);
    memset(rig.panel, 0, rig.panel_bytes);
    CHECK(!wire_is_up(&rig.host), "still up");
    CHECK(wire_rig_settle(&rig, 2000) >= 0, "not whole");
    CHECK(wire_rig_differences(&rig) == 0, "%u bytes differ", wire_rig_differences(&rig));
    test("a device that was reset unseen is noticed in WIRE_DEAD_MS and gets the picture again");
    wire_rig_start_device(&rig);
    memset(rig.panel, 0, rig.panel_bytes);
    for (int i = 0; i < WIRE_DEAD_MS + 600; i++) {
        fake_cable_step(&rig.cable);
    }
    CHECK(wire_rig_settle(&rig, 1500) >= 0, "not whole");
    CHECK(wire_rig_differences(&rig) == 0, "%u bytes differ", wire_rig_differences(&rig));
    test("while nothing is shown, an idle wire carries a few reports a second");
    const uint32_t before = rig.cable.carried[0] + rig.cable.carried[1];
    for (int i = 0; i < 10000; i++) {
        fake_cable_step(&rig.cable);
    }
    const uint32_t idle = rig.cable.carried[0] + rig.cable.carried[1] - before;
    CHECK(idle > 20 && idle < 200, "%u reports in 10 s", idle);
    CHECK(rig.host.stats.sessions == rig.device.stats.sessions + 2 || rig.host.stats.sessions == 3,
          "%u sessions", rig.host.stats.sessions);
    wire_rig_close(&rig);
}

static void test_talk(void) {
    const rig_shape shape = {64, 48, WIRE_RGB565, 16, 16, 4, 0};
    test(
        "settings arrive over a bad cable, the latest of them; so do errors and statistics over a "
        "good one");
    wire_rig_open(&rig, shape, 7);
    rig.cable.faults.lose = 20000;
    CHECK(up(3000), "no session");
    unsigned value = 0, key = 0, got = 0;
    wire_set(&rig.host, WIRE_SET_BRIGHTNESS, 20);
    wire_set(&rig.host, WIRE_SET_BRIGHTNESS, 80);
    for (int i = 0; i < 5000; i++) {
        fake_cable_step(&rig.cable);
        key = wire_setting_take(&rig.device, &value);
        got = key == WIRE_SET_BRIGHTNESS ? value : got;
    }
    CHECK(got == 80, "brightness %u", got);
    memset(&rig.cable.faults, 0, sizeof rig.cable.faults);
    CHECK(up(3000), "no session");
    wire_stats theirs;
    uint32_t detail;
    wire_tell(&rig.device, WIRE_E_ARENA, 123456);
    wire_stats_ask(&rig.host, &theirs);
    for (int i = 0; i < 100; i++) {
        fake_cable_step(&rig.cable);
    }
    CHECK(wire_told(&rig.host, &detail) == WIRE_E_ARENA && detail == 123456, "detail %u", detail);
    CHECK(wire_told(&rig.host, &detail) == WIRE_FINE, "told twice");
    CHECK(theirs.reports_in > 0 && theirs.sessions > 0, "no statistics");
    wire_rig_close(&rig);
}

static void test_setup(void) {
    test("setups out of range are refused");
    wire_setup s = {.role = WIRE_HOST, .caps = {.in_bytes = 64, .out_bytes = 64, .window = 16}};
    wire_end end;
    CHECK(wire_end_open(&end, &s, 0) == WIRE_OK, "good");
    s.caps.in_bytes = 7;
    CHECK(wire_end_open(&end, &s, 0) == WIRE_ERR_SETUP, "7 bytes");
    s.caps.in_bytes = 1025;
    CHECK(wire_end_open(&end, &s, 0) == WIRE_ERR_SETUP, "1025 bytes");
    s.caps.in_bytes = 64, s.caps.window = 33;
    CHECK(wire_end_open(&end, &s, 0) == WIRE_ERR_SETUP, "window 33");
    s.caps.window = 16, s.role = 2;
    CHECK(wire_end_open(&end, &s, 0) == WIRE_ERR_SETUP, "role 2");
    test("a panel with more tiles than a sender keeps is refused");
    wire_frames_in in;
    const wire_panel none = {0};
    s.role = WIRE_DEVICE, s.caps.features = WIRE_SHOWS, s.caps.width = s.caps.height = 1000;
    CHECK(wire_end_open(&end, &s, 0) == WIRE_OK, "good");
    CHECK(wire_frames_in_open(&in, &end, &none) == WIRE_ERR_SETUP, "a million pixels");
    printf("    bytes on this machine: end %zu, frames in %zu, frames out %zu, tile reader %zu\n",
           sizeof(wire_end), sizeof(wire_frames_in), sizeof(wire_frames_out),
           sizeof(wire_tile_reader));
}

int main(void) {
    test_setup();
    test_all_sizes();
    test_latest_wins();
    test_refresh();
    test_near();
    test_rate();
    test_rate_steps();
    test_silence();
    test_talk();
    return test_done();
}
