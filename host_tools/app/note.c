/* note - see note.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/note.h"

#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

#include "host_tools/base/fail.h"

void note(const char *format, ...) {
    if (!isatty(STDERR_FILENO)) {
        return;
    }
    char text[512];
    fail line = {""}; /* hides control characters */
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    fail_set(&line, NULL, "%s", text);
    fprintf(stderr, "%s\n", line.text);
}
