/* pack_lines - what was lost of a file, in one line each
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_LINES_H
#define PACK_LINES_H
#include "host_tools/cli/pack_file.h"

/* Its path, but standard input by that name. */
const char *pack_shown(const pack_file *file);

/* On standard error. */
void pack_say_lines(const pack_file *file);

/* Fails because the file has no triangles; returns -1. */
int pack_nothing_to_trace(const pack_file *file, fail *f);

#endif
