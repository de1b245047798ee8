/* main - planelet-hid: pictures, films and scenes to displays on USB
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/program.h"
#include "host_tools/hid/commands.h"

static const program_command commands[] = {{&hid_command_list, hid_run_list},
                                           {&hid_command_show, hid_run_show},
                                           {&hid_command_rules, hid_run_rules}};

static const program planelet_hid = {
    .name = "planelet-hid",
    .about = "pictures on displays that speak USB HID",
    .example =
        "What is plugged in, then a picture:\n\n"
        "  planelet-hid list\n"
        "  planelet-hid show picture.png\n"
        "  planelet-hid show marbles.plt\n"
        "  ffmpeg -i film.mp4 -f yuv4mpegpipe - | planelet-hid show -\n",
    .commands = commands,
    .count = sizeof commands / sizeof commands[0]};

int main(int argc, char **argv) {
    return program_main(&planelet_hid, argc, argv);
}
