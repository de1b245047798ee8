/* find - see find.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/device/find.h"

#include <stdio.h>
#include <string.h>

static int is_named(const port_info *info, const char *device) {
    char ids[12];
    snprintf(ids, sizeof ids, "%04x:%04x", info->vendor, info->id);
    if (strlen(device) == 9 && device[4] == ':') {
        for (unsigned i = 0; i < 9; i++) {
            const char c = device[i];
            if ((c >= 'A' && c <= 'F' ? c - 'A' + 'a' : c) != ids[i]) {
                return 0;
            }
        }
        return 1;
    }
    return strcmp(device, info->path) == 0 ||
           (info->serial[0] != '\0' && strcmp(device, info->serial) == 0);
}

/* The driver to use for a device that fits the wish, else NULL. A device that no
 * driver is for fits only when the user names both it and a driver. */
static const driver *match(const find_wish *wish, const port_info *info) {
    const driver *by = driver_for(wish->drivers, info);
    if (wish->device != NULL && !is_named(info, wish->device)) {
        return NULL;
    }
    if (wish->by != NULL) {
        return wish->device != NULL || by == wish->by ? wish->by : NULL;
    }
    return by;
}

static int say_none(const find_wish *wish, unsigned count, const port_info *other, fail *f) {
    if (wish->device == NULL) {
        return fail_set(f, NULL,
                        "no display among %u HID devices; plug one in, or name one of "
                        "planelet-hid list --all with --device and --driver",
                        count);
    }
    if (other != NULL) {
        return fail_set(f, wish->device,
                        "is there (%s), but no driver is for it; choose one with --driver",
                        other->path);
    }
    return fail_set(f, wish->device,
                    "no such device among %u; see planelet-hid list --all for paths, vid:pid and "
                    "serial numbers",
                    count);
}

const driver *find_display(const find_wish *wish, port_info *info, fail *f) {
    port_info list[FIND_ROOM];
    const unsigned count = port_list(list, FIND_ROOM);
    const port_info *other = NULL;
    for (unsigned pass = 0; pass < 2; pass++) {
        for (unsigned i = 0; i < count; i++) {
            const driver *by = match(wish, &list[i]);
            /* First pass: of several interfaces the one that the driver is for. */
            if (by != NULL && (pass > 0 || driver_for(wish->drivers, &list[i]) == by)) {
                *info = list[i];
                return by;
            }
            if (wish->device != NULL && is_named(&list[i], wish->device)) {
                other = &list[i];
            }
        }
    }
    say_none(wish, count, other, f);
    return NULL;
}

int find_again(port_info *info) {
    port_info list[FIND_ROOM];
    const unsigned count = port_list(list, FIND_ROOM);
    for (unsigned i = 0; i < count; i++) {
        const port_info *p = &list[i];
        if (p->vendor == info->vendor && p->id == info->id && p->interface == info->interface &&
            strcmp(p->serial, info->serial) == 0) {
            *info = *p;
            return 1;
        }
    }
    return 0;
}
