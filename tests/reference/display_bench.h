/* display_bench - a driver and a model of its display on a fake of hidapi, and what goes between
 * them
 *
 * SPDX-License-Identifier: MIT */
#ifndef DISPLAY_BENCH_H
#define DISPLAY_BENCH_H
#include "host_tools/hid/device/display.h"
#include "host_tools/hid/device/find.h"
#include "host_tools/hid/drivers/drivers.h"
#include "tests/hid/model.h"
#include "tests/reference/fake_hidapi.h"
#include "tests/test.h"

enum { RECORD = 700, REPORT_BYTES = 8191 };

/* The reports that came, as they came, zeros behind them. */
static struct {
    uint8_t bytes[RECORD][REPORT_BYTES];
    size_t size[RECORD];
    unsigned count;
} record;

static inline void keep(const uint8_t *report, size_t bytes) {
    if (record.count < RECORD && bytes <= REPORT_BYTES) {
        memset(record.bytes[record.count], 0, REPORT_BYTES);
        record.size[record.count] = bytes;
        memcpy(record.bytes[record.count++], report, bytes);
    }
}

static inline void on_output(void *context, const uint8_t *report, size_t bytes) {
    model *m = context;
    keep(report, bytes);
    m->kind->output(m, report, bytes);
}

static inline void on_feature(void *context, const uint8_t *report, size_t bytes) {
    model *m = context;
    keep(report, bytes);
    m->kind->feature(m, report, bytes);
}

/* Input reports that wait. */
static struct {
    uint8_t bytes[80][64];
    size_t size[80];
    unsigned count, at;
} queue;

static inline size_t on_input(void *context, uint8_t *report, size_t room) {
    (void)context;
    if (queue.at == queue.count || room < queue.size[queue.at]) {
        return 0;
    }
    memcpy(report, queue.bytes[queue.at], queue.size[queue.at]);
    return queue.size[queue.at++];
}

static inline void add(const uint8_t *report, size_t bytes) {
    memcpy(queue.bytes[queue.count], report, bytes);
    queue.size[queue.count++] = bytes;
}

typedef struct bench {
    model *model;
    fake_device device;
    display display;
    picture shown;
} bench;

static inline void open_bench(bench *b, const model_kind *kind) {
    fail f = {""};
    port_info info;
    const find_wish wish = {.drivers = drivers};
    memset(b, 0, sizeof *b);
    record.count = queue.count = queue.at = 0;
    fake_bus_reset();
    b->model = model_make(kind, (model_shape){0});
    b->device = (fake_device){.path = "1-1:1.0",
                              .vendor = kind->vendor,
                              .product = kind->id,
                              .interface = kind->interface,
                              .numbered = kind->output_number != 0,
                              .context = b->model,
                              .output = on_output,
                              .input = on_input,
                              .feature = on_feature};
    fake_plug(0, &b->device);
    const driver *by = find_display(&wish, &info, &f);
    CHECK(by != NULL && strcmp(by->name, kind->name) == 0, "%s", f.text);
    CHECK(by != NULL && display_open(&b->display, by, &info, NULL, &f) == DISPLAY_OK, "%s", f.text);
    CHECK(b->display.width == kind->width && b->display.height == kind->height, "%ux%u",
          b->display.width, b->display.height);
    picture_make(&b->shown, b->display.width, b->display.height, &f);
}

static inline void close_bench(bench *b) {
    CHECK(b->model->wrong == 0, "%s", b->model->why);
    CHECK(fake_bus.wrong == 0, "hidapi was used against its rules");
    display_close(&b->display);
    CHECK(fake_bus.open == 0, "the device stays open");
    picture_free(&b->shown);
    model_free(b->model);
}

#endif
