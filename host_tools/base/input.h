/* input - a whole file in memory, with the errors a person can act on
 *
 * SPDX-License-Identifier: MIT */
#ifndef INPUT_H
#define INPUT_H
#include <stddef.h>

#include "host_tools/base/fail.h"

typedef struct input {
    const char *path;     /* not owned */
    unsigned char *bytes; /* owned; one zero byte follows the last */
    size_t size;
    size_t counted; /* bytes, in base/heap.h */
} input;

/* Reads `path` ("-": standard input). Refuses directories, empty files, files that cannot
 * be held in memory and files that are being written, with a remedy in `f`. No output of the
 * program may be this file from then on. */
int input_read(input *in, const char *path, fail *f);
void input_free(input *in);

/* A file that is to be read later: no output of the program may be it from now on, either. */
int input_claim(const char *path, fail *f);

#endif
