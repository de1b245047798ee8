/* args - the words that follow a command: flags with values, and files
 *
 * A command lists its flags once; parsing and the help text both come from
 * that list. Wrong usage prints one line on standard error; the program then
 * ends with status 2.
 *
 * SPDX-License-Identifier: MIT */
#ifndef ARGS_H
#define ARGS_H
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef struct arg_flag {
    const char *name;  /* "--leaf" or "-o" */
    const char *value; /* placeholder of the value in the help; NULL: a switch */
    const char *help;
} arg_flag;

typedef struct arg_command {
    const char *name;      /* "pack" */
    const char *synopsis;  /* "MESH... -o SCENE.plt" */
    const char *about;     /* a sentence */
    const arg_flag *flags; /* ended by a name of NULL */
    int files_least, files_most;
    const char *notes;             /* the end of the help, as it is printed; NULL: none */
    void (*print_notes)(FILE *to); /* the same, of what is listed elsewhere; NULL: nothing is */
} arg_command;

enum { ARGS_FLAGS_MAX = 48 };

typedef struct args {
    const char *program; /* "planelet" */
    const arg_command *command;
    const char *value[ARGS_FLAGS_MAX]; /* by flag; "" for a switch that is set */
    char **file;                       /* in the order given; owned by args */
    int files;
    int wrong; /* a word was refused, and a line printed about it */
} args;

enum { ARGS_GO_ON = -1 };

/* Returns ARGS_GO_ON, or the status to end with (0 after --help, 2). */
int args_parse(args *a, const char *program, const arg_command *command, int argc, char **argv);
void args_free(args *a);
void args_help(const char *program, const arg_command *command);

int args_has(const args *a, const char *flag);
const char *args_text(const args *a, const char *flag, const char *otherwise);

/* Each refuses a value that is out of range through args_complain. */
uint64_t args_number(args *a, const char *flag, uint64_t otherwise, uint64_t least, uint64_t most);
unsigned args_choice(args *a, const char *flag, const char *const *words, unsigned otherwise);
/* Words separated by commas, each one of `words`: a set of bits, bit i for words[i]. */
unsigned args_set(args *a, const char *flag, const char *const *words, unsigned otherwise);
int args_floats(args *a, const char *flag, float *values, unsigned count); /* 1: given */
int args_doubles(args *a, const char *flag, double *values, unsigned count);
/* WIDTHxHEIGHT, each side 1 to `most`. */
int args_size(args *a, const char *flag, unsigned most, unsigned *width, unsigned *height);

/* Prints "PROGRAM COMMAND: TEXT; see PROGRAM COMMAND --help" on standard error and
 * sets `wrong`; once only. */
void args_complain(args *a, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
