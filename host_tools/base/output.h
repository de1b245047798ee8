/* output - a file that appears whole or not at all
 *
 * Bytes go to a temporary file beside the target; `output_commit` flushes
 * it, checks every error the system can report (a full disk often shows
 * only at close), and renames it over the target. `output_abandon`, a
 * normal exit without commit, and a signal that ends the program, remove it. The
 * path "-" is standard output, which cannot be undone. A symbolic link is written
 * through, also when what it leads to does not exist.
 *
 * Refused is a file that the program has read (base/input.h), has written or is already
 * writing, or that standard error goes to, under whatever name (base/files.h).
 *
 * SPDX-License-Identifier: MIT */
#ifndef OUTPUT_H
#define OUTPUT_H
#include <stddef.h>

#include "host_tools/base/fail.h"

typedef struct output output;

/* NULL on failure. Standard output that is a terminal, and the terminal of any of the three
 * streams under its name, are for text only. */
output *output_open(const char *path, fail *f);
output *output_open_text(const char *path, fail *f);
int output_write(output *o, const void *bytes, size_t count, fail *f);
int output_print(output *o, fail *f, const char *format, ...) __attribute__((format(printf, 3, 4)));
/* Writes the rest and closes the file, so that only its name is missing: of two outputs both are
 * finished before one is committed. */
int output_finish(output *o, fail *f);
int output_commit(output *o, fail *f); /* frees `o`, also on failure */
void output_abandon(output *o);        /* frees `o`; NULL is allowed */

/* Before text is printed to stdout: -1 when that is closed, or redirected to a file or a pipe
 * that is read or written otherwise. From then on nothing but text, as "-",
 * may go there. */
int output_print_standard(fail *f);

#endif
