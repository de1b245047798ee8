/* main - planelet-hid: pictures, films and scenes to displays on USB
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <string.h>

#include "engine/planelet.h"
#include "host_tools/hid/commands.h"

static const struct {
    const arg_command *command;
    int (*run)(args *a);
} commands[] = {{&hid_command_list, hid_run_list},
                {&hid_command_show, hid_run_show},
                {&hid_command_rules, hid_run_rules}};

enum { COMMANDS = sizeof commands / sizeof commands[0] };

static void overview(FILE *to) {
    fprintf(to, "planelet-hid %d.%d - pictures on displays that speak USB HID\n\n",
            PLT_VERSION_MAJOR, PLT_VERSION_MINOR);
    for (int i = 0; i < COMMANDS; i++) {
        const arg_command *c = commands[i].command;
        fprintf(to, "  planelet-hid %-6s %s\n", c->name, c->synopsis);
    }
    fprintf(to,
            "\nplanelet-hid COMMAND --help says more. What is plugged in, then a picture:\n\n"
            "  planelet-hid list\n"
            "  planelet-hid show picture.png\n"
            "  planelet-hid show marbles.plt\n"
            "  ffmpeg -i film.mp4 -f yuv4mpegpipe - | planelet-hid show -\n");
}

static int run(int number, int argc, char **argv) {
    args a;
    int status = args_parse(&a, commands[number].command, argc, argv);
    if (status == ARGS_GO_ON) {
        status = commands[number].run(&a);
    }
    args_free(&a);
    return status;
}

int main(int argc, char **argv) {
    if (argc < 2) {
        overview(stderr);
        return 2;
    }
    for (int i = 0; i < COMMANDS; i++) {
        if (strcmp(argv[1], commands[i].command->name) == 0) {
            return run(i, argc - 2, argv + 2);
        }
    }
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0 ||
        strcmp(argv[1], "help") == 0) {
        overview(stdout);
        return 0;
    }
    if (strcmp(argv[1], "--version") == 0) {
        printf("planelet-hid %d.%d\n", PLT_VERSION_MAJOR, PLT_VERSION_MINOR);
        return 0;
    }
    fprintf(stderr, "planelet-hid: there is no command '%s'; see planelet-hid --help\n", argv[1]);
    return 2;
}
