/* frames - see frames.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/sources/frames.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* A picture file of 32768 x 32768 pixels, stored as such, is larger; nobody
 * shows one on a small display. */
static const size_t PICTURE_BYTES_MAX = (size_t)1 << 28;

int frames_cut(const frames *s, const char *otherwise, fail *f) {
    return fail_set(f, s->path, "%s",
                    s->from.is_wrong ? "cannot be read to its end; check the disk or the pipe"
                                     : otherwise);
}

unsigned char *frames_read_all(frames *s, size_t *bytes, fail *f) {
    size_t room = 65536, used = 0;
    unsigned char *all = malloc(room);
    while (all != NULL) {
        used += stream_read(&s->from, all + used, room - used);
        if (used < room || room >= PICTURE_BYTES_MAX) {
            break;
        }
        unsigned char *more = realloc(all, room *= 2);
        if (more == NULL) {
            free(all);
        }
        all = more;
    }
    *bytes = used;
    if (all == NULL || used == room || s->from.is_wrong) {
        frames_cut(s, "is too large for a picture; make it smaller", f);
        free(all);
        return NULL;
    }
    return all;
}

int frames_open(frames *s, args *a, const char *path, unsigned width, unsigned height, fail *f) {
    s->path = strcmp(path, "-") == 0 ? "standard input" : path;
    if (stream_open(&s->from, path) != 0) {
        return fail_set(f, s->path, "cannot open: %s; check the path", strerror(errno));
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
    *s = (frames){.from = s->from};
}
