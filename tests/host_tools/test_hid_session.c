/* test_hid_session - unplugged in the middle of a frame, and back again
 *
 * SPDX-License-Identifier: MIT */
#include <signal.h>
#include <sys/time.h>

#include "host_tools/base/clock.h"
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

static const model_kind *const kinds[] = {&model_nexus, &model_mini, &model_nova, &model_apex};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

static void refuse_all(void) {
    fake_bus.refuse_outputs = fake_bus.refuse_features = UINT32_MAX;
}

static void refuses(const model_kind *kind) {
    bench b;
    fail f = {""};
    open_bench(&b, kind);
    b.session.patience = 0.5;
    b.session.brightness = -1;
    refuse_all();
    const double began = clock_seconds();
    CHECK(show(&b, 1, &f) == -1, "%s: shown", kind->name);
    CHECK(strstr(f.text, "is there, but refuses reports"), "%s: %s", kind->name, f.text);
    CHECK(clock_seconds() - began < 2.5, "%s: %.1f s", kind->name, clock_seconds() - began);
    CHECK(fake_bus.opens <= 8, "%s: opened %u times", kind->name, (unsigned)fake_bus.opens);
    fake_bus.refuse_outputs = fake_bus.refuse_features = 0;
    CHECK(show(&b, 2, &f) == 0 && model_shows_pattern(b.model, 2, 1) == 2, "%s: %s", kind->name,
          f.text);
    close_bench(&b);
}

static volatile sig_atomic_t stop;
static double stopped_at;

static void on_alarm(int number) {
    (void)number;
    stop = 1;
    stopped_at = clock_seconds();
}

static void alarm_in(unsigned ms) {
    const struct sigaction action = {.sa_handler = on_alarm};
    const struct itimerval when = {.it_value = {.tv_usec = (suseconds_t)(1000 * ms)}};
    stop = 0;
    sigaction(SIGALRM, &action, NULL);
    setitimer(ITIMER_REAL, &when, NULL);
}

/* The 0.2 s that are promised, and some for a busy machine. */
static void ends_soon(const model_kind *kind, const fail *f, const char *why) {
    const double late = clock_seconds() - stopped_at;
    CHECK(stop && late < 0.5, "%s: %.3f s after the signal", kind->name, late);
    CHECK(strstr(f->text, why), "%s: %s", kind->name, f->text);
}

static void stops_waiting(const model_kind *kind) {
    bench b;
    fail f = {""};
    open_bench(&b, kind);
    b.session.patience = 60.0;
    b.session.stop = &stop;
    refuse_all();
    alarm_in(250);
    CHECK(show(&b, 1, &f) == -1, "%s: shown", kind->name);
    ends_soon(kind, &f, "stopped before the display was back");
    fake_unplug(0);
    f = (fail){""};
    alarm_in(150);
    CHECK(show(&b, 1, &f) == -1, "%s: shown", kind->name);
    ends_soon(kind, &f, "stopped before the display was back");
    close_bench(&b);
}

/* `slow_ms` of a report, and when the signal comes. */
static void stops_sending(const model_kind *kind, unsigned slow_ms, unsigned ms) {
    bench b;
    fail f = {""};
    open_bench(&b, kind);
    b.session.display.stop = b.session.stop = &stop;
    fake_bus.slow_us = 1000 * slow_ms;
    alarm_in(ms);
    CHECK(show(&b, 1, &f) == 0 && session_confirm(&b.session, &f) == 0, "%s", f.text);
    ends_soon(kind, &f, "");
    CHECK(kind != &model_nova || model_shows_pattern(b.model, 1, 1) == 1, "half a picture");
    CHECK(b.session.reconnects == 0, "opened anew");
    close_bench(&b);
}

static void barred(void) {
    bench b;
    fail f = {""};
    test("back, but it may not be opened: the reason is said, not that it is away");
    open_bench(&b, &model_apex);
    b.session.patience = 0.3;
    fake_bus.denied = 1;
    refuse_all();
    CHECK(show(&b, 1, &f) == -1, "shown");
    CHECK(strstr(f.text, "cannot open") || strstr(f.text, "no permission"), "%s", f.text);
    close_bench(&b);
}

/* The tick as a program that shows a still picture does it. */
static int rest(bench *b, double seconds) {
    const double end = clock_seconds() + seconds;
    int status = 0;
    while (status == 0 && clock_seconds() < end) {
        status = session_tick(&b->session);
        clock_sleep(0.004);
    }
    return status;
}

