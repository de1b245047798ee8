/* test_hid_planelet - the own wire through a fake hidapi and all its quirks
 *
 * A picture that was confirmed is on the panel in every pixel, and it is compared
 * in every pixel (W4 of platform/WIRE.md). While reports are lost, what nobody
 * confirmed may be there in part: only then is it compared row of tile by row of
 * tile, each of which must be that of one of the pictures (W3).
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "host_tools/hid/device/session.h"
#include "host_tools/hid/drivers/drivers.h"
#include "platform/wire/wire_format.h"
#include "tests/hid/model.h"
#include "tests/hid/pattern.h"
#include "tests/reference/fake_hidapi.h"
#include "tests/test.h"

typedef struct bench {
    model *model;
    fake_device device;
    unsigned format, report_bytes, in_bytes;
    int reads;       /* the panel can be read: tiles may say only what differs */
    int lossy;       /* rows of tiles may be late: each must be that of some picture */
    int runs_on;     /* one picture into the next; else each is waited for */
    int last, other; /* the picture seen last; panels that were none */
} bench;

static void on_output(void *context, const uint8_t *report, size_t bytes) {
    bench *b = context;
    b->model->kind->output(b->model, report, bytes);
}

static size_t on_input(void *context, uint8_t *report, size_t room) {
    bench *b = context;
    return b->model->kind->input(b->model, report, room);
}

/* A frame came whole: without losses the panel is one of the pictures, none
 * older than the last. */
static void on_change(void *context, model *m) {
    bench *b = context;
    if (b->lossy) {
        b->other += !model_rows_are_whole(m, 0, 8);
        return;
    }
    const int found = model_shows_pattern(m, (unsigned)(b->last < 0 ? 0 : b->last), 40);
    b->other += found < 0;
    b->last = found < 0 ? b->last : found;
}

static void new_model(bench *b) {
    model_free(b->model);
    b->model = model_make(&model_planelet, (model_shape){70, 50, b->format, b->report_bytes,
                                                         b->reads, b->in_bytes, 0});
    b->model->changed = on_change;
    b->model->context = b;
}

/* Power comes back: the panel is dark and knows nothing. */
static void on_plug(void *context, int in) {
    if (in) {
        new_model(context);
    }
}

static void make_bench(bench *b, unsigned format, unsigned report_bytes) {
    *b = (bench){.format = format, .report_bytes = report_bytes, .last = -1};
    b->reads = format % 2 == 1;
    fake_bus_reset();
    b->device = (fake_device){.path = "1-1:1.0",
                              .vendor = 0x1209,
                              .product = 0x0001,
                              .context = b,
                              .output = on_output,
                              .input = on_input,
                              .plugged = on_plug};
    fake_plug(0, &b->device);
}

static void free_bench(bench *b) {
    CHECK(fake_bus.wrong == 0 && fake_bus.open == 0, "hidapi was used as it should");
    CHECK(b->other == 0, "%d panels were no picture", b->other);
    model_free(b->model);
}

/* As display_open, but reports have the model's size, not the system's. */
static int open_display(bench *b, display *d, fail *f) {
    port_info *info;
    CHECK(port_list(&info) == 1, "it is on the bus");
    *d = (display){.by = &driver_planelet, .reports = {b->report_bytes, b->in_bytes}};
    d->port = port_open(info, f);
    free(info);
    const int status = d->by->open(d, f);
    CHECK(status == DISPLAY_OK && d->width == 70 && d->height == 50, "%d: %s", status, f->text);
    return status;
}

static void show_pictures(bench *b, unsigned count) {
    display d;
    picture p;
    fail f = {""};
    if (open_display(b, &d, &f) != DISPLAY_OK) {
        return;
    }
    picture_make(&p, d.width, d.height, &f);
    for (unsigned n = 0; n < count; n++) {
        pattern_fill(n, p.width, p.height, p.rgb);
        const int status = d.by->show(&d, &p, &f);
        CHECK(status == DISPLAY_OK, "picture %u: %d %s", n, status, f.text);
        if (!b->runs_on || n + 1 == count) {
            CHECK(d.by->confirm(&d, &f) == DISPLAY_OK, "%s", f.text);
            CHECK(model_shows_pattern(b->model, n, 1) >= 0, "picture %u, format %u, reports of %u",
                  n, b->format, b->report_bytes);
        }
    }
    picture_free(&p);
    display_close(&d);
}

static void formats(void) {
    static const unsigned sizes[] = {8, 16, 32, 64, 128, 256, 512, 1024};
    test("every pixel format in reports of 8 to 1024 bytes: every pixel of every frame");
    for (unsigned format = 0; format < WIRE_FORMATS; format++) {
        for (unsigned i = 0; i < 8; i++) {
            bench b;
            make_bench(&b, format, sizes[i]);
            b.in_bytes = sizes[i] < 64 ? sizes[i] : 64;
            new_model(&b);
            show_pictures(&b, 8);
            CHECK(b.last == 7, "%d", b.last);
            free_bench(&b);
        }
    }
}

/* What goes wrong between host and display: one report in so many; 0: none. */
typedef struct quirk {
    unsigned drop, cut, empty, slow_us;
    int runs_on;
} quirk;

static void meet(const char *sentence, quirk q) {
    test(sentence);
    for (unsigned format = 0; format < WIRE_FORMATS; format++) {
        bench b;
        make_bench(&b, format, 64);
        b.lossy = q.drop + q.cut > 0;
        b.runs_on = q.runs_on;
        fake_bus.drop_outputs = q.drop;
        fake_bus.short_writes = q.cut;
        fake_bus.empty_reads = q.empty;
        fake_bus.slow_us = q.slow_us;
        show_pictures(&b, 6);
        free_bench(&b);
    }
}

