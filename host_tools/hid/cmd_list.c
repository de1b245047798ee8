/* cmd_list - planelet-hid list: what is plugged in, and what can be shown on
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>

#include "host_tools/hid/commands.h"
#include "host_tools/hid/device/find.h"
#include "host_tools/hid/drivers/drivers.h"

static const arg_flag flags[] = {{"--all", NULL, "also HID devices that no driver is for"},
                                 {"--keys", NULL, "what the keys of each display do to a scene"},
                                 {NULL, NULL, NULL}};

const arg_command hid_command_list = {
    "list",
    "[--all] [--keys]",
    "Lists displays that are plugged in, each once: path, vid:pid, serial number, driver, names. "
    "Drivers with a * are " DISPLAY_DISCLAIMER ".",
    flags,
    0,
    0,
    NULL,
    NULL};

static void print_device(const port_info *p, const driver *by) {
    printf("%-16s %04x:%04x  %-12s %-20s %s%s%s\n", p->path, p->vendor, p->id,
           p->serial[0] == '\0' ? "-" : p->serial, by == NULL ? "-" : by->name, p->maker,
           p->maker[0] == '\0' ? "" : " ", p->product);
}

static void print_drivers(void) {
    printf("\ndrivers:\n");
    for (unsigned i = 0; drivers[i] != NULL; i++) {
        printf("  %-20s%c %s\n", drivers[i]->name, drivers[i]->from_notes ? '*' : ' ',
               drivers[i]->about);
    }
    printf("* " DISPLAY_DISCLAIMER "\n");
}

static int has_reset(const display_key *keys) {
    for (; keys->name != NULL; keys++) {
        if (keys->action == STEER_RESET) {
            return 1;
        }
    }
    return 0;
}

static void print_keys(const driver *by) {
    if (by->keys == NULL) {
        printf("\n%s: none\n", by->name);
        return;
    }
    printf("\n%s:\n", by->name);
    for (const display_key *k = by->keys; k->name != NULL; k++) {
        printf("  %-16s %s\n", k->name, steer_names[k->action]);
    }
    if (!has_reset(by->keys)) {
        printf("  %-16s %s\n", "nearer, farther", steer_names[STEER_RESET]);
    }
}

static int print_all_keys(void) {
    printf(
        "what the keys of displays do to a scene that is shown, again and again while they are "
        "held:\n");
    for (unsigned i = 0; drivers[i] != NULL; i++) {
        print_keys(drivers[i]);
    }
    return 0;
}

int hid_run_list(args *a) {
    if (args_has(a, "--keys")) {
        return print_all_keys();
    }
    port_info *list;
    const unsigned count = port_list(&list);
    unsigned shown = 0;
    for (unsigned i = 0; i < count; i++) {
        const driver *by = driver_for(drivers, &list[i]);
        if (by != NULL || args_has(a, "--all")) {
            print_device(&list[i], by);
            shown++;
        }
    }
    if (shown == 0) {
        printf("no display is plugged in (%u HID devices; --all lists them)\n", count);
    }
    free(list);
    print_drivers();
    return 0;
}
