/* test_hid_port - what hidapi does beyond its manual, met by port.c
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "host_tools/base/clock.h"
#include "host_tools/hid/device/port.h"
#include "host_tools/hid/device/report_size.h"
#include "tests/reference/fake_hidapi.h"
#include "tests/test.h"

/* A device that keeps the last report and gives `ready` input reports. */
static struct {
    uint8_t last[64];
    size_t bytes, in_bytes;
    unsigned ready;
} echo;

static void echo_output(void *context, const uint8_t *report, size_t bytes) {
    (void)context;
    memcpy(echo.last, report, bytes);
    echo.bytes = bytes;
}

static size_t echo_input(void *context, uint8_t *report, size_t room) {
    (void)context;
    (void)room;
    if (echo.ready == 0) {
        return 0;
    }
    echo.ready--;
    memset(report, 0xA5, echo.in_bytes);
    return echo.in_bytes;
}

static const fake_device one = {.path = "/dev/fake0",
                                .vendor = 0x1209,
                                .product = 0x0001,
                                .usage_page = 0xFF00,
                                .serial = L"SN\u00e91",
                                .maker = L"A \U0001F600 b\n",
                                .name = L"display",
                                .output = echo_output,
                                .feature = echo_output,
                                .input = echo_input};

/* How many devices are on the bus; the first of them is in `info`. */
static unsigned listed(port_info *info) {
    port_info *list;
    const unsigned count = port_list(&list);
    *info = count > 0 ? list[0] : *info;
    free(list);
    return count;
}

static port *open_one(port_info *info) {
    fail f = {""};
    fake_bus_reset();
    memset(&echo, 0, sizeof echo);
    echo.in_bytes = 64;
    fake_plug(0, &one);
    CHECK(listed(info) == 1, "it is on the bus");
    port *p = port_open(info, &f);
    CHECK(p != NULL, "%s", f.text);
    return p;
}

static void close_one(port *p) {
    port_close(p);
    CHECK(fake_bus.open == 0 && !fake_bus.alive, "hidapi is shut down");
    CHECK(fake_bus.wrong == 0, "hidapi was used against its rules");
}

static void names(void) {
    port_info info;
    test("names come as UTF-8, control characters as ?");
    port *p = open_one(&info);
    CHECK(strcmp(info.serial,
                 "SN\xC3\xA9"
                 "1") == 0,
          "%s", info.serial);
    CHECK(strcmp(info.maker, "A \xF0\x9F\x98\x80 b?") == 0, "%s", info.maker);
    CHECK(info.usage_page == 0xFF00 && info.vendor == 0x1209, "%x", info.usage_page);
    close_one(p);
}

static void outputs(void) {
    port_info info;
    port_statistics statistics;
    const uint8_t report[65] = {0, 7, 8, 9};
    test("a report of 64 bytes without number goes as 65 and arrives as 64");
    port *p = open_one(&info);
    CHECK(port_output(p, report, 65) == PORT_OK, "written");
    CHECK(echo.bytes == 64 && echo.last[0] == 7, "%zu bytes came", echo.bytes);
    port_statistics_get(p, &statistics);
    CHECK(statistics.reports == 1 && statistics.bytes == 64, "%u bytes",
          (unsigned)statistics.bytes);
    test("a write of less than the report says so, and the next goes");
    fake_bus.short_writes = 1;
    CHECK(port_output(p, report, 65) == PORT_CUT, "half of it was accepted");
    fake_bus.short_writes = 0;
    CHECK(port_output(p, report, 65) == PORT_OK, "the next");
    test("a report that the system drops looks like one that arrived");
    fake_bus.drop_outputs = 1;
    echo.bytes = 0;
    CHECK(port_output(p, report, 65) == PORT_OK && echo.bytes == 0, "nobody knows");
    close_one(p);
}

