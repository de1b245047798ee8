/* program - reads the first word of a command line: a command, help or --version
 *
 * SPDX-License-Identifier: MIT */
#ifndef PROGRAM_H
#define PROGRAM_H

#include "host_tools/app/args.h"

/* A command ends with one of these statuses. */
enum { PROGRAM_DONE = 0, PROGRAM_FAILED = 1, PROGRAM_WRONG_USAGE = 2 };

typedef struct program_command {
    const arg_command *command;
    int (*run)(args *a); /* a status; prints one line about what failed */
} program_command;

typedef struct program {
    const char *name;    /* "planelet" */
    const char *about;   /* "ray tracing in a fixed block of memory" */
    const char *example; /* lines for the end of the overview */
    const program_command *commands;
    int count;
} program;

/* What main returns. */
int program_main(const program *p, int argc, char **argv);

#endif
