/* test_hid_gaps - pictures that go on behind the frame around keys
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/device/gaps.h"

#include <stdlib.h>

#include "host_tools/hid/device/session.h"
#include "host_tools/hid/drivers/drivers.h"
#include "tests/hid/model.h"
#include "tests/reference/fake_hidapi.h"
#include "tests/test.h"

enum { GRIDS = 6 };

static const struct {
    const driver *by;
    unsigned width, height, span_width, span_height;
} sizes[GRIDS] = {
    {&driver_streamdeck_mini, 240, 160, 296, 188},
    {&driver_streamdeck_original, 360, 216, 460, 266},
    {&driver_streamdeck, 360, 216, 460, 266},
    {&driver_streamdeck_xl, 768, 384, 992, 501},
    {&driver_streamdeck_neo, 384, 237, 474, 222 + 30 + 56},
    {&driver_streamdeck_plus, 480, 300, 777, 280 + 40 + 97},
};

static void span_sizes(void) {
    test("a picture with gaps has the keys, the gaps between them, and what is below, enlarged");
    for (unsigned i = 0; i < GRIDS; i++) {
        unsigned width = 0, height = 0;
        gaps_size(sizes[i].by->grid, sizes[i].width, sizes[i].height, &width, &height);
        CHECK(width == sizes[i].span_width && height == sizes[i].span_height, "%s: %ux%u",
              sizes[i].by->name, width, height);
    }
}

/* Where a pixel of the picture says that it is. */
static void number_pixels(picture *p) {
    for (unsigned i = 0; i < p->width * p->height; i++) {
        p->rgb[3 * i] = (uint8_t)(i % p->width);
        p->rgb[3 * i + 1] = (uint8_t)(i / p->width);
        p->rgb[3 * i + 2] = (uint8_t)(i % p->width >> 8 << 4 | i / p->width >> 8);
    }
}

static unsigned x_of(const uint8_t *rgb) {
    return rgb[0] | (unsigned)rgb[2] >> 4 << 8;
}

static unsigned y_of(const uint8_t *rgb) {
    return rgb[1] | (rgb[2] & 15u) << 8;
}

/* Counts what is off. */
static unsigned compare(const key_grid *g, const picture *span, const picture *panel) {
    unsigned off = 0;
    for (unsigned i = 0; i < panel->width * panel->height; i++) {
        const unsigned x = i % panel->width, y = i / panel->width;
        const unsigned from_x = x_of(panel->rgb + 3 * i), from_y = y_of(panel->rgb + 3 * i);
        if (y < g->rows * g->side) {
            off += from_x != x + x / g->side * g->gap_x || from_y != y + y / g->side * g->gap_y;
        } else {
            const double scale = (double)span->width / panel->width;
            const double top = g->rows * (g->side + g->gap_y);
            const double to_x = (x + 0.5) * scale - 0.5;
            const double to_y = top + (y - g->rows * g->side + 0.5) * scale - 0.5;
            off += from_x > to_x + 1 || from_x + 1 < to_x || from_y > to_y + 1 || from_y + 1 < to_y;
        }
    }
    return off;
}

static void cuts(void) {
    test("what of it is on the panel: keys pixel by pixel, what is below them to the nearest");
    for (unsigned i = 0; i < GRIDS; i++) {
        picture span = {0}, panel = {0};
        fail f = {""};
        CHECK(picture_make(&span, sizes[i].span_width, sizes[i].span_height, &f) == 0 &&
                  picture_make(&panel, sizes[i].width, sizes[i].height, &f) == 0,
              "%s", f.text);
        number_pixels(&span);
        gaps_cut(sizes[i].by->grid, &span, &panel);
        const unsigned off = compare(sizes[i].by->grid, &span, &panel);
        CHECK(off == 0, "%s: %u pixels", sizes[i].by->name, off);
        picture_free(&span);
        picture_free(&panel);
    }
}

static void symbols(void) {
    test("a symbol stays in its key");
    for (unsigned i = 0; i < GRIDS; i++) {
        const driver *by = sizes[i].by;
        display_key moved[KEYS_MOST + 1];
        gaps_keys(by->grid, by->keys, moved);
        unsigned k = 0;
        for (; by->keys[k].name != NULL; k++) {
            const unsigned x = by->keys[k].x, y = by->keys[k].y, side = by->grid->side;
            CHECK(moved[k].name == by->keys[k].name && moved[k].action == by->keys[k].action, "%u",
                  k);
            CHECK(moved[k].x / (side + by->grid->gap_x) == x / side &&
                      moved[k].x % (side + by->grid->gap_x) == x % side &&
                      moved[k].y / (side + by->grid->gap_y) == y / side &&
                      moved[k].y % (side + by->grid->gap_y) == y % side,
                  "%s: %s at %u, %u", by->name, moved[k].name, moved[k].x, moved[k].y);
        }
        CHECK(moved[k].name == NULL, "%s: no end", by->name);
    }
}

/* ---- all of it --------------------------------------------------------------------------------
 */

static void on_output(void *context, const uint8_t *report, size_t bytes) {
    model *m = context;
    m->kind->output(m, report, bytes);
}

static void shown(void) {
    fail f = {""};
    picture p = {0};
    session s = {.wish.drivers = drivers, .fit = FIT_NONE, .gaps = 1, .brightness = -1};
    model *m = model_make(&model_mini, (model_shape){0});
    const fake_device device = {.path = "1-1:1.0",
                                .vendor = m->kind->vendor,
                                .product = m->kind->id,
                                .numbered = 1,
                                .context = m,
                                .output = on_output};
    test("a session asks for a picture with gaps, and shows what is not in them");
    fake_bus_reset();
    fake_plug(0, &device);
    CHECK(session_open(&s, &f) == 0, "%s", f.text);
    const picture *size = session_picture(&s);
    CHECK(size->width == 296 && size->height == 188, "%ux%u", size->width, size->height);
    CHECK(session_keys(&s)[5].x == 4 + 2 * (80 + 28), "%u", session_keys(&s)[5].x);
    CHECK(picture_make(&p, 296, 188, &f) == 0, "%s", f.text);
    number_pixels(&p);
    CHECK(session_show(&s, &p, &f) == 0, "%s", f.text);
    const picture panel = {m->rgb, m->width, m->height};
    CHECK(compare(driver_streamdeck_mini.grid, &p, &panel) == 0, "another picture");
    session_close(&s);
    test("a panel without gaps is told as such");
    fake_bus_reset();
    s = (session){.wish = {.drivers = drivers, .device = "1-1:1.0", .by = &driver_nexus},
                  .gaps = 1,
                  .brightness = -1};
    fake_plug(0, &device);
    CHECK(session_open(&s, &f) == -1, "opened");
    CHECK(strstr(f.text, "its panel has no gaps; leave out --gaps") != NULL, "%s", f.text);
    session_close(&s);
    CHECK(fake_bus.open == 0 && fake_bus.wrong == 0, "%d open", fake_bus.open);
    picture_free(&p);
    model_free(m);
}

int main(void) {
    shown();
    span_sizes();
    cuts();
    symbols();
    return test_done();
}
