/* fake_hidapi - see fake_hidapi.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/fake_hidapi.h"

#include <stdlib.h>
#include <string.h>

#include "host_tools/base/clock.h"
#include "host_tools/hid/device/place.h"
#include "tests/reference/fake_hidapi/hidapi.h"

struct fake_bus fake_bus;

struct hid_device_ {
    unsigned socket;
    unsigned plug; /* which plugging-in it belongs to */
    uint8_t piece[1024];
    size_t piece_at, piece_end;
};

static struct {
    unsigned plugs[FAKE_DEVICES]; /* counts pluggings in and out of a socket */
    unsigned seen[FAKE_DEVICES];  /* that count at hid_init */
    const fake_device *away;
    uint64_t back_ms;
} inside;

static uint64_t now_ms(void) {
    return (uint64_t)(1e3 * clock_seconds());
}

void fake_bus_reset(void) {
    memset(&fake_bus, 0, sizeof fake_bus);
    memset(&inside, 0, sizeof inside);
}

void fake_plug(unsigned socket, const fake_device *device) {
    fake_bus.device[socket] = device;
    inside.plugs[socket]++;
    if (device->plugged != NULL) {
        device->plugged(device->context, 1);
    }
}

void fake_unplug(unsigned socket) {
    const fake_device *device = fake_bus.device[socket];
    fake_bus.device[socket] = NULL;
    inside.plugs[socket]++;
    if (device != NULL && device->plugged != NULL) {
        device->plugged(device->context, 0);
    }
}

/* The clock brings back what was unplugged. */
static void pass_time(void) {
    if (fake_bus.passes != NULL) {
        fake_bus.passes(fake_bus.context);
    }
    if (inside.away != NULL && fake_bus.replug_ms > 0 && now_ms() >= inside.back_ms) {
        const fake_device *device = inside.away;
        inside.away = NULL;
        fake_plug(0, device);
    }
}

static void count_towards_unplug(void) {
    if (fake_bus.unplug_after > 0 && --fake_bus.unplug_after == 0) {
        inside.away = fake_bus.device[0];
        inside.back_ms = now_ms() + fake_bus.replug_ms;
        fake_unplug(0);
    }
}

int hid_init(void) {
    pass_time();
    if (!fake_bus.alive) {
        memcpy(inside.seen, inside.plugs, sizeof inside.seen);
    }
    fake_bus.alive = 1;
    return 0;
}

int hid_exit(void) {
    fake_bus.wrong += fake_bus.open > 0;
    fake_bus.alive = 0;
    return 0;
}

static wchar_t *copy_text(const wchar_t *from) {
    if (from == NULL) {
        return NULL;
    }
    wchar_t *to = malloc((wcslen(from) + 1) * sizeof *to);
    return to == NULL ? NULL : wcscpy(to, from);
}

static struct hid_device_info *describe(const fake_device *d) {
    struct hid_device_info *info = calloc(1, sizeof *info);
    if (info != NULL) {
        info->path = malloc(strlen(d->path) + 1);
        if (info->path != NULL) {
            strcpy(info->path, d->path);
        }
        info->vendor_id = d->vendor;
        info->product_id = d->product;
        info->serial_number = copy_text(d->serial);
        info->manufacturer_string = copy_text(d->maker);
        info->product_string = copy_text(d->name);
        info->usage_page = fake_bus.libusb ? 0 : d->usage_page;
        info->interface_number = d->interface;
    }
    return info;
}

static int is_visible(unsigned socket) {
    return fake_bus.device[socket] != NULL &&
           (!fake_bus.libusb || inside.seen[socket] == inside.plugs[socket]);
}

struct hid_device_info *hid_enumerate(unsigned short vendor_id, unsigned short product_id) {
    struct hid_device_info *first = NULL, **last = &first;
    hid_init();
    fake_bus.enumerations++;
    for (unsigned i = 0; i < FAKE_DEVICES; i++) {
        const fake_device *d = fake_bus.device[i];
        if (is_visible(i) && (vendor_id == 0 || vendor_id == d->vendor) &&
            (product_id == 0 || product_id == d->product)) {
            for (unsigned k = 0; k < d->collections + (d->collections == 0); k++) {
                *last = describe(d);
                last = &(*last)->next;
            }
        }
    }
    return first;
}

void hid_free_enumeration(struct hid_device_info *list) {
    while (list != NULL) {
        struct hid_device_info *next = list->next;
        free(list->path);
        free(list->serial_number);
        free(list->manufacturer_string);
        free(list->product_string);
        free(list);
        list = next;
    }
}

void place_of(const char *path, char place[PLACE_BYTES]) {
    place_in("/none", path, place);
    for (unsigned i = 0; i < FAKE_DEVICES; i++) {
        const fake_device *d = fake_bus.device[i];
        if (d != NULL && d->place != NULL && strcmp(d->path, path) == 0) {
            memcpy(place, d->place, strlen(d->place) + 1);
        }
    }
}

