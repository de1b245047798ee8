/* usbip - what device_usbip.c and its descriptors share
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_USBIP_H
#define HID_USBIP_H

#include "tests/hid/device.h"

enum { USBIP_QUEUE = 64 };

typedef struct usbip_out {
    uint32_t number, bytes;
    int64_t due_us;
} usbip_out;

typedef struct usbip {
    device *device;
    int socket, closed;
    uint32_t in[USBIP_QUEUE]; /* IN transfers that wait for a report */
    usbip_out out[USBIP_QUEUE];
    unsigned ins, outs;
    int64_t bus_free_us;
    uint8_t buffer[4096];
} usbip;

/* A control request; `data` of OUT ones. Returns the bytes of the answer, or
 * -1: stall. */
int usbip_control(usbip *u, const uint8_t setup[8], const uint8_t *data, size_t bytes,
                  uint8_t *answer);

/* Gives reports that are due to transfers that wait. */
void usbip_in_done(usbip *u);

#endif
