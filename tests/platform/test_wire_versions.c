/* test_wire_versions - peers that are older, and devices that leave something out
 *
 * An older peer is one whose messages are written here byte by byte, as it would send them.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

enum { WIDTH = 48, HEIGHT = 32, MEMORY = 1 << 18 };

#include "platform/wire/base.h"
#include "platform/wire/report.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/reference/wire_device_rig.h"

static const wire_view plain = {
    .eye = {3, 2, 4}, .up = {0, 1, 0}, .tan_half_fov = 0.35f, .shader = PLT_SHADE_EYELIGHT};

static void step(int count) {
    for (int i = 0; i < count; i++) {
        fake_cable_step(&e.cable);
        wire_device_run(&e.device, 2000);
    }
}

/* One control message, as the next report to `to`. */
static void deliver(wire_peer *to, unsigned type, const uint8_t *body, uint8_t bytes) {
    uint8_t report[64] = {0};
    report[6] = (uint8_t)type;
    report[7] = bytes;
    memcpy(report + 8, body, bytes);
    wire_report_seal(report, 64, to->role == WIRE_HOST ? WIRE_DEVICE : WIRE_HOST, to->key,
                     to->in_number, 0, 1);
    CHECK(wire_on_report(to, report, 64, e.cable.now_ms) == 1, "the report is not taken");
}

/* ---- views ---------------------------------------------------------------------------- */

static int is_rendered(uint8_t *rgb) {
    for (int i = 0; i < 20000; i++) {
        step(1);
        if (e.device.frames > 0 && wire_frames_out_done(&e.device.out) && e.view.have &&
            !e.device.view.fresh && !e.device.is_viewed) {
            memcpy(rgb, e.panel, sizeof e.panel);
            return 1;
        }
    }
    return 0;
}

static void with_more(const packed *image) {
    static uint8_t without[WIDTH * HEIGHT * 3], with[WIDTH * HEIGHT * 3];
    wire_view v = plain;
    test(
        "a view's background and samples reach the engine, and the next view without them has "
        "none");
    open_rig(image->bytes, (uint32_t)image->size, 4, 1);
    wire_view_send(&e.view, &v);
    CHECK(is_rendered(without) && wire_view_left_out(&e.view) == 0, "no frame");
    v.has_background = 1;
    v.background[0] = 255;
    v.background[1] = 128;
    v.samples = WIRE_SAMPLES_FOUR;
    wire_view_send(&e.view, &v);
    CHECK(is_rendered(with), "no frame");
    CHECK(with[0] == 255 && with[1] == 128 && with[2] == 0, "%u %u %u", with[0], with[1], with[2]);
    CHECK(wire_view_left_out(&e.view) == 0, "left out: %u", wire_view_left_out(&e.view));
    wire_view_send(&e.view, &plain);
    CHECK(is_rendered(with) && memcmp(with, without, sizeof with) == 0, "another frame");

    test("samples that the engine does not know are an error of their own");
    uint32_t detail;
    v.samples = 9;
    wire_view_send(&e.view, &v);
    step(400);
    CHECK(wire_error_read(&e.host, &detail) == WIRE_E_SAMPLES, "another error");
    v.samples = WIRE_SAMPLES_ADAPTIVE;
    v.tan_half_fov = 0.0f;
    wire_view_send(&e.view, &v);
    step(400);
    CHECK(wire_error_read(&e.host, &detail) == WIRE_E_VIEW, "the camera is what is wrong");
}

