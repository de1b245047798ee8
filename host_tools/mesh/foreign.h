/* foreign - files that people try to pack and that are no mesh of ours
 *
 * SPDX-License-Identifier: MIT */
#ifndef FOREIGN_H
#define FOREIGN_H
#include "host_tools/base/input.h"

/* By content: "is ...; ..." with what to do instead, or NULL when nothing is recognised.
 * Cost: a search through a file that begins like JSON or a zip archive. */
const char *foreign_is(const input *in);

#endif
