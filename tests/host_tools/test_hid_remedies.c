/* test_hid_remedies - what messages about displays advise, done to a fake bus, helps
 *
 * A message is given as it stands in the source, conversions and all:
 * tests/check/check_remedies.sh looks for it here. Each property provokes one message, does
 * what it says and opens, or shows on, the display again.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <sys/stat.h>

#include "host_tools/base/clock.h"
#include "host_tools/hid/device/lock.h"
#include "host_tools/hid/device/session.h"
#include "host_tools/hid/drivers/drivers.h"
#include "platform/wire/wire.h"
#include "tests/hid/model.h"
#include "tests/hid/pattern.h"
#include "tests/reference/fake_hidapi.h"
#include "tests/test.h"

/* ---- messages --------------------------------------------------------------------- */

/* The end of the conversion that begins at `at`, which is a '%'. */
static const char *after_conversion(const char *at) {
    at += strspn(at + 1, "-+ 0123456789.*lzh") + 1;
    return at + 1;
}

/* Each piece of `message` between conversions is in `text`, one after the other. */
static int is_message(const char *text, const char *message) {
    while (*message != '\0') {
        char piece[400];
        const size_t length = strcspn(message, "%");
        memcpy(piece, message, length);
        piece[length] = '\0';
        text = strstr(text, piece);
        if (text == NULL) {
            return 0;
        }
        text += length;
        message += length;
        message = *message == '%' ? after_conversion(message) : message;
    }
    return 1;
}

static void says(const fail *f, const char *message) {
    CHECK(is_message(f->text, message), "'%s' is not '%s'", f->text, message);
}

/* ---- displays --------------------------------------------------------------------- */

static void model_output(void *context, const uint8_t *report, size_t bytes) {
    model *m = *(model **)context;
    m->kind->output(m, report, bytes);
}

static void model_feature(void *context, const uint8_t *report, size_t bytes) {
    model *m = *(model **)context;
    m->kind->feature(m, report, bytes);
}

static size_t model_input(void *context, uint8_t *report, size_t room) {
    model *m = *(model **)context;
    return m->kind->input == NULL ? 0 : m->kind->input(m, report, room);
}

/* A device of this model, which its handle may exchange for another. */
static fake_device device_of(model **handle, const char *path) {
    const model_kind *kind = (*handle)->kind;
    return (fake_device){.path = path,
                         .vendor = kind->vendor,
                         .product = kind->id,
                         .interface = kind->interface,
                         .serial = L"SN1",
                         .numbered = kind != &model_planelet,
                         .context = handle,
                         .output = model_output,
                         .feature = model_feature,
                         .input = model_input};
}

static session wish_for(const char *device, const char *by, int brightness) {
    return (session){.wish = {drivers, device, by == NULL ? NULL : driver_named(by)},
                     .brightness = brightness,
                     .patience = 0.2};
}

/* Opens what is wished for, and closes it; the failure in `f`. */
static int opens_with(const char *device, const char *by, int brightness, fail *f) {
    session s = wish_for(device, by, brightness);
    *f = (fail){""};
    const int status = session_open(&s, f);
    session_close(&s);
    return status == 0;
}

static int opens(const char *device, const char *by, fail *f) {
    return opens_with(device, by, -1, f);
}

/* ---- finding ----------------------------------------------------------------------- */

static void finding(void) {
    fail f;
    model *nexus = model_make(&model_nexus, (model_shape){0});
    const fake_device known = device_of(&nexus, "1-1:1.0");
    fake_device foreign = device_of(&nexus, "1-2:1.0");
    foreign.vendor = 0x9999;

    static const char none[] =
        "no display among %u HID devices; plug one in, or name one of "
        "planelet-hid list --all with --device and --driver";
    test("no display: plug one in");
    fake_bus_reset();
    CHECK(!opens(NULL, NULL, &f), "opened");
    says(&f, none);
    fake_plug(0, &known);
    CHECK(opens(NULL, NULL, &f), "%s", f.text);

    test("no display: name one with --device and --driver");
    fake_bus_reset();
    fake_plug(0, &foreign);
    CHECK(!opens(NULL, NULL, &f), "opened");
    says(&f, none);
    CHECK(opens("1-2:1.0", "nexus", &f), "%s", f.text);

    test("no driver is for it: choose one with --driver");
    CHECK(!opens("1-2:1.0", NULL, &f), "opened");
    says(&f, "is there (%s), but no driver is for it; choose one with --driver");
    CHECK(opens("1-2:1.0", "nexus", &f), "%s", f.text);

    test("no such device: planelet-hid list has its path, ids and serial number");
    fake_plug(1, &known);
    CHECK(!opens("1-3:1.0", NULL, &f), "opened");
    says(&f,
         "no such device among %u; see planelet-hid list --all for paths, vid:pid and "
         "serial numbers");
    port_info *list;
    char ids[12];
    CHECK(port_list(&list) == 2, "both are listed");
    snprintf(ids, sizeof ids, "%04x:%04x", list[1].vendor, list[1].id);
    CHECK(opens(list[1].path, NULL, &f) && opens(ids, NULL, &f), "%s", f.text);
    CHECK(opens(list[1].serial, NULL, &f), "%s", f.text);
    free(list);
    model_free(nexus);
}