static void older_host(const packed *image) {
    uint8_t body[46] = {7};
    wire_view v = plain;
    test("an older host's view of 42 bytes has one sample, and the sky");
    open_rig(image->bytes, (uint32_t)image->size, 4, 1);
    v.has_background = 1;
    v.samples = WIRE_SAMPLES_FOUR;
    wire_view_send(&e.view, &v);
    step(400);
    CHECK(e.device.view.view.has_background && e.device.view.view.samples == WIRE_SAMPLES_FOUR,
          "a newer one's");
    memset(body + 42, 0xFF, 4);
    deliver(&e.device.peer, WIRE_VIEW, body, 42);
    CHECK(e.device.view.view.number == 7, "it is not taken");
    CHECK(!e.device.view.view.has_background && e.device.view.view.samples == 0,
          "something is left");
    deliver(&e.device.peer, WIRE_VIEW, body, 45);
    CHECK(!e.device.view.view.has_background, "half of it is taken for it");
    deliver(&e.device.peer, WIRE_VIEW, body, 46);
    CHECK(e.device.view.view.has_background && e.device.view.view.background[2] == 0xFF,
          "not read");
}

static void older_device(const packed *image) {
    uint8_t body[2] = {0, 0xFF};
    wire_view v = plain;
    test("an older device's answer of one byte says that it leaves out what is new");
    open_rig(image->bytes, (uint32_t)image->size, 4, 1);
    step(400);
    wire_view_send(&e.view, &v);
    body[0] = e.view.view.number;
    deliver(&e.host, WIRE_VIEW_HAVE, body, 1);
    CHECK(e.view.have && wire_view_left_out(&e.view) == 0, "nothing new was asked for");
    v.has_background = 1;
    wire_view_send(&e.view, &v);
    CHECK(wire_view_left_out(&e.view) == 0, "it has not answered");
    body[0] = (uint8_t)(e.view.view.number + 9);
    deliver(&e.host, WIRE_VIEW_HAVE, body,
            2); /* whose second byte must not be taken for this one's */
    body[0] = e.view.view.number;
    deliver(&e.host, WIRE_VIEW_HAVE, body, 1);
    CHECK(wire_view_left_out(&e.view) == WIRE_VIEW_BACKGROUND, "%u", wire_view_left_out(&e.view));
    v.samples = WIRE_SAMPLES_FOUR;
    wire_view_send(&e.view, &v);
    body[0] = (uint8_t)(e.view.view.number - 1);
    deliver(&e.host, WIRE_VIEW_HAVE, body, 1);
    CHECK(!e.view.have, "the answer to another view");
    body[0] = e.view.view.number;
    deliver(&e.host, WIRE_VIEW_HAVE, body, 1);
    CHECK(wire_view_left_out(&e.view) == (WIRE_VIEW_BACKGROUND | WIRE_VIEW_SAMPLES), "%u",
          wire_view_left_out(&e.view));
    test("... and a newer one, whose engine is built without, says what");
    open_rig(image->bytes, (uint32_t)image->size, 4, 1);
    e.device.view.obeys = WIRE_VIEW_SAMPLES;
    wire_view_send(&e.view, &v);
    step(400);
    CHECK(wire_view_left_out(&e.view) == WIRE_VIEW_BACKGROUND, "%u", wire_view_left_out(&e.view));
}

/* ---- keys ----------------------------------------------------------------------------- */

static struct {
    wire_peer host, device;
    wire_keys_out out;
    wire_keys_in in;
    fake_cable cable;
} k;

static void open_keys(uint64_t seed, int host_wants) {
    memset(&k, 0, sizeof k);
    fake_cable_open(&k.cable, &k.host, &k.device, seed);
    wire_peer_open(&k.host, &host_setup, k.cable.now_ms);
    wire_peer_open(&k.device, &device_setup, k.cable.now_ms);
    wire_keys_out_open(&k.out, &k.device);
    if (host_wants) {
        wire_keys_in_open(&k.in, &k.host);
    }
}

static void step_keys(int count) {
    for (int i = 0; i < count; i++) {
        fake_cable_step(&k.cable);
    }
}

