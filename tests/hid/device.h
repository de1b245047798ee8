/* device - a model at the end of a cable of this machine's kernel
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_DEVICE_H
#define HID_DEVICE_H

#include "tests/hid/model.h"

typedef struct device {
    model *model;
    unsigned vendor, id;
    const char *serial;
    unsigned port;      /* usbip: of the virtual hub */
    int high_speed;     /* usbip; else full speed */
    int paced;          /* usbip at full speed: a packet of 64 bytes per millisecond */
    int no_out;         /* usbip, gadget: no OUT endpoint, output reports come by SET_REPORT */
    const char *path;   /* gadget: /dev/hidgN */
    uint64_t die_after; /* output reports until it vanishes without a word; 0: never */
    unsigned slow_us;   /* time it needs for a report */
    uint64_t reports;
} device;

/* Asked before every wait: 0 ends the display. The model may be another one
 * after the call. */
int device_goes_on(device *d);

/* A report for the model, with its number if the model has numbers. Ends the
 * process when die_after says so. */
void device_output(device *d, const uint8_t *report, size_t bytes);
void device_feature(device *d, const uint8_t *report, size_t bytes);

/* The next input report, 0 when there is none now. */
size_t device_input(device *d, uint8_t *report, size_t room);

/* Each runs until device_goes_on says no; 0, or -1 after a line on standard error. */
int device_uhid(device *d);
int device_usbip(device *d);
int device_gadget(device *d);

#endif