/* ---- opening ------------------------------------------------------------------------- */

static void opening(void) {
    static const char node[] = TEST_FOLDER "test_hid_remedies.node";
    fail f;
    mkdir(TEST_FOLDER, 0777);
    FILE *file = fopen(node, "wb");
    CHECK(file != NULL && fclose(file) == 0, "%s", node);
    model *nexus = model_make(&model_nexus, (model_shape){0});
    fake_device device = device_of(&nexus, "/dev/hidraw-none");

    test("it went away: plug it in again");
    fake_bus_reset();
    fake_plug(0, &device);
    fake_bus.denied = 1;
    CHECK(!opens(NULL, NULL, &f), "opened");
    says(&f, "%04x:%04x went away; plug it in again");
    fake_bus.denied = 0;
    CHECK(opens(NULL, NULL, &f), "%s", f.text);

    test("it cannot be opened: close other programs that use it");
    device.path = node; /* there, and permitted */
    fake_bus.denied = 1;
    CHECK(!opens(NULL, NULL, &f), "opened");
    says(&f, "cannot open %04x:%04x; close other programs that use it, or plug it in again");
    fake_bus.denied = 0;
    CHECK(opens(NULL, NULL, &f), "%s", f.text);

    test("another program shows on it: stop that one, or choose another with --device");
    long holder;
    fake_device beside = device;
    beside.path = "1-2:1.0";
    fake_plug(1, &beside);
    for (int stops = 0; stops < 2; stops++) {
        const int lock = lock_take(node, &holder);
        CHECK(lock >= 0 && !opens(NULL, NULL, &f), "opened");
        says(&f,
             "process %ld shows pictures on %04x:%04x; stop that one, or choose another display "
             "with --device");
        if (!stops) {
            CHECK(opens(beside.path, NULL, &f), "%s", f.text);
        }
        lock_release(lock);
        CHECK(opens(NULL, NULL, &f), "%s", f.text);
    }
    remove(node);

    test("it goes while it is opened: plug it in again");
    fake_bus_reset();
    device.path = "1-1:1.0";
    fake_plug(0, &device);
    fake_bus.refuse_features = 1;
    CHECK(!opens_with(NULL, NULL, 40, &f), "opened");
    says(&f, "the display went away or does not answer; plug it in again");
    fake_plug(0, &device);
    CHECK(opens_with(NULL, NULL, 40, &f), "%s", f.text);
    model_free(nexus);

    test("a display without brightness: leave out --brightness");
    model *apex = model_make(&model_apex, (model_shape){0});
    device = device_of(&apex, "1-1:1.0");
    fake_bus_reset();
    fake_plug(0, &device);
    CHECK(!opens_with(NULL, NULL, 40, &f), "opened");
    says(&f, "its brightness cannot be set; leave out --brightness");
    CHECK(opens(NULL, NULL, &f), "%s", f.text);
    model_free(apex);
}

/* ---- ends of the wire that are no display of ours ------------------------------------------- */

static void end_output(void *context, const uint8_t *report, size_t bytes) {
    wire_on_report(context, report, bytes, clock_ms());
}

static size_t end_input(void *context, uint8_t *report, size_t room) {
    wire_poll(context, clock_ms());
    return room < 64 ? 0 : wire_next_report(context, report, clock_ms());
}

static void swallow(void *context, const uint8_t *report, size_t bytes) {
    (void)context;
    (void)report;
    (void)bytes;
}

