/* display - see display.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/device/display.h"

#include "host_tools/base/clock.h"

static int drives(const driver_id *id, const port_info *info) {
    return id->vendor == info->vendor && id->id == info->id &&
           (id->interface == info->interface || info->interface < 0 ||
            id->interface == DRIVER_ANY_INTERFACE);
}

const driver *driver_for(const driver *const *drivers, const port_info *info) {
    for (unsigned i = 0; drivers[i] != NULL; i++) {
        for (const driver_id *id = drivers[i]->ids; id->vendor != 0; id++) {
            if (drives(id, info)) {
                return drivers[i];
            }
        }
    }
    return NULL;
}

int display_is_stopped(display *d) {
    if (d->stop == NULL || !*d->stop) {
        return 0;
    }
    d->stopped = d->stopped > 0.0 ? d->stopped : clock_seconds();
    return clock_seconds() - d->stopped > 0.15;
}

int display_hear(display *d, void (*take)(display *d, const uint8_t *report, size_t bytes)) {
    enum { REPORTS_MOST = 32, REPORT_BYTES = 512 };
    for (unsigned i = 0; i < REPORTS_MOST; i++) {
        uint8_t report[REPORT_BYTES];
        const int bytes = port_input(d->port, report, sizeof report, 0);
        if (bytes <= 0) {
            return bytes == 0 ? DISPLAY_OK : DISPLAY_GONE;
        }
        take(d, report, (size_t)bytes);
    }
    return DISPLAY_OK;
}

static void ignore(display *d, const uint8_t *report, size_t bytes) {
    (void)d;
    (void)report;
    (void)bytes;
}

int display_tick(display *d) {
    return d->by->tick != NULL ? d->by->tick(d) : display_hear(d, ignore);
}

int display_status(int port_status) {
    return port_status == PORT_OK ? DISPLAY_OK : DISPLAY_GONE;
}

int display_open(display *d, const driver *by, const port_info *info,
                 const volatile sig_atomic_t *stop, fail *f) {
    *d = (display){.by = by, .reports = report_sizes_at(info->path), .stop = stop};
    d->port = port_open(info, f);
    if (d->port == NULL) {
        return DISPLAY_FAILED;
    }
    const int status = by->open(d, f);
    if (status != DISPLAY_OK) {
        port_close(d->port);
        d->port = NULL;
    }
    return status;
}

void display_close(display *d) {
    if (d->port != NULL) {
        if (d->by->close != NULL) {
            d->by->close(d);
        }
        port_close(d->port);
        d->port = NULL;
    }
}
