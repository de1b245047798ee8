/* find - see find.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/device/find.h"

#include <stdio.h>
#include <stdlib.h>
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

static const driver *find_among(const find_wish *wish, const port_info *list, unsigned count,
                                port_info *info, fail *f) {
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

const driver *find_display(const find_wish *wish, port_info *info, fail *f) {
    port_info *list;
    const unsigned count = port_list(&list);
    const driver *by = find_among(wish, list, count, info, f);
    free(list);
    return by;
}

/* Whether `now`, an equal device, is at a place or path where only the one that was `info` can be.
 */
static int is_where_it_was(const find_wish *wish, const port_info *info, const port_info *now) {
    if (info->place[0] != '\0') {
        return strcmp(now->place, info->place) == 0;
    }
    const int by_path = wish->device != NULL && strcmp(wish->device, info->path) == 0;
    return strcmp(now->path, info->path) == 0 ||
           (!by_path && info->equals == 0 && now->equals == 0);
}

int find_again(const find_wish *wish, port_info *info) {
    port_info *list;
    const unsigned count = port_list(&list), equals = info->equals;
    int is_there = 0;
    for (unsigned i = 0; i < count && !is_there; i++) {
        is_there = port_is_equal(&list[i], info) && is_where_it_was(wish, info, &list[i]);
        if (is_there) {
            *info = list[i];
            info->equals = list[i].equals > equals ? list[i].equals : equals;
        }
    }
    free(list);
    return is_there;
}
