/* script - what happens to displays on the fake bus, and when: the HID bench of tests without a
 * kernel
 *
 * A script is text, a line each:
 *
 *     device KIND PATH [SERIAL [PLACE [COLLECTIONS]]]   a model of tests/hid, by its driver's name;
 *                                                       - is no serial number, or no known place
 *     others COUNT                                      devices that are no displays, before it
 *     EVENT                    at the start
 *     before N EVENT           before report N (from 1, of all devices)
 *     after N MS EVENT         so long after that
 *     at MS EVENT              so long after the start
 *
 * and an EVENT is one of
 *
 *     unplug DEVICE            DEVICE is a number, from 0 in the order of the lines
 *     plug DEVICE [PATH]       again, perhaps with another path
 *     dark DEVICE              its panel loses its picture, nothing else
 *     refuse COUNT             the next reports fail at once
 *     late MS                  every feature report is carried out, and fails so much later; 0: no
 *                              more
 *     slow US                  every report takes so long
 *     stall MS                 the next report takes so long, and then fails
 *     deny 0|1                 nothing can be opened
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_SCRIPT_H
#define HID_SCRIPT_H

#include <stdint.h>
#include <stdio.h>

#include "tests/hid/model.h"
#include "tests/reference/fake_hidapi.h"

enum { SCRIPT_DEVICES = 4, SCRIPT_EVENTS = 64, SCRIPT_OTHERS = 70, SCRIPT_TEXT = 64 };

enum script_what {
    SCRIPT_UNPLUG,
    SCRIPT_PLUG,
    SCRIPT_DARK,
    SCRIPT_REFUSE,
    SCRIPT_LATE,
    SCRIPT_SLOW,
    SCRIPT_STALL,
    SCRIPT_DENY,
    SCRIPT_WHATS
};

typedef struct script_event {
    uint64_t report; /* before this one; 0: by the clock */
    double at;       /* seconds after the start, or after that report */
    enum script_what what;
    unsigned value; /* device, count, milliseconds */
    char path[SCRIPT_TEXT];
    int is_done;
} script_event;

typedef struct script_device {
    model *model; /* owned */
    fake_device device;
    char path[SCRIPT_TEXT], place[SCRIPT_TEXT];
    wchar_t serial[SCRIPT_TEXT];
    unsigned reports; /* that reached it */
} script_device;

typedef struct script {
    script_device devices[SCRIPT_DEVICES];
    unsigned count;
    fake_device others[SCRIPT_OTHERS];
    char other_paths[SCRIPT_OTHERS][24];
    unsigned other_count;
    script_event events[SCRIPT_EVENTS];
    unsigned event_count;
    uint64_t reports;
    double began;
} script;

/* Adds a device or an event; -1: there is no such kind, or no room. */
int script_add_device(script *s, const model_kind *kind, const char *path, const char *serial,
                      const char *place, unsigned collections);
int script_add(script *s, script_event event);

/* Adds the lines of a file; 0, or the number of the line that is wrong. */
int script_read(script *s, FILE *file);

/* Resets the fake bus and plugs everything in. The script is zero before the first call of any of
 * these. */
void script_begin(script *s);
void script_free(script *s);

#endif
