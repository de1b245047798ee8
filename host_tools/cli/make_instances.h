/* make_instances - planelet make marbles --instances: a text of matrices, and two meshes
 *
 * SPDX-License-Identifier: MIT */
#ifndef MAKE_INSTANCES_H
#define MAKE_INSTANCES_H
#include <stdint.h>

#include "host_tools/base/fail.h"

/* Ends in .txt, behind something. */
int make_instances_has_name(const char *out);

/* Its meshes, named after it, can be named in the text: no blank is in the name, nor # first. */
int make_instances_can_be_named(const char *out);

/* Frames first .. first + frames - 1, which the text numbers from 0. */
int make_instances(const char *out, uint64_t triangles, unsigned first, unsigned frames, fail *f);

#endif