hid_device *hid_open_path(const char *path) {
    hid_init();
    for (unsigned i = 0; i < FAKE_DEVICES && !fake_bus.denied; i++) {
        if (is_visible(i) && strcmp(fake_bus.device[i]->path, path) == 0) {
            hid_device *h = calloc(1, sizeof *h);
            if (h != NULL) {
                h->socket = i;
                h->plug = inside.plugs[i];
                fake_bus.open++;
                fake_bus.opens++;
            }
            return h;
        }
    }
    return NULL;
}

void hid_close(hid_device *h) {
    fake_bus.open -= h != NULL;
    free(h);
}

/* The device behind a handle, or NULL when it went away since. */
static const fake_device *behind(const hid_device *h) {
    fake_bus.wrong += !fake_bus.alive;
    pass_time();
    return h->plug == inside.plugs[h->socket] ? fake_bus.device[h->socket] : NULL;
}

/* About every n-th, the same in every run. Not exactly every n-th: a protocol that
 * sends n reports per round would always lose the same one. */
static int one_in(unsigned n, uint64_t count) {
    const uint64_t mixed = (count + 1) * UINT64_C(0x9E3779B97F4A7C15);
    return n > 0 && (mixed >> 40) % n == 0;
}

static void before_report(void) {
    if (fake_bus.before != NULL) {
        fake_bus.before(fake_bus.context);
    }
}

/* `count`: of refusals of this kind of report that are left. */
static int is_refused(unsigned *count) {
    const unsigned stall = fake_bus.stall_ms;
    fake_bus.stall_ms = 0;
    clock_sleep(1e-3 * stall);
    unsigned *const refusals = fake_bus.refuse_reports > 0 ? &fake_bus.refuse_reports : count;
    const int is_one = *refusals > 0;
    *refusals -= (unsigned)is_one;
    if (is_one || stall > 0) {
        fake_bus.last_fault = clock_seconds();
    }
    return is_one || stall > 0;
}

int hid_write(hid_device *h, const unsigned char *data, size_t length) {
    before_report();
    const fake_device *d = behind(h);
    fake_bus.wrong += length == 0;
    if (d == NULL || length == 0) {
        return -1;
    }
    const uint64_t number = fake_bus.outputs++;
    clock_sleep(1e-6 * fake_bus.slow_us);
    if (is_refused(&fake_bus.refuse_outputs) || d != behind(h)) {
        return -1;
    }
    fake_bus.wrong += d->numbered ? data[0] == 0 : data[0] != 0;
    if (one_in(fake_bus.short_writes, number)) {
        return (int)length / 2;
    }
    if (!one_in(fake_bus.drop_outputs, number)) {
        const size_t skip = d->numbered ? 0 : 1;
        d->output(d->context, data + skip, length - skip);
    }
    count_towards_unplug();
    return (int)length;
}

int hid_send_feature_report(hid_device *h, const unsigned char *data, size_t length) {
    before_report();
    const fake_device *d = behind(h);
    if (d == NULL || d->feature == NULL) {
        return -1;
    }
    fake_bus.features++;
    clock_sleep(1e-6 * fake_bus.slow_us);
    if (is_refused(&fake_bus.refuse_features) || d != behind(h)) {
        return -1;
    }
    const size_t skip = data[0] == 0 ? 1 : 0;
    d->feature(d->context, data + skip, length - skip);
    count_towards_unplug();
    if (fake_bus.late_ms > 0) {
        clock_sleep(1e-3 * fake_bus.late_ms);
        fake_bus.last_fault = clock_seconds();
        return -1;
    }
    return (int)length;
}

static int next_piece(hid_device *h, unsigned char *data, size_t length) {
    size_t bytes = h->piece_end - h->piece_at;
    if (fake_bus.piece_bytes > 0 && bytes > fake_bus.piece_bytes) {
        bytes = fake_bus.piece_bytes;
    }
    bytes = bytes > length ? length : bytes;
    memcpy(data, h->piece + h->piece_at, bytes);
    h->piece_at += bytes;
    return (int)bytes;
}

int hid_read_timeout(hid_device *h, unsigned char *data, size_t length, int milliseconds) {
    const uint64_t end = now_ms() + (uint64_t)(milliseconds > 0 ? milliseconds : 0);
    if (one_in(fake_bus.empty_reads, fake_bus.reads++)) {
        return behind(h) == NULL ? -1 : 0;
    }
    for (;;) {
        const fake_device *d = behind(h);
        if (d == NULL) {
            return -1;
        }
        if (h->piece_at == h->piece_end && d->input != NULL) {
            h->piece_at = 0;
            h->piece_end = d->input(d->context, h->piece, sizeof h->piece);
        }
        if (h->piece_at < h->piece_end) {
            return next_piece(h, data, length);
        }
        if (now_ms() >= end) {
            return 0;
        }
        clock_sleep(1e-6 * 200);
    }
}

/* hid_error(NULL) after a refused open was "Success". */
const wchar_t *hid_error(hid_device *h) {
    (void)h;
    return fake_bus.libusb ? L"hid_error is not implemented yet" : L"Success";
}