static fake_device end_of(wire_peer *peer, unsigned width, unsigned height, unsigned features) {
    const wire_setup setup = {.role = WIRE_DEVICE,
                              .caps = {.session = 1 + clock_ms(),
                                       .width = (uint16_t)width,
                                       .height = (uint16_t)height,
                                       .formats = 1,
                                       .in_bytes = 64,
                                       .out_bytes = 64,
                                       .features = (uint8_t)features,
                                       .credits = 16}};
    CHECK(wire_peer_open(peer, &setup, clock_ms()) == WIRE_OK, "no such end");
    return (fake_device){.path = "1-1:1.0",
                         .vendor = 0x1209,
                         .product = 0x0001,
                         .context = peer,
                         .output = end_output,
                         .input = end_input};
}

static void strangers(void) {
    fail f;
    wire_peer peer;
    model *nexus = model_make(&model_nexus, (model_shape){0});
    const fake_device other = device_of(&nexus, "1-2:1.0");

    static const char silent_says[] =
        "the device does not answer as a planelet display; is it "
        "one? Else choose another with --device or --driver";
    test("a device that does not answer: choose another with --device, or --driver");
    fake_device silent = other;
    silent.path = "1-1:1.0";
    silent.vendor = 0x1209;
    silent.product = 0x0001;
    silent.output = swallow;
    fake_bus_reset();
    fake_plug(0, &silent);
    fake_plug(1, &other);
    CHECK(!opens(NULL, NULL, &f), "opened");
    says(&f, silent_says);
    CHECK(opens("1-2:1.0", NULL, &f), "%s", f.text);
    CHECK(opens("1-1:1.0", "nexus", &f), "%s", f.text);

    test("a device without display: choose another with --device");
    fake_device end = end_of(&peer, 70, 50, 0);
    fake_bus_reset();
    fake_plug(0, &end);
    fake_plug(1, &other);
    CHECK(!opens(NULL, NULL, &f), "opened");
    says(&f, "the device has no display; choose another with --device");
    CHECK(opens("1-2:1.0", NULL, &f), "%s", f.text);

    test("a panel of too many tiles: choose another with --device");
    end = end_of(&peer, 800, 480, WIRE_SHOWS);
    CHECK(!opens(NULL, NULL, &f), "opened");
    says(&f,
         "its %u x %u pixels are %u tiles, %u (WIRE_TILES_MAX) are the most; choose another "
         "with --device");
    CHECK(opens("1-2:1.0", NULL, &f), "%s", f.text);

    test("a panel whose brightness is its own: leave out --brightness");
    end = end_of(&peer, 70, 50, WIRE_SHOWS);
    CHECK(!opens_with("1-1:1.0", NULL, 40, &f), "opened");
    says(&f, "this display's brightness cannot be set; leave out --brightness");
    CHECK(opens("1-1:1.0", NULL, &f), "%s", f.text);
    model_free(nexus);
}

/* ---- while pictures are shown -------------------------------------------------------------- */

static int shows(session *s, fail *f) {
    picture p;
    *f = (fail){""};
    if (picture_make(&p, s->panel.width, s->panel.height, f) != 0) {
        return 0;
    }
    uint32_t noise = 1; /* tiles of noise are long */
    for (unsigned i = 0; i < 3 * p.width * p.height; i++) {
        noise = noise * 1664525u + 1013904223u;
        p.rgb[i] = (uint8_t)(noise >> 24);
    }
    const int status = session_show(s, &p, f) == 0 && session_confirm(s, f) == 0;
    picture_free(&p);
    return status;
}

/* Closes it; a new session opens and shows. */
static void start_again(session *s) {
    fail f = {""};
    session_close(s);
    session again = wish_for(NULL, NULL, -1);
    CHECK(session_open(&again, &f) == 0 && shows(&again, &f), "%s", f.text);
    session_close(&again);
}

static model *panel_of(unsigned width, unsigned height) {
    return model_make(&model_planelet, (model_shape){.width = width, .height = height});
}

static model *next_panel; /* what the device is after it was plugged in again */

static void change_panel(void *context, int in) {
    model **handle = context;
    if (in && next_panel != NULL) {
        model_free(*handle);
        *handle = next_panel;
        next_panel = NULL;
    }
}

