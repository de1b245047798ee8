/* test_hid_session - unplugged in the middle of a frame, and back again
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/device/session.h"
#include "host_tools/hid/drivers/drivers.h"
#include "tests/hid/model.h"
#include "tests/hid/pattern.h"
#include "tests/reference/fake_hidapi.h"
#include "tests/test.h"

static void on_output(void *context, const uint8_t *report, size_t bytes) {
    model *m = context;
    m->kind->output(m, report, bytes);
}

static void on_feature(void *context, const uint8_t *report, size_t bytes) {
    model *m = context;
    m->kind->feature(m, report, bytes);
}

/* What was on the panel is lost with the power. */
static void on_plug(void *context, int in) {
    model *m = context;
    if (in) {
        memset(m->rgb, 0x55, 3 * (size_t)m->width * m->height);
        m->brightness = -1;
    }
}

typedef struct bench {
    model *model;
    fake_device device;
    session session;
    picture shown;
} bench;

static void open_bench(bench *b, const model_kind *kind) {
    fail f = {""};
    memset(b, 0, sizeof *b);
    fake_bus_reset();
    b->model = model_make(kind, (model_shape){0});
    b->device = (fake_device){.path = "1-1:1.0",
                              .vendor = kind->vendor,
                              .product = kind->id,
                              .interface = kind->interface,
                              .serial = L"SN1",
                              .numbered = 1,
                              .context = b->model,
                              .output = on_output,
                              .feature = on_feature,
                              .plugged = on_plug};
    fake_plug(0, &b->device);
    b->session = (session){
        .wish.drivers = drivers, .brightness = kind == &model_apex ? -1 : 40, .patience = 3.0};
    CHECK(session_open(&b->session, &f) == 0, "%s", f.text);
    picture_make(&b->shown, b->session.panel.width, b->session.panel.height, &f);
}

static void close_bench(bench *b) {
    session_close(&b->session);
    CHECK(fake_bus.open == 0 && fake_bus.wrong == 0, "hidapi was used as it should");
    picture_free(&b->shown);
    model_free(b->model);
}

static int show(bench *b, unsigned number, fail *f) {
    pattern_fill(number, b->shown.width, b->shown.height, b->shown.rgb);
    return session_show(&b->session, &b->shown, f);
}

/* What 40 % arrives as: the Nova has steps of ten, the Apex no brightness. */
static int brightness_of(const model_kind *kind) {
    return kind == &model_apex ? -1 : kind == &model_nova ? 4 : 40;
}

static void comes_back(const model_kind *kind, int libusb, unsigned after) {
    bench b;
    fail f = {""};
    open_bench(&b, kind);
    fake_bus.libusb = libusb;
    CHECK(show(&b, 0, &f) == 0, "%s", f.text);
    fake_bus.unplug_after = after;
    fake_bus.replug_ms = 250;
    /* Twice: that a display of one report per frame is gone only the next frame notices. */
    CHECK(show(&b, 1, &f) == 0 && show(&b, 1, &f) == 0, "%s", f.text);
    CHECK(session_confirm(&b.session, &f) == 0, "%s", f.text);
    CHECK(model_shows_pattern(b.model, 1, 1) == 1, "after %u reports", after);
    CHECK(b.session.reconnects == 1, "%u", b.session.reconnects);
    CHECK(b.session.longest_gap < 2.0, "%.3f s", b.session.longest_gap);
    CHECK(b.model->brightness == brightness_of(kind), "brightness %d", b.model->brightness);
    port_statistics statistics;
    session_statistics(&b.session, &statistics);
    CHECK(statistics.reports >= fake_bus.outputs + fake_bus.features - 1, "reports of both times");
    close_bench(&b);
}

static void never_back(void) {
    bench b;
    fail f = {""};
    test("a display that stays away: an error after the time to wait, with a remedy");
    open_bench(&b, &model_nova);
    b.session.patience = 0.3;
    fake_bus.unplug_after = 1;
    CHECK(show(&b, 1, &f) == -1, "shown");
    CHECK(strstr(f.text, "did not come back") && strstr(f.text, "plug it in"), "%s", f.text);
    close_bench(&b);
}

static void other_device(void) {
    bench b;
    fail f = {""};
    test("another display of the same kind is not mistaken for the one that went");
    open_bench(&b, &model_nova);
    fake_device other = b.device;
    other.serial = L"SN2";
    other.path = "1-2:1.0";
    fake_plug(1, &other);
    b.session.patience = 0.3;
    fake_bus.unplug_after = 1;
    CHECK(show(&b, 1, &f) == -1, "shown on the other one");
    close_bench(&b);
}

static void no_brightness(void) {
    fail f = {""};
    test("brightness of a display that has none is an error that says so");
    bench b;
    open_bench(&b, &model_nova);
    session_close(&b.session);
    fake_device apex = b.device;
    apex.product = model_apex.id;
    apex.interface = 1;
    fake_plug(1, &apex);
    session s = {.wish = {drivers, "1038:1618", NULL}, .brightness = 5};
    CHECK(session_open(&s, &f) == -1 && strstr(f.text, "--brightness"), "%s", f.text);
    session_close(&s);
    close_bench(&b);
}

int main(void) {
    /* Its messages on standard error are meant for a person. */
    if (freopen("/dev/null", "w", stderr) == NULL) {
        return 1;
    }
    for (int libusb = 0; libusb < 2; libusb++) {
        test(libusb ? "libusb: gone in mid-frame, the whole picture is back within two seconds"
                    : "hidraw: gone in mid-frame, the whole picture is back within two seconds");
        comes_back(&model_nexus, libusb, 60);
        comes_back(&model_nexus, libusb, 120);
        comes_back(&model_mini, libusb, 1);
        comes_back(&model_mini, libusb, 13);
        comes_back(&model_apex, libusb, 1);
        comes_back(&model_nova, libusb, 1);
    }
    never_back();
    other_device();
    no_brightness();
    return test_done();
}
