/* test_hid_find - which display is meant, among several devices
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

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

static void many(void) {
    static char paths[70][20];
    static fake_device others[70];
    fail f = {""};
    port_info info;
    const find_wish any = {drivers, NULL, NULL}, named = {drivers, "/dev/fake0", NULL};
    test("a display behind 70 other devices is found, by itself and by its path");
    fake_bus_reset();
    for (unsigned i = 0; i < 70; i++) {
        snprintf(paths[i], sizeof paths[i], "/dev/other%u", i);
        others[i] = (fake_device){.path = paths[i], .vendor = 0x046D, .product = 0xC548};
        fake_plug(i, &others[i]);
    }
    fake_plug(70, &one);
    CHECK(find_display(&any, &info, &f) != NULL && strcmp(info.path, one.path) == 0, "%s", f.text);
    CHECK(find_display(&named, &info, &f) != NULL && strcmp(info.path, one.path) == 0, "%s",
          f.text);
    port_info *list;
    const unsigned count = port_list(&list);
    CHECK(count == 71 && list[0].equals == 69 && list[70].equals == 0, "%u devices", count);
    free(list);
}

static void collections(void) {
    port_info *list;
    fake_device several = one;
    test("a device of three collections is listed once, and is not its own neighbour");
    several.collections = 3;
    fake_bus_reset();
    fake_plug(0, &several);
    const unsigned count = port_list(&list);
    CHECK(count == 1 && list[0].equals == 0, "%u devices", count);
    free(list);
}

/* ---- the same one again ----------------------------------------------------------------- */

typedef struct twin {
    const char *path, *place;
    const wchar_t *serial;
    int interface;
} twin;

static void plug(unsigned socket, const twin *t) {
    static fake_device devices[2];
    devices[socket] = one;
    devices[socket].path = t->path;
    devices[socket].place = t->place;
    devices[socket].serial = t->serial;
    devices[socket].interface = t->interface;
    fake_plug(socket, &devices[socket]);
}

/* Whether `now` is the one that was `then`, wished for by `device`; `beside`: another was there,
 * and both went. */
static int is_again(const char *device, const twin *then, const twin *beside, const twin *now) {
    fail f = {""};
    port_info info;
    const find_wish wish = {drivers, device, NULL};
    fake_bus_reset();
    plug(0, then);
    if (beside != NULL) {
        plug(1, beside);
    }
    CHECK(find_display(&wish, &info, &f) != NULL, "%s", f.text);
    CHECK(strcmp(info.path, then->path) == 0, "%s", info.path);
    fake_bus_reset();
    CHECK(!find_again(&wish, &info), "nothing is there");
    plug(0, now);
    const int is_found = find_again(&wish, &info);
    CHECK(!is_found || strcmp(info.path, now->path) == 0, "%s", info.path);
    return is_found;
}

static void again(void) {
    static const twin a = {"/dev/a", "1-2", NULL, 0}, elsewhere = {"/dev/a", "1-3", NULL, 0};
    static const twin renamed = {"/dev/b", "1-2", NULL, 0}, beside = {"/dev/b", "1-3", NULL, 0};
    static const twin other_serial = {"/dev/a", "1-2", L"S", 0};
    static const twin other_interface = {"/dev/a", "1-2", NULL, 1};
    test("a display whose port is known is the one at that port, whatever its path is now");
    CHECK(is_again(NULL, &a, NULL, &a) && is_again(NULL, &a, NULL, &renamed), "refused");
    CHECK(is_again("/dev/a", &a, &beside, &renamed), "refused by path");
    CHECK(!is_again(NULL, &a, NULL, &elsewhere), "another port");
    CHECK(!is_again("/dev/a", &a, NULL, &elsewhere), "another port, by path");
    CHECK(!is_again(NULL, &a, NULL, &other_serial), "another serial number");
    CHECK(!is_again(NULL, &a, NULL, &other_interface), "another interface");

    static const twin u = {"/dev/a", NULL, L"S", 0}, moved = {"/dev/b", NULL, L"S", 0};
    test("where ports are not known: at its path, or elsewhere if it was alone and not named so");
    CHECK(is_again(NULL, &u, NULL, &u) && is_again(NULL, &u, NULL, &moved), "refused");
    CHECK(is_again("/dev/a", &u, NULL, &u) && !is_again("/dev/a", &u, NULL, &moved), "by path");
    CHECK(is_again(NULL, &u, &moved, &u) && !is_again(NULL, &u, &moved, &moved), "beside another");
}

