/* test_wire_frames - frames over a good and a bad cable, pixel by pixel
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/report.h"
#include "platform/wire/services.h"
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
    const int ms = wire_rig_wait(&rig, most);
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
    test(
        "a frame shown while another is on its way wins: nothing waits for the end of the old one");
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
    const int ms = wire_rig_wait(&rig, 2000);
    CHECK(ms > 0 && ms < 1000, "%d ms for the last of 20", ms);
    CHECK(wire_rig_differences(&rig) == 0, "%u bytes differ", wire_rig_differences(&rig));
    test("an unchanged frame costs its end and the tile that is refreshed");
    const uint32_t tiles = rig.host.stats.tiles_out;
    wire_rig_draw(&rig, 3);
    memcpy(rig.rgb, rig.spare, 3 * 160 * 128);
    CHECK(wire_rig_show(&rig) && wire_rig_wait(&rig, 100) >= 0, "not acknowledged");
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
        CHECK(wire_rig_show(&rig) && wire_rig_wait(&rig, 100) >= 0, "not acknowledged");
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
    CHECK(wire_rig_wait(&rig, 3000) >= 0, "not refined");
    CHECK(wire_rig_differences(&rig) == 0, "%u bytes differ", wire_rig_differences(&rig));
    CHECK(coarse == 6, "%u of 6 frames were near", coarse);
    wire_rig_close(&rig);
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
    CHECK(wire_rig_wait(&rig, 2000) >= 0, "not whole");
    CHECK(wire_rig_differences(&rig) == 0, "%u bytes differ", wire_rig_differences(&rig));
    test("a device that was reset unseen is noticed in WIRE_DEAD_MS and gets the picture again");
    wire_rig_start_device(&rig);
    memset(rig.panel, 0, rig.panel_bytes);
    for (int i = 0; i < WIRE_DEAD_MS + 600; i++) {
        fake_cable_step(&rig.cable);
    }
    CHECK(wire_rig_wait(&rig, 1500) >= 0, "not whole");
    CHECK(wire_rig_differences(&rig) == 0, "%u bytes differ", wire_rig_differences(&rig));
    test("while nothing is shown, an idle wire carries a few reports per second");
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

static void test_numbers(void) {
    const rig_shape shape = {64, 48, WIRE_RGB565, 64, 64, 16, 0};
    test("tiles and ends of frames 6 and up, which no sender has, are skipped");
    wire_rig_open(&rig, shape, 9);
    CHECK(up(300), "no session");
    show_and_compare(0, 1000);
    const wire_frames_in before = rig.in;
    const uint8_t black[2] = {0, 0};
    uint8_t end[WIRE_FRAME_END_BODY] = {0};
    for (unsigned number = 6; number < 8; number++) {
        wire_frames_in_tile(&rig.in, 0x80 | WIRE_SOLID << 5 | number << 2, 0, sizeof black);
        wire_frames_in_bytes(&rig.in, black, sizeof black);
    }
    for (unsigned number = 6; number < 256; number++) {
        end[0] = (uint8_t)number;
        wire_frames_in_end(&rig.in, end);
    }
    CHECK(memcmp(&before, &rig.in, sizeof before) == 0, "something was kept");
    CHECK(rig.device.stats.frames_bad == 0 && rig.wrong_rows == 0, "something was shown");
    show_and_compare(1, 2000);
    wire_rig_close(&rig);
}

static void test_talk(void) {
    const rig_shape shape = {64, 48, WIRE_RGB565, 16, 16, 4, 0};
    test("settings arrive over a bad cable, the latest of them; so do errors over a good one");
    wire_rig_open(&rig, shape, 7);
    rig.cable.faults.lose = 20000;
    CHECK(up(3000), "no session");
    unsigned value = 0, key = 0, got = 0;
    wire_setting_send(&rig.host, WIRE_SET_BRIGHTNESS, 20);
    wire_setting_send(&rig.host, WIRE_SET_BRIGHTNESS, 80);
    for (int i = 0; i < 5000; i++) {
        fake_cable_step(&rig.cable);
        key = wire_setting_read(&rig.device, &value);
        got = key == WIRE_SET_BRIGHTNESS ? value : got;
    }
    CHECK(got == 80, "brightness %u", got);
    memset(&rig.cable.faults, 0, sizeof rig.cable.faults);
    CHECK(up(3000), "no session");
    uint32_t detail;
    wire_error_send(&rig.device, WIRE_E_ARENA, 123456);
    for (int i = 0; i < 100; i++) {
        fake_cable_step(&rig.cable);
    }
    CHECK(wire_error_read(&rig.host, &detail) == WIRE_E_ARENA && detail == 123456, "detail %u",
          detail);
    CHECK(wire_error_read(&rig.host, &detail) == WIRE_FINE, "read twice");
    wire_rig_close(&rig);
}

/* The host's next report, sealed by hand: what is asked for is not asked by this code. */
static void ask_for_statistics(uint8_t report[64]) {
    memset(report, 0, 64);
    report[6] = WIRE_STATS_ASK;
    report[7] = 1;
    wire_report_seal(report, 64, WIRE_HOST, rig.host.key, rig.device.in_number, 0, 1);
}

