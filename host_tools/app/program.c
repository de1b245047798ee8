/* program - see program.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/program.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "engine/planelet.h"
#include "host_tools/base/fail.h"
#include "host_tools/base/files.h"
#include "host_tools/base/standard.h"

static int longest_name(const program *p) {
    size_t longest = 0;
    for (int i = 0; i < p->count; i++) {
        const size_t length = strlen(p->commands[i].command->name);
        longest = length > longest ? length : longest;
    }
    return (int)longest;
}

static void overview(const program *p, FILE *to) {
    const int width = longest_name(p);
    fprintf(to, "%s %d.%d - %s\n\n", p->name, PLT_VERSION_MAJOR, PLT_VERSION_MINOR, p->about);
    for (int i = 0; i < p->count; i++) {
        const arg_command *c = p->commands[i].command;
        fprintf(to, "  %s %-*s  %s\n", p->name, width, c->name, c->synopsis);
    }
    fprintf(to, "\n%s COMMAND --help says more. %s", p->name, p->example);
}

static int run(const program *p, const program_command *c, int argc, char **argv) {
    args a;
    int status = args_parse(&a, p->name, c->command, argc, argv);
    if (status == ARGS_GO_ON) {
        status = c->run(&a);
    }
    args_free(&a);
    return status;
}

static const program_command *find(const program *p, const char *name) {
    for (int i = 0; i < p->count; i++) {
        if (strcmp(name, p->commands[i].command->name) == 0) {
            return &p->commands[i];
        }
    }
    return NULL;
}

static int unknown(const program *p, const char *name) {
    fail f = {""}; /* hides control characters */
    fail_set(&f, NULL, "%s: there is no command '%s'; see %s --help", p->name, name, p->name);
    fprintf(stderr, "%s\n", f.text);
    return PROGRAM_WRONG_USAGE;
}

static int is_help(const char *word) {
    return strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0 || strcmp(word, "help") == 0;
}

/* help [COMMAND] */
static int help(const program *p, int argc, char **argv) {
    if (argc == 0 || is_help(argv[0])) {
        overview(p, stdout);
        return PROGRAM_DONE;
    }
    const program_command *c = find(p, argv[0]);
    if (c == NULL) {
        return unknown(p, argv[0]);
    }
    args_help(p->name, c->command);
    return PROGRAM_DONE;
}

static int dispatch(const program *p, const char *word, int argc, char **argv) {
    const program_command *c = find(p, word);
    if (c != NULL) {
        return run(p, c, argc, argv);
    }
    if (is_help(word)) {
        return help(p, argc, argv);
    }
    if (strcmp(word, "--version") == 0) {
        printf("%s %d.%d\n", p->name, PLT_VERSION_MAJOR, PLT_VERSION_MINOR);
        return PROGRAM_DONE;
    }
    return unknown(p, word);
}

int program_main(const program *p, int argc, char **argv) {
    if (standard_open() != 0) {
        fprintf(stderr, "%s: a standard stream is closed, and / cannot be opened; leave it open\n",
                p->name);
        return PROGRAM_FAILED;
    }
    files_open();
    if (argc < 2) {
        overview(p, stderr);
        return PROGRAM_WRONG_USAGE;
    }
    const int status = dispatch(p, argv[1], argc - 2, argv + 2);
    if ((fflush(stdout) != 0 || ferror(stdout)) && status == PROGRAM_DONE) {
        fprintf(stderr, "standard output: cannot be written; %s\n",
                standard_can_write(STDOUT_FILENO) ? "is the disk full?"
                                                  : "it is closed: redirect it to a file");
        return PROGRAM_FAILED;
    }
    return status;
}