/* ---- ports -------------------------------------------------------------------------------- */

static void is_placed(const char *path, const char *expected) {
    char place[PLACE_BYTES];
    place_in(TEST_FOLDER "sys", path, place);
    CHECK(strcmp(place, expected) == 0, "%s: '%s'", path, place);
}

static void link_hidraw(const char *name, const char *target) {
    char path[300];
    snprintf(path, sizeof path, TEST_FOLDER "sys/class/hidraw/%s", name);
    remove(path);
    CHECK(symlink(target, path) == 0, "%s", path);
}

static void places(void) {
    test("the port is that of the last interface in /sys, or of a path of libusb");
    mkdir(TEST_FOLDER, 0777);
    mkdir(TEST_FOLDER "sys", 0777);
    mkdir(TEST_FOLDER "sys/class", 0777);
    mkdir(TEST_FOLDER "sys/class/hidraw", 0777);
    link_hidraw("hidraw3",
                "../../devices/pci0000:00/0000:00:14.0/usb1/1-2/1-2.4/1-2.4:1.1/"
                "0003:1038:1618.0007/hidraw/hidraw3");
    link_hidraw("hidraw4", "../../devices/virtual/misc/uhid/0003:1209:0001.0001/hidraw/hidraw4");
    link_hidraw("hidraw5",
                "../../devices/platform/vhci_hcd.0/usb3/3-1/3-1:1.0/0003/hidraw/hidraw5");
    is_placed("/dev/hidraw3", "1-2.4");
    is_placed("/dev/hidraw4", "");
    is_placed("/dev/hidraw5", "3-1");
    is_placed("/dev/hidraw6", "");
    is_placed("1-2.4.1:1.0", "1-2.4.1");
    is_placed("10-12:1.10", "10-12");
    static const char *const others[] = {
        "0001:0004:00", "1-2.:1.0", "1-:1.0",    "-2:1.0", "1-2:1",
        "1-2:1.0x",     "1-2",      "DevSrvsID", "",       "1-2.4"};
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) {
        is_placed(others[i], "");
    }
    is_placed("1-2.3333333333333333333333333333333333333333333333333333333333333333:1.0", "");
}

/* ---- which devices ----------------------------------------------------------------------- */

typedef struct owned {
    uint16_t vendor, id;
    int interface;
    const char *driver; /* NULL: none is for it */
} owned;

