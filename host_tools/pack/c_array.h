/* c_array - a scene image as C source, for a firmware to hold in flash
 *
 * SPDX-License-Identifier: MIT */
#ifndef C_ARRAY_H
#define C_ARRAY_H
#include "host_tools/pack/pack.h"

/* What the first line of every such file says. */
#define C_ARRAY_MARK "a scene image as a C array, written by planelet pack"

/* 1: `path` ends in .c or .h, in any case. */
int c_array_wanted(const char *path);

/* 1: the file at `path` begins as such files do. */
int c_array_is(const char *path);

/* Writes `image` as C11 and C++11, named after `path`: a .h defines static data and what
 * plt_source takes, a .c data for the whole program. `command` is what made it; characters
 * that a comment cannot hold are replaced. The same image, path and command give the same
 * bytes. Cost: 3.4 characters per byte of an image of random bytes, lines of 100 columns
 * at most. */
int c_array_write(output *o, const char *path, const packed *image, const char *command, fail *f);

#endif
