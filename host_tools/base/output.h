/* output - a file that appears whole or not at all
 *
 * Bytes go to a temporary file beside the target; `output_commit` flushes
 * it, checks every error the system can report (a full disk often shows
 * only at close), and renames it over the target. `output_abandon`, a
 * normal exit without commit, SIGINT, SIGTERM and SIGHUP remove it. The
 * path "-" is standard output, which cannot be undone.
 *
 * SPDX-License-Identifier: MIT */
#ifndef OUTPUT_H
#define OUTPUT_H
#include <stddef.h>

#include "host_tools/base/fail.h"

typedef struct output output;

output *output_open(const char *path, fail *f); /* NULL on failure */
int output_write(output *o, const void *bytes, size_t count, fail *f);
int output_print(output *o, fail *f, const char *format, ...) __attribute__((format(printf, 3, 4)));
int output_commit(output *o, fail *f); /* frees `o`, also on failure */
void output_abandon(output *o);        /* frees `o`; NULL is allowed */

#endif