static const owned devices[] = {{0x1038, 0x12CB, 4, "nova"},
                                {0x1038, 0x12CD, 4, "nova"},
                                {0x1038, 0x12E0, 4, "nova"},
                                {0x1038, 0x12E5, 4, "nova"},
                                {0x1038, 0x12FA, 4, "nova"},
                                {0x1038, 0x225D, 4, "nova"},
                                {0x1038, 0x2244, 3, "nova-elite"},
                                {0x1038, 0x2290, 3, "nova-elite"},
                                {0x1038, 0x1610, 1, "apex"},
                                {0x1038, 0x1612, 1, "apex"},
                                {0x1038, 0x1614, 1, "apex"},
                                {0x1038, 0x1618, 1, "apex"},
                                {0x1038, 0x161C, 1, "apex"},
                                {0x1038, 0x1628, 1, "apex-2023"},
                                {0x1038, 0x1642, 1, NULL},
                                {0x1038, 0x1644, 1, NULL},
                                {0x1038, 0x1646, 1, NULL},
                                {0x046D, 0xC21C, 0, "logitech"},
                                {0x046D, 0xC22D, 1, "logitech"},
                                {0x046D, 0xC22E, 1, "logitech"},
                                {0x04D8, 0xC002, 0, "picolcd"},
                                {0x1B1C, 0x1B8E, 0, "nexus"},
                                {0x0FD9, 0x0060, 0, "streamdeck-original"},
                                {0x0FD9, 0x0063, 0, "streamdeck-mini"},
                                {0x0FD9, 0x0090, 0, "streamdeck-mini"},
                                {0x0FD9, 0x00B3, 0, "streamdeck-mini"},
                                {0x0FD9, 0x00B8, 0, "streamdeck-mini"},
                                {0x0FD9, 0x006D, 0, "streamdeck"},
                                {0x0FD9, 0x0080, 0, "streamdeck"},
                                {0x0FD9, 0x00A5, 0, "streamdeck"},
                                {0x0FD9, 0x00B9, 0, "streamdeck"},
                                {0x0FD9, 0x006C, 0, "streamdeck-xl"},
                                {0x0FD9, 0x008F, 0, "streamdeck-xl"},
                                {0x0FD9, 0x00BA, 0, "streamdeck-xl"},
                                {0x0FD9, 0x009A, 0, "streamdeck-neo"},
                                {0x0FD9, 0x0084, 0, "streamdeck-plus"},
                                {0x1B1C, 0x0C33, 0, "corsair-lcd"},
                                {0x1B1C, 0x0C39, 0, "corsair-lcd"},
                                {0x1B1C, 0x0C42, 0, "corsair-lcd"},
                                {0x1B1C, 0x0C43, 0, "corsair-lcd"},
                                {0x1B1C, 0x0C4E, 0, "corsair-lcd"},
                                {0x1B1C, 0x0C55, 0, "corsair-lcd"},
                                {0x1B1C, 0x0C57, 0, "corsair-lcd"}};

/* Of these the interface with the panel is not known. */
static const owned any_interface[] = {{0x046D, 0xC222, 0, "logitech"},
                                      {0x046D, 0xC227, 0, "logitech"},
                                      {0x046D, 0x0A07, 0, "logitech"},
                                      {0x046D, 0xC251, 0, "logitech"}};

static const char *name_for(const owned *o, int interface) {
    const port_info info = {.vendor = o->vendor, .id = o->id, .interface = interface};
    const driver *by = driver_for(drivers, &info);
    return by == NULL ? "none" : by->name;
}

static void owned_displays(void) {
    test("displays that people own, by ids and interface, have their drivers, and no others");
    for (unsigned i = 0; i < sizeof devices / sizeof devices[0]; i++) {
        const owned *o = &devices[i];
        for (int interface = -1; interface < 6; interface++) {
            const int is_it = o->driver != NULL && (interface < 0 || interface == o->interface);
            CHECK(strcmp(name_for(o, interface), is_it ? o->driver : "none") == 0,
                  "%04x:%04x, interface %d: %s", o->vendor, o->id, interface,
                  name_for(o, interface));
        }
    }
    for (unsigned i = 0; i < sizeof any_interface / sizeof any_interface[0]; i++) {
        for (int interface = -1; interface < 6; interface++) {
            CHECK(strcmp(name_for(&any_interface[i], interface), "logitech") == 0, "%04x",
                  any_interface[i].id);
        }
    }
    unsigned ids = 0;
    for (unsigned i = 1; drivers[i] != NULL; i++) { /* but Planelet's own */
        for (const driver_id *id = drivers[i]->ids; id->vendor != 0; id++) {
            ids++;
        }
    }
    CHECK(ids == sizeof devices / sizeof devices[0] - 3 + 4, "%u ids", ids);
}

int main(void) {
    finding();
    interfaces();
    many();
    collections();
    again();
    places();
    owned_displays();
    return test_done();
}