static void quirks(void) {
    meet("reads that are empty before their time: nothing is lost", (quirk){.empty = 2});
    meet("a slow bus: every picture arrives", (quirk){.slow_us = 500});
    meet("one report in seven never arrives: every pixel of every picture does",
         (quirk){.drop = 7});
    meet("one write in nine accepts half a report: every pixel of every picture arrives",
         (quirk){.cut = 9});
    meet("all of it together: every pixel of every picture",
         (quirk){.drop = 11, .cut = 13, .empty = 3, .slow_us = 100});
    meet("one report in seven is lost, pictures run on: the last is whole",
         (quirk){.drop = 7, .runs_on = 1});
    meet("one write in five accepts half a report, pictures run on: the last is whole",
         (quirk){.cut = 5, .runs_on = 1});
    meet("all of it together, pictures run on: the last is whole",
         (quirk){.drop = 11, .cut = 13, .empty = 3, .slow_us = 100, .runs_on = 1});
}

static void draw_noise(picture *p, fail *f) {
    uint32_t noise = 1;
    picture_make(p, 70, 50, f);
    for (unsigned i = 0; i < 3 * p->width * p->height; i++) {
        noise = noise * 1664525u + 1013904223u;
        p->rgb[i] = (uint8_t)(noise >> 24);
    }
}

/* A raw tile needs nine reports of 64 bytes in a row, so none gets through. */
static void hopeless(void) {
    test("two reports of three lost: an error names the cable, nothing waits for ever");
    bench b;
    display d;
    fail f = {""};
    make_bench(&b, WIRE_RGB565, 64);
    b.lossy = 1;
    if (open_display(&b, &d, &f) == DISPLAY_OK) {
        picture p;
        draw_noise(&p, &f);
        fake_bus.drop_outputs = 2;
        fake_bus.short_writes = 3;
        int status = d.by->show(&d, &p, &f);
        status = status == DISPLAY_OK ? d.by->confirm(&d, &f) : status;
        CHECK(status == DISPLAY_FAILED && strstr(f.text, "cable"), "%d: %s", status, f.text);
        picture_free(&p);
        display_close(&d);
    }
    CHECK(fake_bus.wrong == 0 && fake_bus.open == 0, "hidapi was used as it should");
    model_free(b.model);
}

static void stopped(void) {
    test("Ctrl-C ends the wait for a picture that does not get through, without an error");
    static volatile sig_atomic_t stop;
    bench b;
    picture p;
    fail f = {""};
    make_bench(&b, WIRE_RGB565, 64);
    b.lossy = 1;
    session s = {.wish.drivers = drivers, .brightness = -1, .patience = 5.0, .stop = &stop};
    CHECK(session_open(&s, &f) == 0, "%s", f.text);
    draw_noise(&p, &f);
    fake_bus.drop_outputs = 2;
    fake_bus.short_writes = 3;
    stop = 1;
    CHECK(session_show(&s, &p, &f) == 0 && session_confirm(&s, &f) == 0, "%s", f.text);
    CHECK(f.text[0] == '\0' && s.reconnects == 0, "%s", f.text);
    fake_bus.drop_outputs = fake_bus.short_writes = 0;
    picture_free(&p);
    session_close(&s);
    free_bench(&b);
    test("... and one on a good link is confirmed before it ends");
    make_bench(&b, WIRE_RGB565, 64);
    s = (session){.wish.drivers = drivers, .brightness = -1, .patience = 5.0, .stop = &stop};
    CHECK(session_open(&s, &f) == 0, "%s", f.text);
    picture_make(&p, 70, 50, &f);
    pattern_fill(3, 70, 50, p.rgb);
    CHECK(session_show(&s, &p, &f) == 0 && session_confirm(&s, &f) == 0, "%s", f.text);
    CHECK(model_shows_pattern(b.model, 3, 1) >= 0, "it is not there");
    picture_free(&p);
    session_close(&s);
    free_bench(&b);
}

static void unplugged(int libusb) {
    test(libusb ? "libusb: gone in mid-frame, the whole picture is back within two seconds"
                : "hidraw: gone in mid-frame, the whole picture is back within two seconds");
    for (unsigned after = 3; after < 48; after += 8) {
        bench b;
        picture p;
        fail f = {""};
        make_bench(&b, WIRE_RGB565, 64);
        b.lossy = 1;
        fake_bus.libusb = libusb;
        session s = {.wish.drivers = drivers, .brightness = 30, .patience = 5.0};
        CHECK(session_open(&s, &f) == 0, "%s", f.text);
        picture_make(&p, 70, 50, &f);
        fake_bus.unplug_after = after;
        fake_bus.replug_ms = 150;
        for (unsigned n = 0; n < 4; n++) {
            pattern_fill(n, 70, 50, p.rgb);
            CHECK(session_show(&s, &p, &f) == 0, "after %u: %s", after, f.text);
        }
        CHECK(session_confirm(&s, &f) == 0, "after %u: %s", after, f.text);
        CHECK(model_shows_pattern(b.model, 3, 1) >= 0, "after %u reports", after);
        CHECK(b.model->brightness == 30, "brightness %d", b.model->brightness);
        CHECK(s.reconnects == 1 && s.longest_gap < 2.0, "%u, %.3f s", s.reconnects, s.longest_gap);
        picture_free(&p);
        session_close(&s);
        free_bench(&b);
    }
}

int main(void) {
    /* Messages of sessions are meant for a person. */
    if (freopen("/dev/null", "w", stderr) == NULL) {
        return 1;
    }
    formats();
    quirks();
    hopeless();
    stopped();
    unplugged(0);
    unplugged(1);
    return test_done();
}
