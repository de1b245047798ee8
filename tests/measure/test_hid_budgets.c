/* test_hid_budgets - reports that a picture takes on each display, and what buses make of them
 *
 * A scene that moves: all of the picture changes in every frame. A bus of full speed carries 64
 * bytes of an endpoint per millisecond, one of high speed a report of up to 1024 bytes in each of
 * 8,000 microframes per second at most; what devices ask for (an endpoint's interval) and can take
 * is not known here, so 1,000 reports per second are given, too. Feature reports go through
 * endpoint 0, which has no such limit: they count as output reports do.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/display_bench.h"

enum { FRAMES = 8 };

static void scene(picture *p, unsigned frame) {
    for (unsigned i = 0; i < p->width * p->height; i++) {
        const unsigned x = i % p->width, y = i / p->width;
        const int dx = (int)(x + 3 * frame) - (int)p->width / 2, dy = (int)y - (int)p->height / 2;
        const int inside = dx * dx + dy * dy < (int)(p->height * p->height) / 6;
        p->rgb[3 * i] =
            (uint8_t)(inside ? 220 - y * 90 / p->height : 40 + x * 60 / p->width + frame);
        p->rgb[3 * i + 1] = (uint8_t)(inside ? 150 : 60 + y * 60 / p->height + 2 * frame);
        p->rgb[3 * i + 2] = (uint8_t)(inside ? 60 + x * 90 / p->width : 130);
    }
}

static void measure(const model_kind *kind) {
    bench b;
    fail f = {""};
    test(kind->name);
    open_bench(&b, kind);
    double reports = 0, packets = 0;
    for (unsigned frame = 0; frame < FRAMES; frame++) {
        scene(&b.shown, frame);
        record.count = 0;
        CHECK(b.display.by->show(&b.display, &b.shown, &f) == DISPLAY_OK, "%s", f.text);
        CHECK(record.count > 0 && record.count < RECORD, "%u reports", record.count);
        reports += record.count;
        for (unsigned i = 0; i < record.count; i++) {
            packets += (double)((record.size[i] + 63) / 64);
        }
    }
    reports /= FRAMES;
    packets /= FRAMES;
    printf(
        "    %-20s %3ux%-3u %6.1f reports of %4zu bytes: full speed %6.1f, 1,000 reports %6.1f, "
        "high speed %6.1f frames per second\n",
        kind->name, kind->width, kind->height, reports, record.size[0], 1000 / packets,
        1000 / reports, 8000 / (reports * (double)((record.size[0] + 1023) / 1024)));
    close_bench(&b);
}

/* A Planelet display has any size and reports of any: make test-hid measures films on one. */
int main(void) {
    for (unsigned i = 0; drivers[i] != NULL; i++) {
        const model_kind *kind = model_kind_named(drivers[i]->name);
        CHECK(kind != NULL, "%s has no model", drivers[i]->name);
        if (kind != NULL && kind != &model_planelet) {
            measure(kind);
        }
    }
    return test_done();
}
