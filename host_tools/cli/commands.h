/* commands - one function a command; each returns the exit status
 *
 * 0 done, 1 the input or the run failed (one line on standard error), 2 wrong
 * usage.
 *
 * SPDX-License-Identifier: MIT */
#ifndef COMMANDS_H
#define COMMANDS_H

#include "host_tools/cli/args.h"

typedef struct cli_command {
    const arg_command *command;
    int (*run)(args *a);
} cli_command;

extern const arg_command command_pack, command_info, command_render, command_trace, command_make;
extern const arg_command command_serve;
int run_pack(args *a);
int run_info(args *a);
int run_render(args *a);
int run_trace(args *a);
int run_make(args *a);
int run_serve(args *a);

#endif
