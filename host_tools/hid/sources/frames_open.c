/* frames_open - see frames_open.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/sources/frames_open.h"

#include <errno.h>
#include <string.h>

#include "host_tools/base/files.h"
#include "host_tools/hid/sources/frames_kinds.h"

int frames_open(frames *s, args *a, const char *path, unsigned width, unsigned height, fail *f) {
    s->path = strcmp(path, "-") == 0 ? "standard input" : path;
    if (stream_open(&s->from, path) != 0) {
        return fail_set(f, s->path, "cannot open: %s; check the path", strerror(errno));
    }
    if (files_read(s->from.fd, s->path, f) != 0) {
        return -1;
    }
    const int first = stream_byte(&s->from);
    if (first >= 0) {
        stream_back(&s->from);
    }
    switch (first) {
    case -1:
        return fail_set(f, s->path, "is empty or no file; name a picture, a film or a scene");
    case 'Y':
        return frames_y4m(s, f);
    case 'P':
        /* A scene begins with "PLANELET". */
        stream_byte(&s->from);
        const int second = stream_byte(&s->from);
        if (second == 'L') {
            return frames_scene(s, a, width, height, f);
        }
        if (second >= 0) {
            stream_back(&s->from);
        }
        return frames_pnm(s, f);
    case 0x89:
        return frames_png(s, f);
    default:
        return fail_set(f, s->path,
                        "is no Y4M, PPM, PGM, PNG or packed scene; convert it to one of them");
    }
}

void frames_close(frames *s) {
    if (s->close != NULL) {
        s->close(s);
    }
    stream_close(&s->from);
    *s = (frames){.from = s->from, .keys = s->keys, .steer = s->steer};
}
