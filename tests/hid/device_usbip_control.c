/* device_usbip_control - endpoint 0: descriptors, and reports by SET_REPORT
 *
 * Sources: USB 2.0, chapter 9; HID 1.11, chapters 6 and 7.
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <string.h>

#include "tests/hid/usbip.h"

enum {
    GET_DESCRIPTOR = 6,
    GET_STATUS = 0,
    SET_REPORT = 9,
    DEVICE = 1,
    CONFIGURATION = 2,
    STRING = 3,
    REPORT = 0x22,
    OUTPUT_REPORT = 2
};

static int device_descriptor(const device *d, uint8_t *to) {
    const uint8_t bytes[] = {18,
                             DEVICE,
                             0,
                             2,
                             0,
                             0,
                             0,
                             64,
                             (uint8_t)d->vendor,
                             (uint8_t)(d->vendor >> 8),
                             (uint8_t)d->id,
                             (uint8_t)(d->id >> 8),
                             0,
                             1,
                             1,
                             2,
                             3,
                             1};
    memcpy(to, bytes, sizeof bytes);
    return sizeof bytes;
}

static uint8_t *endpoint(uint8_t *to, uint8_t address, unsigned packet) {
    const uint8_t bytes[] = {7, 5, address, 3, (uint8_t)packet, (uint8_t)(packet >> 8), 1};
    memcpy(to, bytes, sizeof bytes);
    return to + sizeof bytes;
}

static int configuration(const device *d, uint8_t *to) {
    uint8_t report[96];
    const size_t bytes = model_descriptor(d->model, report);
    const unsigned total = d->no_out ? 34 : 41, packet = d->high_speed ? 1024 : 64;
    const uint8_t head[] = {9,
                            CONFIGURATION,
                            (uint8_t)total,
                            0,
                            1,
                            1,
                            0,
                            0xA0,
                            50,
                            9,
                            4,
                            (uint8_t)d->model->kind->interface,
                            0,
                            d->no_out ? 1 : 2,
                            3,
                            0,
                            0,
                            0,
                            9,
                            0x21,
                            0x11,
                            1,
                            0,
                            1,
                            REPORT,
                            (uint8_t)bytes,
                            (uint8_t)(bytes >> 8)};
    memcpy(to, head, sizeof head);
    uint8_t *end = endpoint(to + sizeof head, 0x81, 64);
    if (!d->no_out) {
        endpoint(end, 0x01, packet);
    }
    return (int)total;
}

static int string(const device *d, unsigned index, uint8_t *to) {
    char text[64] = "";
    if (index == 0) {
        memcpy(to, "\4\3\11\4", 4);
        return 4;
    }
    if (index == 1) {
        snprintf(text, sizeof text, "Planelet");
    } else if (index == 2) {
        snprintf(text, sizeof text, "emulated %s", d->model->kind->name);
    } else {
        snprintf(text, sizeof text, "%s", d->serial);
    }
    const size_t length = strlen(text);
    to[0] = (uint8_t)(2 + 2 * length);
    to[1] = STRING;
    for (size_t i = 0; i < length; i++) {
        to[2 + 2 * i] = (uint8_t)text[i];
        to[3 + 2 * i] = 0;
    }
    return to[0];
}

static int descriptor(const device *d, unsigned kind, unsigned index, uint8_t *to) {
    switch (kind) {
    case DEVICE:
        return device_descriptor(d, to);
    case CONFIGURATION:
        return configuration(d, to);
    case STRING:
        return index > 3 ? -1 : string(d, index, to);
    case REPORT:
        return (int)model_descriptor(d->model, to);
    default:
        return -1;
    }
}

int usbip_control(usbip *u, const uint8_t setup[8], const uint8_t *data, size_t bytes,
                  uint8_t *answer) {
    if (setup[0] & 0x80) {
        if (setup[1] == GET_DESCRIPTOR) {
            return descriptor(u->device, setup[3], setup[2], answer);
        }
        memset(answer, 0, 2);
        return setup[1] == GET_STATUS ? 2 : -1;
    }
    if (setup[0] == 0x21 && setup[1] == SET_REPORT) {
        if (setup[3] == OUTPUT_REPORT) {
            device_output(u->device, data, bytes);
        } else {
            device_feature(u->device, data, bytes);
        }
    }
    return 0;
}
