/* place - see place.h
 *
 * Both names are the kernel's (Documentation/ABI/stable/sysfs-bus-usb): an interface is
 * BUS-PORT.PORT:CONFIGURATION.INTERFACE, which hidapi's libusb backend also makes its paths of.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/device/place.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* Skips a number; NULL: there is none. */
static const char *after_number(const char *at) {
    const size_t digits = at == NULL ? 0 : strspn(at, "0123456789");
    return digits > 0 ? at + digits : NULL;
}

/* Skips `mark` and a number. */
static const char *after_mark(const char *at, char mark) {
    return at != NULL && *at == mark ? after_number(at + 1) : NULL;
}

/* Whether the name is an interface's; then the port is in `place`. */
static int read_interface(const char *name, char place[PLACE_BYTES]) {
    const char *at = after_mark(after_number(name), '-');
    while (at != NULL && *at == '.') {
        at = after_number(at + 1);
    }
    const char *const rest = after_mark(after_mark(at, ':'), '.');
    if (rest == NULL || *rest != '\0' || at - name >= PLACE_BYTES) {
        return 0;
    }
    memcpy(place, name, (size_t)(at - name));
    place[at - name] = '\0';
    return 1;
}

void place_in(const char *sys, const char *path, char place[PLACE_BYTES]) {
    char link[400], target[1024];
    place[0] = '\0';
    if (read_interface(path, place) || strncmp(path, "/dev/hidraw", 11) != 0) {
        return;
    }
    snprintf(link, sizeof link, "%s/class/hidraw/%s", sys, path + 5);
    const ssize_t bytes = readlink(link, target, sizeof target - 1);
    target[bytes > 0 ? bytes : 0] = '\0';
    /* ".../usb1/1-2/1-2.4/1-2.4:1.1/0003:1038:1618.0007/hidraw/hidraw3" */
    for (char *name = target; name != NULL && place[0] == '\0';) {
        name = strrchr(target, '/');
        if (name != NULL) {
            read_interface(name + 1, place);
            *name = '\0';
        }
    }
}
