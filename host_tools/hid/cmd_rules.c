/* cmd_rules - planelet-hid rules: who may use the displays, for udev
 *
 * host_tools/hid/70-planelet.rules is this text. The number in its name must
 * be below 73: systemd's 73-seat-late.rules is what acts on "uaccess".
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>

#include "host_tools/hid/commands.h"
#include "host_tools/hid/drivers/drivers.h"

static const arg_flag flags[] = {{NULL, NULL, NULL}};

const arg_command hid_command_rules = {
    "rules",
    "",
    "Prints udev rules that let whoever sits at the machine use the displays: planelet-hid rules "
    "| sudo tee /etc/udev/rules.d/70-planelet.rules, then sudo udevadm control --reload, then "
    "plug the display in again.",
    flags,
    0,
    0,
    NULL,
    NULL};

static void print_driver(const driver *by) {
    printf("\n# %s\n", by->about);
    for (const driver_id *id = by->ids; id->vendor != 0; id++) {
        printf(
            "KERNEL==\"hidraw*\", ATTRS{idVendor}==\"%04x\", ATTRS{idProduct}==\"%04x\", "
            "TAG+=\"uaccess\"\n"
            "SUBSYSTEM==\"usb\", ATTR{idVendor}==\"%04x\", ATTR{idProduct}==\"%04x\", "
            "TAG+=\"uaccess\"\n",
            id->vendor, id->id, id->vendor, id->id);
    }
}

int hid_run_rules(args *a) {
    (void)a;
    printf(
        "# 70-planelet.rules - USB displays for whoever sits at the machine\n"
        "# Made by: planelet-hid rules. SPDX-License-Identifier: MIT\n");
    for (unsigned i = 0; drivers[i] != NULL; i++) {
        print_driver(drivers[i]);
    }
    return 0;
}
