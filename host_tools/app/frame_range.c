/* frame_range - see frame_range.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/frame_range.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int frame_range_read(frame_range *r, const char *text) {
    unsigned first = 0, end = 0;
    int length = 0;
    if (strspn(text, "0123456789:") != strlen(text) ||
        sscanf(text, "%6u:%6u%n", &first, &end, &length) != 2 || text[length] != '\0' ||
        first >= end || end > FRAME_RANGE_END) {
        return -1;
    }
    *r = (frame_range){first, end - first};
    return 0;
}

int frame_range_is_pattern(const char *name) {
    return strstr(name, "{}") != NULL;
}

char *frame_range_file(const char *name, unsigned number) {
    const char *at = strstr(name, "{}");
    const size_t room = strlen(name) + 16;
    char *file = malloc(room);
    if (file != NULL && at != NULL) {
        snprintf(file, room, "%.*s%03u%s", (int)(at - name), name, number, at + 2);
    } else if (file != NULL) {
        snprintf(file, room, "%s", name);
    }
    return file;
}
