/* fail - one sentence that says what went wrong, where, and what to do
 *
 * Keeps: a set text is never empty, ends in a zero byte and holds no
 * control character, whatever the file name or the arguments hold.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/base/fail.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Of a longer path only the end is shown: the remedy must still fit. */
enum { PATH_SHOWN = 200 };

static size_t put_path(char *text, size_t room, const char *file) {
    const size_t length = strlen(file);
    const int cut = length > PATH_SHOWN;
    const char *shown = cut ? file + length - PATH_SHOWN : file;
    return (size_t)snprintf(text, room, "%s%s: ", cut ? "..." : "", shown);
}

static void hide_controls(char *text) {
    for (char *c = text; *c; c++) {
        if ((unsigned char)*c < 0x20 || *c == 0x7f) {
            *c = '?';
        }
    }
}

int fail_set(fail *f, const char *file, const char *format, ...) {
    if (f->text[0]) {
        return -1;
    }
    const size_t used = file ? put_path(f->text, sizeof f->text, file) : 0;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(f->text + used, sizeof f->text - used, format, arguments);
    va_end(arguments);
    hide_controls(f->text);
    return -1;
}
