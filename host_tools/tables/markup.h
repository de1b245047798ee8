/* markup - a text in HTML or SVG
 *
 * SPDX-License-Identifier: MIT */
#ifndef MARKUP_H
#define MARKUP_H

#include "host_tools/base/output.h"

/* What would be markup as references, also in attributes; what is not printable as '?'. Bytes of
 * UTF-8 stay. */
void markup_text(output *o, const char *text, fail *f);

#endif
