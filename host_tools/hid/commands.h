/* commands - what planelet-hid can do, one function per command
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_COMMANDS_H
#define HID_COMMANDS_H

#include "host_tools/app/args.h"

extern const arg_command hid_command_list, hid_command_show, hid_command_rules;
int hid_run_list(args *a);
int hid_run_show(args *a);
int hid_run_rules(args *a);

#endif