static void presses_arrive(void) {
    test("every press arrives, once, however many reports are lost, repeated and late");
    for (uint64_t seed = 0; seed < 40; seed++) {
        unsigned pressed[WIRE_KEYS_MOST] = {0};
        random_state r = {seed};
        open_keys(seed, 1);
        step_keys(300);
        CHECK(wire_is_up(&k.host) && wire_is_up(&k.device), "no session");
        k.cable.faults = (fake_faults){8000, 8000, 8000, 3000, 6000, (unsigned)seed % 4, 0};
        for (int i = 0; i < 60; i++) {
            const unsigned key = random_below(&r, WIRE_KEYS_MOST);
            wire_key_set(&k.out, key, 1);
            wire_key_set(&k.out, key, 1);
            step_keys((int)random_below(&r, 30));
            wire_key_set(&k.out, key, 0);
            pressed[key]++;
            step_keys((int)random_below(&r, 30));
        }
        wire_key_set(&k.out, 3, 1);
        wire_key_set(&k.out, WIRE_KEYS_MOST, 1);
        step_keys(3);
        k.cable.faults = (fake_faults){0};
        step_keys(500);
        for (unsigned key = 0; key < WIRE_KEYS_MOST; key++) {
            CHECK(k.in.changes[key] == (uint8_t)(2 * pressed[key] + (key == 3)),
                  "cable %u, key %u: %u changes, %u presses", (unsigned)seed, key,
                  k.in.changes[key], pressed[key]);
        }
        CHECK(k.out.have, "it is still repeated");
    }
}

static void another_session(void) {
    test("in another session only what is down counts, and is heard at once");
    open_keys(5, 1);
    step_keys(300);
    wire_key_set(&k.out, 1, 1);
    wire_key_set(&k.out, 1, 0);
    wire_key_set(&k.out, 2, 1);
    step_keys(100);
    CHECK(k.in.changes[1] == 2 && k.in.changes[2] == 1, "not heard");
    fake_cable_unplug(&k.cable, 300);
    step_keys(10);
    wire_key_set(&k.out, 5, 1);
    wire_key_set(&k.out, 5, 0);
    step_keys(1500);
    CHECK(wire_is_up(&k.host) && k.host.stats.sessions == 2, "%u sessions", k.host.stats.sessions);
    CHECK(k.in.changes[1] == 0 && k.in.changes[2] == 1 && k.in.changes[5] == 0, "%u %u %u",
          k.in.changes[1], k.in.changes[2], k.in.changes[5]);
}

static void strangers_to_keys(void) {
    uint8_t body[40] = {9, 2, 1};
    test("a host that knows no keys is told of none");
    open_keys(1, 0);
    step_keys(300);
    wire_key_set(&k.out, 0, 1);
    step_keys(300);
    CHECK(k.out.have && k.device.pending == 0, "it is repeated for nobody");
    test("a device with fewer keys, or more, is understood as far as there are some");
    open_keys(1, 1);
    step_keys(300);
    deliver(&k.host, 0x20, body, 3);
    CHECK(k.in.changes[0] == 2 && k.in.changes[1] == 1 && k.in.changes[2] == 0, "not read");
    body[16] = 5;
    body[17] = 77;
    deliver(&k.host, 0x20, body, 40);
    CHECK(k.in.changes[15] == 5 && k.in.number == 9, "not read, or too much of it");
    deliver(&k.host, 0x20, body, 1);
    CHECK(k.in.changes[15] == 5, "a message without keys is none");
}

int main(void) {
    mesh m = {0};
    rig direct;
    const rig_config config =
        rig_config_of(2, rig_is_tiny() ? 1 : 16, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    shape_icosphere(&m, rig_is_tiny() ? 1 : 3);
    if (rig_open(&direct, &m, &config) != PLT_OK) {
        return 1;
    }
    if (PLT_TILE_SIDE == WIRE_TILE_SIDE) {
        with_more(&direct.image);
        older_host(&direct.image);
        older_device(&direct.image);
    }
    presses_arrive();
    another_session();
    strangers_to_keys();
    rig_close(&direct);
    mesh_free(&m);
    return test_done();
}
