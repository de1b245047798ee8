/* test_hid_find - which display is meant, among several devices
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/device/find.h"
#include "host_tools/hid/drivers/drivers.h"
#include "tests/reference/fake_hidapi.h"
#include "tests/test.h"

static void swallow(void *context, const uint8_t *report, size_t bytes) {
    (void)context;
    (void)report;
    (void)bytes;
}

static const fake_device one = {.path = "/dev/fake0",
                                .vendor = 0x1209,
                                .product = 0x0001,
                                .serial = L"SN\u00e91",
                                .output = swallow};

static void finding(void) {
    static const struct {
        const char *device, *driver, *found, *said;
    } cases[] = {{NULL, NULL, "planelet", NULL},
                 {"1209:0001", NULL, "planelet", NULL},
                 {"/dev/fake0", NULL, "planelet", NULL},
                 {"SN\xC3\xA9"
                  "1",
                  NULL, "planelet", NULL},
                 {"1209:0001", "nexus", "nexus", NULL},
                 {NULL, "nexus", NULL, "no display among 2"},
                 {"feed:BEEF", NULL, NULL, "no driver is for it"},
                 {"FEED:beef", "apex", "apex", NULL},
                 {"1209:0002", NULL, NULL, "no such device among 2"}};
    fake_device other = one;
    other.path = "/dev/fake1";
    other.vendor = 0xFEED;
    other.product = 0xBEEF;
    other.serial = NULL;
    test("a display is found by vid:pid, path, serial number, driver, or by itself");
    fake_bus_reset();
    fake_plug(0, &other);
    fake_plug(1, &one);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        fail f = {""};
        port_info info;
        const find_wish wish = {drivers, cases[i].device,
                                cases[i].driver == NULL ? NULL : driver_named(cases[i].driver)};
        const driver *by = find_display(&wish, &info, &f);
        const char *name = by == NULL ? NULL : by->name;
        CHECK((name == NULL) == (cases[i].found == NULL), "case %zu: %s", i, f.text);
        CHECK(name == NULL || strcmp(name, cases[i].found) == 0, "case %zu: %s", i, name);
        CHECK(cases[i].said == NULL || strstr(f.text, cases[i].said), "case %zu: %s", i, f.text);
    }
}

static void interfaces(void) {
    port_info info;
    fail f = {""};
    fake_device keyboard = one, panel = one;
    const find_wish wish = {drivers, "1038:1618", NULL};
    test("of a device with several interfaces the driver's own is chosen");
    keyboard.vendor = panel.vendor = 0x1038;
    keyboard.product = panel.product = 0x1618;
    keyboard.path = "/dev/fake0";
    panel.path = "/dev/fake1";
    panel.interface = 1;
    fake_bus_reset();
    fake_plug(0, &keyboard);
    fake_plug(1, &panel);
    const driver *by = find_display(&wish, &info, &f);
    CHECK(by != NULL && info.interface == 1, "%s", f.text);
}

int main(void) {
    finding();
    interfaces();
    return test_done();
}
