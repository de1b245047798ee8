/* report_size - see report_size.h
 *
 * hidapi returns a report descriptor only from version 0.14 on; Linux shows it in
 * /sys, for both backends of hidapi, until a program opens the device.
 *
 * Source: USB-IF, "Device Class Definition for HID", 1.11, section 6.2.2.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/device/report_size.h"

#include <glob.h>
#include <stdio.h>
#include <string.h>

enum {
    INPUT = 0x80, /* item prefixes without their two bits of length */
    OUTPUT = 0x90,
    REPORT_SIZE = 0x74,
    REPORT_NUMBER = 0x84,
    REPORT_COUNT = 0x94,
    LONG_ITEM = 0xFE,
    DESCRIPTOR_BYTES_MAX = 4096
};

static uint32_t item_value(const uint8_t *at, unsigned bytes) {
    uint32_t value = 0;
    for (unsigned i = 0; i < bytes; i++) {
        value |= (uint32_t)at[i] << 8 * i;
    }
    return value;
}

/* A sum stops at 64 KiB, more than any report has. */
static uint32_t add_bits(uint32_t sum, uint32_t size, uint32_t count) {
    const uint64_t bits = sum + (uint64_t)size * count;
    return bits > 8 * 65536 ? 8 * 65536 : (uint32_t)bits;
}

static unsigned most_bytes(const uint32_t bits[256]) {
    uint32_t most = 0;
    for (unsigned i = 0; i < 256; i++) {
        most = bits[i] > most ? bits[i] : most;
    }
    return (most + 7) / 8;
}

report_sizes report_sizes_of(const uint8_t *d, size_t bytes) {
    uint32_t out[256] = {0}, in[256] = {0}, size = 0, count = 0, number = 0;
    for (size_t at = 0; at < bytes && d[at] != LONG_ITEM;) {
        const unsigned length = (d[at] & 3) == 3 ? 4 : d[at] & 3;
        if (bytes - at <= length) {
            break;
        }
        const uint32_t value = item_value(d + at + 1, length);
        switch (d[at] & 0xFC) {
        case REPORT_SIZE:
            size = value;
            break;
        case REPORT_COUNT:
            count = value;
            break;
        case REPORT_NUMBER:
            number = value & 0xFF;
            break;
        case OUTPUT:
            out[number] = add_bits(out[number], size, count);
            break;
        case INPUT:
            in[number] = add_bits(in[number], size, count);
            break;
        default:
            break;
        }
        at += 1 + length;
    }
    return (report_sizes){most_bytes(out), most_bytes(in)};
}

static report_sizes sizes_in_file(const char *path) {
    uint8_t descriptor[DESCRIPTOR_BYTES_MAX];
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        return (report_sizes){0, 0};
    }
    const size_t bytes = fread(descriptor, 1, sizeof descriptor, file);
    fclose(file);
    return report_sizes_of(descriptor, bytes);
}

/* "/dev/hidraw3", or of libusb "1-2.1:1.0", which is also its name in /sys. */
report_sizes report_sizes_at(const char *path) {
    char pattern[400];
    glob_t found;
    report_sizes sizes = {0, 0};
    if (strpbrk(path, "*?[\\") != NULL) {
        return sizes;
    }
    if (strncmp(path, "/dev/hidraw", 11) == 0) {
        snprintf(pattern, sizeof pattern, "/sys/class/hidraw/%s/device/report_descriptor",
                 path + 5);
    } else {
        snprintf(pattern, sizeof pattern, "/sys/bus/usb/devices/%s/*:*:*.*/report_descriptor",
                 path);
    }
    if (glob(pattern, 0, NULL, &found) == 0) {
        sizes = sizes_in_file(found.gl_pathv[0]);
    }
    globfree(&found);
    return sizes;
}
