/* port - see port.h
 *
 * Keeps: between port_close and the next port_list hidapi is shut down: a list
 * always shows what is plugged in at the time of the call.
 *
 * Written for hidapi 0.11 and later; what it does beyond its manual (empty
 * reads, input in pieces of a packet, which backends know what) was found by
 * running 0.13.1 on Linux, and tests/reference/fake_hidapi.c does it again.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/device/port.h"

#include <errno.h>
#include <hidapi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <wchar.h>

#include "host_tools/base/clock.h"
#include "host_tools/hid/device/lock.h"

enum { KEPT_BYTES = 64 };

/* A feature report that takes so long to fail was carried out but not acknowledged: the system's
 * own limits are one second (libusb) and five. A refusal comes at once, on a busy machine a little
 * later (SESSIONS.md, 3). */
static const double LATE = 0.18;

struct port {
    hid_device *device;
    int lock;
    port_statistics statistics;
    uint8_t kept[KEPT_BYTES]; /* an input report that came when nobody asked for one */
    int kept_bytes;
};

/* A code point to UTF-8, 1 to 4 bytes; what is no code point becomes '?'. */
static size_t put_utf8(char *to, unsigned long c) {
    if (c < 0x20 || c == 0x7F || c > 0x10FFFF || (c >= 0xD800 && c < 0xE000)) {
        c = '?';
    }
    if (c < 0x80) {
        to[0] = (char)c;
        return 1;
    }
    const size_t count = c < 0x800 ? 2 : c < 0x10000 ? 3 : 4;
    for (size_t i = count - 1; i > 0; i--, c >>= 6) {
        to[i] = (char)(0x80 | (c & 0x3F));
    }
    to[0] = (char)((0xF00u >> count & 0xF0) | c);
    return count;
}

static void copy_wide(char *to, size_t room, const wchar_t *from) {
    size_t used = 0;
    while (from != NULL && *from != 0 && used + 5 <= room) {
        used += put_utf8(to + used, (unsigned long)*from++);
    }
    to[used] = '\0';
}

static void copy_info(port_info *to, const struct hid_device_info *from) {
    snprintf(to->path, sizeof to->path, "%s", from->path == NULL ? "" : from->path);
    copy_wide(to->serial, sizeof to->serial, from->serial_number);
    copy_wide(to->maker, sizeof to->maker, from->manufacturer_string);
    copy_wide(to->product, sizeof to->product, from->product_string);
    to->vendor = from->vendor_id;
    to->id = from->product_id;
    to->usage_page = from->usage_page;
    to->interface = from->interface_number;
    place_of(to->path, to->place);
}

/* Adds an entry, unless it is a further collection of one that is there. */
static unsigned add_entry(port_info *list, unsigned count, const struct hid_device_info *from) {
    copy_info(&list[count], from);
    for (unsigned i = 0; i < count; i++) {
        if (strcmp(list[i].path, list[count].path) == 0) {
            return count;
        }
    }
    return count + 1;
}

static void count_equals(port_info *list, unsigned count) {
    for (unsigned i = 0; i < count; i++) {
        for (unsigned k = 0; k < count; k++) {
            list[i].equals += k != i && port_is_equal(&list[i], &list[k]);
        }
    }
}

int port_is_equal(const port_info *a, const port_info *b) {
    return a->vendor == b->vendor && a->id == b->id && a->interface == b->interface &&
           strcmp(a->serial, b->serial) == 0;
}

unsigned port_list(port_info **list) {
    *list = NULL;
    hid_exit();
    if (hid_init() != 0) {
        return 0;
    }
    struct hid_device_info *const all = hid_enumerate(0, 0);
    unsigned room = 0, count = 0;
    for (const struct hid_device_info *i = all; i != NULL; i = i->next) {
        room++;
    }
    *list = room > 0 ? calloc(room, sizeof **list) : NULL;
    for (const struct hid_device_info *i = all; i != NULL && *list != NULL; i = i->next) {
        count = add_entry(*list, count, i);
    }
    hid_free_enumeration(all);
    count_equals(*list, count);
    return count;
}

/* hidapi gives no reason for a failed open (its error text may even say "Success"), so
 * look for it: of a node by its mode; any other path is libusb's, and no file of the
 * folder where we are. */
