/* port - host_tools/hid/device/port.h by WebHID
 *
 * The page sends reports one after the other, later. So a report that was handed over may still
 * fail to leave; then the page closes the display.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/web/port.h"

#include <string.h>

#include "host_tools/hid/device/port.h"

enum { WAITING_MOST = 32 };

/* 0, or negative: the device is gone. */
__attribute__((import_module("page"), import_name("report"))) extern int
page_report(int is_feature, const void *report, uint32_t bytes);

struct port {
    uint8_t waiting[WAITING_MOST][PORT_INPUT_BYTES];
    uint16_t bytes[WAITING_MOST];
    unsigned first, count;
    report_sizes sizes;
};

static port the_port; /* the page has one display at a time */

void web_port_begin(report_sizes sizes) {
    the_port.first = the_port.count = 0;
    the_port.sizes = sizes;
}

static unsigned next(void) {
    return (the_port.first + the_port.count) % WAITING_MOST;
}

uint8_t *web_port_room(void) {
    return the_port.waiting[next()];
}

/* Of more than there is room for the newest are lost: a key's state comes again with the next. */
void web_port_came(unsigned bytes) {
    if (bytes > 0 && bytes <= PORT_INPUT_BYTES && the_port.count + 1 < WAITING_MOST) {
        the_port.bytes[next()] = (uint16_t)bytes;
        the_port.count++;
    }
}

report_sizes report_sizes_at(const char *path) {
    (void)path;
    return the_port.sizes;
}

port *port_open(const port_info *info, fail *f) {
    (void)info;
    (void)f;
    return &the_port;
}

void port_close(port *p) {
    (void)p;
}

static int status_of(int sent) {
    return sent < 0 ? PORT_GONE : PORT_OK;
}

int port_output(port *p, const uint8_t *report, size_t bytes) {
    (void)p;
    return status_of(page_report(0, report, (uint32_t)bytes));
}

int port_feature(port *p, const uint8_t *report, size_t bytes) {
    (void)p;
    return status_of(page_report(1, report, (uint32_t)bytes));
}

int port_input(port *p, uint8_t *report, size_t room, unsigned wait_ms) {
    (void)wait_ms;
    if (p->count == 0) {
        return 0;
    }
    const size_t bytes = p->bytes[p->first] < room ? p->bytes[p->first] : room;
    memcpy(report, p->waiting[p->first], bytes);
    p->first = (p->first + 1) % WAITING_MOST;
    p->count--;
    return (int)bytes;
}
