/* device_gadget - a display behind the kernel's own HID gadget, /dev/hidgN
 *
 * guest_gadget.sh makes the gadget. With no_out=1 reports come by SET_REPORT, and
 * the kernel does not say whether it was a feature report: its length does. It ends 64-byte input
 * reports with an empty packet, which hidapi on libusb hands up as an empty report.
 *
 * SPDX-License-Identifier: MIT */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <unistd.h>

#include "tests/hid/device.h"

enum { TICK_MS = 5 };

/* Waits for room, so that no report is lost here. */
static void send_inputs(int fd, device *d) {
    uint8_t report[64];
    size_t bytes;
    while ((bytes = device_input(d, report, sizeof report)) > 0) {
        struct pollfd p = {fd, POLLOUT, 0};
        if (poll(&p, 1, 100) <= 0 || write(fd, report, bytes) < 0) {
            return;
        }
    }
}

static void handle_report(device *d, const uint8_t *report, size_t bytes) {
    const model_kind *k = d->model->kind;
    const size_t feature = k->feature_bytes + (k->feature_number != 0);
    if (k->feature != NULL && d->no_out && bytes == feature) {
        device_feature(d, report, bytes);
    } else {
        device_output(d, report, bytes);
    }
}

int device_gadget(device *d) {
    const int fd = open(d->path, O_RDWR);
    if (fd < 0) {
        perror(d->path);
        return -1;
    }
    while (device_goes_on(d)) {
        struct pollfd p = {fd, POLLIN, 0};
        uint8_t report[1 + 1024];
        if (poll(&p, 1, TICK_MS) > 0) {
            const ssize_t bytes = read(fd, report, sizeof report);
            if (bytes > 0) {
                handle_report(d, report, (size_t)bytes);
            } else if (bytes < 0 && errno != EINTR && errno != EAGAIN) {
                poll(NULL, 0, TICK_MS); /* unbound, or the host resets it */
            }
        }
        send_inputs(fd, d);
    }
    close(fd);
    return 0;
}