static void inputs(void) {
    port_info info;
    uint8_t report[64];
    test("reads that come back empty at once do not end the wait");
    port *p = open_one(&info);
    fake_bus.empty_reads = 2;
    for (unsigned i = 0; i < 20; i++) {
        echo.ready = 1;
        CHECK(port_input(p, report, sizeof report, 500) == 64, "read %u", i);
    }
    fake_bus.empty_reads = 1;
    const double began = clock_seconds();
    CHECK(port_input(p, report, sizeof report, 30) == 0, "none came");
    CHECK(clock_seconds() - began > 0.029, "it waited %.3f s", clock_seconds() - began);
    test("input in pieces of a packet is handed on in pieces");
    fake_bus.empty_reads = 0;
    fake_bus.piece_bytes = 24;
    echo.ready = 1;
    CHECK(port_input(p, report, sizeof report, 10) == 24, "first");
    CHECK(port_input(p, report, sizeof report, 10) == 24, "second");
    CHECK(port_input(p, report, sizeof report, 10) == 16, "rest");
    close_one(p);
}

static void unplugging(int libusb) {
    port_info info;
    uint8_t report[65] = {0};
    fail f = {""};
    test(libusb ? "libusb: a device that comes back is found and opens again"
                : "hidraw: a device that comes back is found and opens again");
    port *p = open_one(&info);
    fake_bus.libusb = libusb;
    fake_unplug(0);
    CHECK(port_input(p, report, 64, 1000) == PORT_GONE, "read");
    CHECK(port_output(p, report, 65) == PORT_GONE, "write");
    CHECK(port_feature(p, report, 65) == PORT_GONE, "feature");
    port_close(p);
    CHECK(listed(&info) == 0, "it is not there");
    fake_plug(0, &one);
    CHECK(listed(&info) == 1, "it is there again");
    p = port_open(&info, &f);
    CHECK(p != NULL && port_output(p, report, 65) == PORT_OK, "%s", f.text);
    close_one(p);
}

static void denied(void) {
    port_info info;
    fail f = {""};
    test("a refused open names path and device and says what to do");
    close_one(open_one(&info));
    fake_bus.denied = 1;
    snprintf(info.path, sizeof info.path, "1-1:1.0");
    CHECK(port_open(&info, &f) == NULL, "opened");
    CHECK(strstr(f.text, "1-1:1.0") && strstr(f.text, "1209:0001"), "%s", f.text);
    CHECK(strstr(f.text, "install the udev rule") || strstr(f.text, "close other programs"), "%s",
          f.text);
    CHECK(strstr(f.text, "Success") == NULL, "%s", f.text);
}

static void sizes(void) {
    static const uint8_t vendor[] = {0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01, 0x75, 0x08, 0x96,
                                     0x40, 0x00, 0x81, 0x02, 0x96, 0x00, 0x04, 0x91, 0x02, 0xC0};
    static const uint8_t two[] = {0x75, 0x01, 0x95, 0x0C, 0x85, 0x01, 0x91,
                                  0x02, 0x85, 0x02, 0x91, 0x02, 0x91, 0x02};
    test("sizes of reports are read from the report descriptor");
    report_sizes s = report_sizes_of(vendor, sizeof vendor);
    CHECK(s.out == 1024 && s.in == 64, "%u out, %u in", s.out, s.in);
    s = report_sizes_of(two, sizeof two);
    CHECK(s.out == 3 && s.in == 0, "%u out, %u in", s.out, s.in);
    for (size_t bytes = 0; bytes < sizeof vendor; bytes++) {
        s = report_sizes_of(vendor, bytes);
        CHECK(s.out == (bytes < 19 ? 0 : 1024), "%u of %zu bytes", s.out, bytes);
        CHECK(s.in == (bytes < 14 ? 0 : 64), "%u of %zu bytes", s.in, bytes);
    }
    const uint8_t huge[] = {0x77, 0xFF, 0xFF, 0xFF, 0xFF, 0x97, 0xFF, 0xFF, 0xFF, 0xFF, 0x91, 0x02};
    CHECK(report_sizes_of(huge, sizeof huge).out == 65536, "held at the most");
    CHECK(report_sizes_at("/dev/hidraw*").out == 0 && report_sizes_at("9-9:1.0").out == 0,
          "no such paths");
}

int main(void) {
    names();
    outputs();
    inputs();
    unplugging(0);
    unplugging(1);
    denied();
    sizes();
    return test_done();
}