static void test_statistics(void) {
    const rig_shape shape = {64, 48, WIRE_RGB565, 64, 64, 4, 0};
    test("a peer that is asked for its statistics answers with ten counters");
    wire_rig_open(&rig, shape, 8);
    CHECK(up(300), "no session");
    show_and_compare(0, 1000);
    uint8_t report[64];
    const uint32_t now = rig.cable.now_ms;
    while (wire_next_report(&rig.device, report, now) > 0) {
    }
    const wire_stats s = rig.device.stats;
    ask_for_statistics(report);
    CHECK(wire_on_report(&rig.device, report, 64, now) == 1, "the question is not valid");
    CHECK(wire_next_report(&rig.device, report, now) == 64, "no answer");
    CHECK(report[5] == 128 && report[6] == WIRE_STATS && report[7] == 40, "another answer");
    const uint32_t expected[10] = {s.reports_out, s.reports_in + 1, s.reports_lost, s.reports_late,
                                   s.reports_bad, s.sessions,       s.frames_out,   s.frames_in,
                                   s.tiles_out,   s.tiles_in};
    for (unsigned i = 0; i < 10; i++) {
        CHECK(wire_get32(report + 8 + 4 * i) == expected[i], "counter %u", i);
    }
    CHECK(s.sessions == 1 && s.frames_in == 1 && s.tiles_in == 12, "nothing was counted");
    wire_rig_close(&rig);
}

static void test_setup(void) {
    test("setups out of range are refused");
    wire_setup s = {.role = WIRE_HOST, .caps = {.in_bytes = 64, .out_bytes = 64, .credits = 16}};
    wire_peer peer;
    CHECK(wire_peer_open(&peer, &s, 0) == WIRE_OK, "good");
    s.caps.in_bytes = 7;
    CHECK(wire_peer_open(&peer, &s, 0) == WIRE_ERR_SETUP, "7 bytes");
    s.caps.in_bytes = 1025;
    CHECK(wire_peer_open(&peer, &s, 0) == WIRE_ERR_SETUP, "1025 bytes");
    s.caps.in_bytes = 64, s.caps.credits = 33;
    CHECK(wire_peer_open(&peer, &s, 0) == WIRE_ERR_SETUP, "33 credits");
    s.caps.credits = 16, s.role = 2;
    CHECK(wire_peer_open(&peer, &s, 0) == WIRE_ERR_SETUP, "role 2");
    test("a panel with more tiles than a sender keeps is refused");
    wire_frames_in in;
    const wire_panel none = {0};
    s.role = WIRE_DEVICE, s.caps.features = WIRE_SHOWS, s.caps.width = s.caps.height = 1000;
    CHECK(wire_peer_open(&peer, &s, 0) == WIRE_OK, "good");
    CHECK(wire_frames_in_open(&in, &peer, &none) == WIRE_ERR_SETUP, "a million pixels");
    printf("    bytes on this machine: peer %zu, frames in %zu, frames out %zu, tile reader %zu\n",
           sizeof(wire_peer), sizeof(wire_frames_in), sizeof(wire_frames_out),
           sizeof(wire_tile_reader));
}

int main(void) {
    test_setup();
    test_all_sizes();
    test_latest_wins();
    test_refresh();
    test_near();
    test_silence();
    test_numbers();
    test_talk();
    test_statistics();
    return test_done();
}
