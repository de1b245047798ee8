/* commands - what planelet can do, one function per command
 *
 * SPDX-License-Identifier: MIT */
#ifndef COMMANDS_H
#define COMMANDS_H

#include "host_tools/app/args.h"

extern const arg_command command_pack, command_info, command_render, command_trace, command_make;
extern const arg_command command_serve, command_bench, command_tables;
extern const arg_command command_view;
int run_pack(args *a);
int run_info(args *a);
int run_render(args *a);
int run_trace(args *a);
int run_make(args *a);
int run_serve(args *a);
int run_bench(args *a);
int run_tables(args *a);
int run_view(args *a);

#endif
