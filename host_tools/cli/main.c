/* main - planelet: scenes in, pictures and hits out
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <string.h>

#include "engine/planelet.h"
#include "host_tools/base/fail.h"
#include "host_tools/cli/commands.h"

static const cli_command commands[] = {{&command_make, run_make},   {&command_pack, run_pack},
                                       {&command_info, run_info},   {&command_render, run_render},
                                       {&command_trace, run_trace}, {&command_serve, run_serve}};

enum { COMMANDS = sizeof commands / sizeof commands[0] };

static void overview(FILE *to) {
    fprintf(to, "planelet %d.%d - ray tracing in a fixed block of memory\n\n", PLT_VERSION_MAJOR,
            PLT_VERSION_MINOR);
    for (int i = 0; i < COMMANDS; i++) {
        const arg_command *c = commands[i].command;
        fprintf(to, "  planelet %-7s %s\n", c->name, c->synopsis);
    }
    fprintf(to,
            "\nplanelet COMMAND --help says more. A first picture:\n\n"
            "  planelet make marbles -o marbles.ply\n"
            "  planelet pack marbles.ply -o marbles.plt\n"
            "  planelet render marbles.plt -o marbles.png --show\n");
}

static int run(const cli_command *c, int argc, char **argv) {
    args a;
    int status = args_parse(&a, c->command, argc, argv);
    if (status == ARGS_GO_ON) {
        status = c->run(&a);
    }
    args_free(&a);
    return status;
}

static const cli_command *find(const char *name) {
    for (int i = 0; i < COMMANDS; i++) {
        if (strcmp(name, commands[i].command->name) == 0) {
            return &commands[i];
        }
    }
    return NULL;
}

static int unknown(const char *name) {
    fail f = {""}; /* hides control characters */
    fail_set(&f, NULL, "planelet: there is no command '%s'; see planelet --help", name);
    fprintf(stderr, "%s\n", f.text);
    return 2;
}

/* planelet help [COMMAND] */
static int help(int argc, char **argv) {
    if (argc == 0) {
        overview(stdout);
        return 0;
    }
    const cli_command *c = find(argv[0]);
    if (c == NULL) {
        return unknown(argv[0]);
    }
    args_help(c->command);
    return 0;
}

static int dispatch(const char *word, int argc, char **argv) {
    const cli_command *c = find(word);
    if (c != NULL) {
        return run(c, argc, argv);
    }
    if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0 || strcmp(word, "help") == 0) {
        return help(argc, argv);
    }
    if (strcmp(word, "--version") == 0) {
        printf("planelet %d.%d\n", PLT_VERSION_MAJOR, PLT_VERSION_MINOR);
        return 0;
    }
    return unknown(word);
}

int main(int argc, char **argv) {
    if (argc < 2) {
        overview(stderr);
        return 2;
    }
    const int status = dispatch(argv[1], argc - 2, argv + 2);
    if ((fflush(stdout) != 0 || ferror(stdout)) && status == 0) {
        fprintf(stderr, "standard output: cannot be written; is the disk full?\n");
        return 1;
    }
    return status;
}