static void is_renewed(const model_kind *kind) {
    bench b;
    fail f = {""};
    open_bench(&b, kind);
    CHECK(show(&b, 1, &f) == 0 && session_confirm(&b.session, &f) == 0, "%s", f.text);
    memset(b.model->rgb, 0x55, 3 * (size_t)b.model->width * b.model->height);
    CHECK(rest(&b, 1.9) == 0 && model_shows_pattern(b.model, 1, 1) == 1, "%s", kind->name);
    const uint64_t before = fake_bus.outputs + fake_bus.features;
    rest(&b, 1.5);
    const unsigned sent = (unsigned)(fake_bus.outputs + fake_bus.features - before);
    CHECK(sent <= 130, "%s: %u reports in 1.5 s", kind->name, sent); /* a Nexus has 121 */
    close_bench(&b);
}

static void unplugged_at_rest(const model_kind *kind) {
    bench b;
    fail f = {""};
    open_bench(&b, kind);
    CHECK(show(&b, 1, &f) == 0 && session_confirm(&b.session, &f) == 0, "%s", f.text);
    fake_unplug(0);
    b.session.patience = 0.3;
    CHECK(rest(&b, 2.0) != 0, "%s: nobody noticed", kind->name);
    CHECK(show(&b, 2, &f) != 0 && strstr(f.text, "did not come back"), "%s: %s", kind->name,
          f.text);
    fake_plug(0, &b.device);
    CHECK(show(&b, 2, &f) == 0 && model_shows_pattern(b.model, 2, 1) == 2, "%s: %s", kind->name,
          f.text);
    close_bench(&b);
}

static void release_refused(const model_kind *kind) {
    bench b;
    fail f = {""};
    open_bench(&b, kind);
    CHECK(show(&b, 1, &f) == 0, "%s", f.text);
    fake_bus.refuse_reports = 3;
    CHECK(session_release(&b.session, &f) == 0 && b.model->releases == 1, "%s: %s", kind->name,
          f.text);
    refuse_all();
    const double began = clock_seconds();
    CHECK(session_release(&b.session, &f) != 0, "%s: released", kind->name);
    const double took = clock_seconds() - began;
    CHECK(took > 0.9 && took < 2.0, "%s: %.3f s", kind->name, took);
    CHECK(strstr(f.text, "refuses to show its own picture again"), "%s: %s", kind->name, f.text);
    f = (fail){""};
    b.session.stop = &stop;
    alarm_in(100);
    CHECK(session_release(&b.session, &f) != 0, "%s: released", kind->name);
    ends_soon(kind, &f, "refuses to show its own picture again");
    fake_bus.refuse_outputs = fake_bus.refuse_features = 0;
    CHECK(session_release(&b.session, &f) == 0 && b.model->releases == 2, "%s: once, after a stop",
          kind->name);
    close_bench(&b);
}

static void no_brightness(void) {
    fail f = {""};
    test("brightness of a display that has none is an error that says so");
    bench b;
    open_bench(&b, &model_nova);
    session_close(&b.session);
    fake_device apex = b.device;
    apex.path = "1-2:1.0";
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
    test("a display that opens and refuses every report: pauses, a limit, a sentence");
    for (unsigned i = 0; i < KINDS; i++) {
        refuses(kinds[i]);
    }
    test("a signal ends a wait for a display that refuses reports, or is away");
    for (unsigned i = 0; i < KINDS; i++) {
        stops_waiting(kinds[i]);
    }
    test("... and a picture whose reports take 30 ms each");
    stops_sending(&model_nexus, 30, 100);
    stops_sending(&model_mini, 30, 100);
    test("... and one that comes between two windows leaves no half, and is no failure");
    stops_sending(&model_nova, 60, 30);
    barred();
    test("a panel that lost its picture is whole again in two seconds, though nothing changes");
    for (unsigned i = 0; i < KINDS; i++) {
        is_renewed(kinds[i]);
    }
    test("a display that is unplugged while a picture stays is waited for, and the reason is kept");
    for (unsigned i = 0; i < KINDS; i++) {
        unplugged_at_rest(kinds[i]);
    }
    test("a display that refuses to show its own picture again: some tries, a limit, a sentence");
    release_refused(&model_mini);
    release_refused(&model_nova);
    release_refused(&model_nexus);
    no_brightness();
    return test_done();
}
