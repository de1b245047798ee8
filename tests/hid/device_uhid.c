/* device_uhid - a display made of /dev/uhid: no USB below, and it loses reports
 *
 * Its queue holds 32 output reports; what comes while it is full is dropped,
 * and the writer gets no error.
 *
 * Source: Linux, Documentation/hid/uhid.rst. SPDX-License-Identifier: MIT */
#include <errno.h>
#include <fcntl.h>
#include <linux/input.h>
#include <linux/uhid.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "tests/hid/device.h"

enum { TICK_MS = 5 };

static int put_event(int fd, const struct uhid_event *e) {
    return write(fd, e, sizeof *e) == (ssize_t)sizeof *e ? 0 : -1;
}

static int create(int fd, const device *d) {
    struct uhid_event e = {.type = UHID_CREATE2};
    struct uhid_create2_req *c = &e.u.create2;
    snprintf((char *)c->name, sizeof c->name, "Planelet emulated %s", d->model->kind->name);
    snprintf((char *)c->uniq, sizeof c->uniq, "%s", d->serial);
    c->bus = BUS_USB;
    c->vendor = d->vendor;
    c->product = d->id;
    c->rd_size = (uint16_t)model_descriptor(d->model, c->rd_data);
    return put_event(fd, &e);
}

static void handle_event(int fd, device *d, const struct uhid_event *e) {
    if (e->type == UHID_OUTPUT) {
        const size_t skip = d->model->kind->output_number == 0 ? 1 : 0;
        device_output(d, e->u.output.data + skip, e->u.output.size - skip);
    } else if (e->type == UHID_SET_REPORT) {
        struct uhid_event answer = {.type = UHID_SET_REPORT_REPLY};
        const size_t skip = d->model->kind->feature_number == 0 ? 1 : 0;
        answer.u.set_report_reply.id = e->u.set_report.id;
        device_feature(d, e->u.set_report.data + skip, e->u.set_report.size - skip);
        put_event(fd, &answer);
    } else if (e->type == UHID_GET_REPORT) {
        struct uhid_event answer = {.type = UHID_GET_REPORT_REPLY};
        answer.u.get_report_reply.id = e->u.get_report.id;
        answer.u.get_report_reply.err = EIO;
        put_event(fd, &answer);
    }
}

static void send_inputs(int fd, device *d) {
    struct uhid_event e = {.type = UHID_INPUT2};
    size_t bytes;
    while ((bytes = device_input(d, e.u.input2.data, 64)) > 0) {
        e.u.input2.size = (uint16_t)bytes;
        put_event(fd, &e);
    }
}

int device_uhid(device *d) {
    const int fd = open("/dev/uhid", O_RDWR);
    if (fd < 0 || create(fd, d) != 0) {
        perror("device: /dev/uhid");
        return -1;
    }
    while (device_goes_on(d)) {
        struct pollfd p = {fd, POLLIN, 0};
        struct uhid_event e;
        if (poll(&p, 1, TICK_MS) > 0 && read(fd, &e, sizeof e) > 0) {
            handle_event(fd, d, &e);
        }
        send_inputs(fd, d);
    }
    close(fd);
    return 0;
}
