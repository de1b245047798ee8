/* test_hid_strangers - devices at the vid:pid of a planelet display that are none we serve
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/base/clock.h"
#include "host_tools/hid/device/session.h"
#include "host_tools/hid/drivers/drivers.h"
#include "platform/wire/wire.h"
#include "tests/reference/fake_hidapi.h"
#include "tests/test.h"

static void swallow(void *context, const uint8_t *report, size_t bytes) {
    (void)context;
    (void)report;
    (void)bytes;
}

static void stranger(void) {
    fail f = {""};
    test("a device that does not answer, at the same vid:pid, is named as such");
    static const fake_device other = {
        .path = "1-1:1.0", .vendor = 0x1209, .product = 0x0001, .output = swallow};
    fake_bus_reset();
    fake_plug(0, &other);
    session s = {.wish.drivers = drivers, .brightness = -1};
    CHECK(session_open(&s, &f) == -1, "opened");
    CHECK(strstr(f.text, "does not answer") && strstr(f.text, "--device"), "%s", f.text);
    session_close(&s);
    CHECK(fake_bus.open == 0, "it stays open");
}

static size_t chatter(void *context, uint8_t *report, size_t room) {
    (void)context;
    memset(report, 0x5A, room < 64 ? room : 64);
    return room < 64 ? room : 64;
}

static void talker(void) {
    fail f = {""};
    test("... and one that never stops to report what no Planelet display says, as soon");
    static const fake_device other = {
        .path = "1-1:1.0", .vendor = 0x1209, .product = 1, .output = swallow, .input = chatter};
    fake_bus_reset();
    fake_plug(0, &other);
    session s = {.wish.drivers = drivers, .brightness = -1};
    const double began = clock_seconds();
    CHECK(session_open(&s, &f) == -1 && strstr(f.text, "does not answer"), "%s", f.text);
    CHECK(clock_seconds() - began < 4.0, "%.1f s", clock_seconds() - began);
    session_close(&s);
    CHECK(fake_bus.open == 0, "it stays open");
}

static void end_output(void *context, const uint8_t *report, size_t bytes) {
    wire_on_report(context, report, bytes, clock_ms());
}

static size_t end_input(void *context, uint8_t *report, size_t room) {
    wire_poll(context, clock_ms());
    return room < 64 ? 0 : wire_next_report(context, report, clock_ms());
}

static void large(void) {
    fail f = {""};
    wire_peer peer;
    const wire_setup setup = {.role = WIRE_DEVICE,
                              .caps = {.session = 1,
                                       .width = 800,
                                       .height = 480,
                                       .formats = 1,
                                       .in_bytes = 64,
                                       .out_bytes = 64,
                                       .features = WIRE_SHOWS,
                                       .credits = 16}};
    const fake_device device = {.path = "1-1:1.0",
                                .vendor = 0x1209,
                                .product = 0x0001,
                                .context = &peer,
                                .output = end_output,
                                .input = end_input};
    test("a panel of more tiles than the sender keeps is refused at once, with its size");
    CHECK(wire_peer_open(&peer, &setup, clock_ms()) == WIRE_OK, "no such end");
    fake_bus_reset();
    fake_plug(0, &device);
    session s = {.wish.drivers = drivers, .brightness = -1};
    CHECK(session_open(&s, &f) == -1, "opened");
    CHECK(strstr(f.text, "800 x 480 pixels are 1500 tiles"), "%s", f.text);
    session_close(&s);
    CHECK(fake_bus.open == 0, "it stays open");
}

int main(void) {
    stranger();
    talker();
    large();
    return test_done();
}