static void showing(void) {
    fail f = {""};
    model *panel = panel_of(70, 50);
    fake_device device = device_of(&panel, "1-1:1.0");
    device.plugged = change_panel;

    test("it did not come back in time: plug it in where it was");
    fake_bus_reset();
    fake_plug(0, &device);
    session s = wish_for(NULL, NULL, -1);
    CHECK(session_open(&s, &f) == 0 && shows(&s, &f), "%s", f.text);
    fake_unplug(0);
    CHECK(!shows(&s, &f), "shown");
    says(&f, "the display did not come back in %g seconds; plug it in where it was");
    fake_plug(0, &device);
    start_again(&s);

    test("it refuses every report: plug it in again, or choose another");
    model *nexus = model_make(&model_nexus, (model_shape){0});
    const fake_device deaf = device_of(&nexus, "1-2:1.0");
    fake_plug(1, &deaf);
    s = wish_for("1-2:1.0", NULL, -1);
    CHECK(session_open(&s, &f) == 0, "%s", f.text);
    fake_bus.refuse_outputs = UINT32_MAX;
    CHECK(!shows(&s, &f), "shown");
    says(&f,
         "the display is there, but refuses reports; plug it in again, or choose another with "
         "--device or --driver");
    fake_bus.refuse_outputs = 0;
    start_again(&s);
    s = wish_for("1-1:1.0", NULL, -1);
    CHECK(session_open(&s, &f) == 0 && shows(&s, &f), "%s", f.text);
    session_close(&s);
    fake_unplug(1);
    model_free(nexus);

    test("it came back with another size: start again");
    s = wish_for(NULL, NULL, -1);
    s.patience = 3.0;
    CHECK(session_open(&s, &f) == 0 && shows(&s, &f), "%s", f.text);
    next_panel = panel_of(64, 48);
    fake_bus.unplug_after = 1;
    fake_bus.replug_ms = 50;
    CHECK(!shows(&s, &f), "shown");
    says(&f, "the display came back with %u x %u pixels instead of %u x %u; start again");
    fake_bus.unplug_after = 0;
    start_again(&s);

    test("it changed its size without going: start again");
    s = wish_for(NULL, NULL, -1);
    CHECK(session_open(&s, &f) == 0 && shows(&s, &f), "%s", f.text);
    model_free(panel);
    panel = panel_of(70, 50);
    CHECK(!shows(&s, &f), "shown");
    says(&f, "the display changed its size to %u x %u; start again");
    start_again(&s);

    test("too many reports are lost: try another cable");
    s = wish_for(NULL, NULL, -1);
    CHECK(session_open(&s, &f) == 0, "%s", f.text);
    fake_bus.drop_outputs = 2;
    fake_bus.short_writes = 3;
    CHECK(!shows(&s, &f), "shown");
    says(&f,
         "the display answers, but no picture gets through in %u seconds: too many reports "
         "are lost; try another cable or port");
    fake_bus.drop_outputs = fake_bus.short_writes = 0;
    start_again(&s);

    test("it has no picture of its own: leave out --release");
    s = wish_for(NULL, NULL, -1);
    CHECK(session_open(&s, &f) == 0 && shows(&s, &f), "%s", f.text);
    CHECK(session_release(&s, &f) != 0, "released");
    says(&f, "it has no picture of its own; leave out --release");
    start_again(&s);

    test("it refuses its own picture, or went before it had it back: plug it in again");
    model *mini = model_make(&model_mini, (model_shape){0});
    const fake_device own = device_of(&mini, "1-2:1.0");
    fake_plug(1, &own);
    s = wish_for("1-2:1.0", NULL, -1);
    CHECK(session_open(&s, &f) == 0 && shows(&s, &f), "%s", f.text);
    fake_bus.refuse_features = UINT32_MAX;
    CHECK(session_release(&s, &f) != 0, "released");
    says(&f, "refuses to show its own picture again; plug it in again, which gives it back, too");
    f = (fail){""};
    fake_bus.refuse_features = 0;
    fake_unplug(1);
    CHECK(session_release(&s, &f) != 0, "released");
    says(&f,
         "went away before it had its own picture back; plug it in again, which gives it back, "
         "too");
    session_close(&s);
    model_free(mini);
    mini = model_make(&model_mini, (model_shape){0}); /* as it is with power again */
    fake_plug(1, &own);
    s = wish_for("1-2:1.0", NULL, -1);
    CHECK(session_open(&s, &f) == 0 && shows(&s, &f), "%s", f.text);
    CHECK(session_release(&s, &f) == 0 && mini->releases == 1, "%s", f.text);
    session_close(&s);
    fake_unplug(1);
    model_free(mini);
    CHECK(fake_bus.open == 0 && fake_bus.wrong == 0, "hidapi was used as it should");
    model_free(panel);
}

int main(void) {
    /* Messages of sessions are meant for a person. */
    if (freopen("/dev/null", "w", stderr) == NULL) {
        return 1;
    }
    finding();
    opening();
    strangers();
    showing();
    return test_done();
}