static int say_refusal(const port_info *info, fail *f) {
    const int is_node = strchr(info->path, '/') != NULL;
    const int barred = is_node ? access(info->path, R_OK | W_OK) != 0 : geteuid() != 0;
    if (is_node && access(info->path, F_OK) != 0) {
        return fail_set(f, info->path, "%04x:%04x went away; plug it in again", info->vendor,
                        info->id);
    }
    if (barred) {
        return fail_set(f, info->path,
                        "no permission to use %04x:%04x; install the udev rule: planelet-hid rules "
                        "| sudo tee /etc/udev/rules.d/70-planelet.rules && sudo udevadm control "
                        "--reload, then plug the display in again",
                        info->vendor, info->id);
    }
    return fail_set(f, info->path,
                    "cannot open %04x:%04x; close other programs that use it, or plug it in again",
                    info->vendor, info->id);
}

static int say_held(const port_info *info, long holder, fail *f) {
    if (holder == 0) {
        return fail_set(f, info->path,
                        "another program shows pictures on %04x:%04x; stop that one, or choose "
                        "another display with --device",
                        info->vendor, info->id);
    }
    return fail_set(f, info->path,
                    "process %ld shows pictures on %04x:%04x; stop that one, or choose another "
                    "display with --device",
                    holder, info->vendor, info->id);
}

static int open_locked(port *p, const port_info *info, fail *f) {
    long holder;
    p->lock = lock_take(info->path, &holder);
    if (p->lock == LOCK_HELD) {
        return say_held(info, holder, f);
    }
    p->device = hid_open_path(info->path);
    if (p->device == NULL) {
        lock_release(p->lock);
        return say_refusal(info, f);
    }
    return 0;
}

port *port_open(const port_info *info, fail *f) {
    port *p = calloc(1, sizeof *p);
    if (p == NULL) {
        fail_set(f, info->path, "out of memory; close other programs");
        return NULL;
    }
    if (open_locked(p, info, f) != 0) {
        free(p);
        return NULL;
    }
    return p;
}

void port_close(port *p) {
    if (p != NULL) {
        hid_close(p->device);
        lock_release(p->lock);
        free(p);
        hid_exit();
    }
}

static int count_report(port *p, int sent, size_t bytes) {
    if (sent < 0) {
        return PORT_GONE;
    }
    if ((size_t)sent < bytes) {
        p->statistics.cut++;
        return PORT_CUT;
    }
    p->statistics.reports++;
    p->statistics.bytes += bytes - (bytes > 0 ? 1 : 0);
    return PORT_OK;
}

int port_output(port *p, const uint8_t *report, size_t bytes) {
    return count_report(p, hid_write(p->device, report, bytes), bytes);
}

/* Reading fails only when the device is gone. */
static int is_there(port *p) {
    uint8_t report[KEPT_BYTES];
    const int got = hid_read_timeout(p->device, report, sizeof report, 0);
    if (got > 0) {
        memcpy(p->kept, report, (size_t)got);
        p->kept_bytes = got;
    }
    return got >= 0;
}

int port_feature(port *p, const uint8_t *report, size_t bytes) {
    const double began = clock_seconds();
    int sent = hid_send_feature_report(p->device, report, bytes);
    if (sent < 0 && clock_seconds() - began >= LATE && is_there(p)) {
        sent = (int)bytes;
    }
    return count_report(p, sent, bytes);
}

static int take_kept(port *p, uint8_t *report, size_t room) {
    const size_t bytes = (size_t)p->kept_bytes < room ? (size_t)p->kept_bytes : room;
    memcpy(report, p->kept, bytes);
    p->kept_bytes = 0;
    return (int)bytes;
}

/* A device that ends a report with an empty packet makes hidapi on libusb
 * return 0 at once: whether the time is over only the clock shows. */
int port_input(port *p, uint8_t *report, size_t room, unsigned wait_ms) {
    const double end = clock_seconds() + 1e-3 * wait_ms;
    if (p->kept_bytes > 0) {
        return take_kept(p, report, room);
    }
    for (;;) {
        const double left = end - clock_seconds();
        const int wait = left > 0.0 ? (int)(1e3 * left) + 1 : 0;
        const int got = hid_read_timeout(p->device, report, room, wait);
        if (got != 0) {
            return got < 0 ? PORT_GONE : got;
        }
        if (wait == 0) {
            return 0;
        }
    }
}

void port_statistics_get(const port *p, port_statistics *statistics) {
    *statistics = p->statistics;
}
