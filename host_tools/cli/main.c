/* main - planelet: scenes in, pictures and hits out
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/program.h"
#include "host_tools/cli/commands.h"

static const program_command commands[] = {
    {&command_make, run_make},     {&command_pack, run_pack},   {&command_info, run_info},
    {&command_render, run_render}, {&command_view, run_view},   {&command_trace, run_trace},
    {&command_serve, run_serve},   {&command_bench, run_bench}, {&command_tables, run_tables}};

static const program planelet = {.name = "planelet",
                                 .about = "ray tracing in a fixed block of memory",
                                 .example =
                                     "A first picture:\n\n"
                                     "  planelet make marbles -o marbles.ply\n"
                                     "  planelet pack marbles.ply -o marbles.plt\n"
                                     "  planelet render marbles.plt -o marbles.png --show\n",
                                 .commands = commands,
                                 .count = sizeof commands / sizeof commands[0]};

int main(int argc, char **argv) {
    return program_main(&planelet, argc, argv);
}
