/* frames - see frames.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/frames.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* A picture file of 32768 x 32768 pixels, stored as such, is larger; nobody
 * shows one on a small display. */
static const size_t PICTURE_BYTES_MAX = (size_t)1 << 28;

int frames_room(picture *p, unsigned width, unsigned height, fail *f) {
    if (p->rgb != NULL && p->width == width && p->height == height) {
        return 0;
    }
    picture_free(p);
    return picture_make(p, width, height, f);
}

unsigned char *frames_read_all(frames *s, size_t *bytes, fail *f) {
    size_t room = 65536, used = 0;
    unsigned char *all = malloc(room);
    while (all != NULL) {
        used += fread(all + used, 1, room - used, s->file);
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
    if (all == NULL || used == room || ferror(s->file)) {
        fail_set(f, s->path,
                 ferror(s->file) ? "cannot be read to its end; check the disk"
                                 : "is too large for a picture; make it smaller");
        free(all);
        return NULL;
    }
    return all;
}

static int open_file(frames *s, const char *path, fail *f) {
    const int is_stream = strcmp(path, "-") == 0;
    s->path = is_stream ? "standard input" : path;
    s->file = is_stream ? stdin : fopen(path, "rb");
    if (s->file == NULL) {
        return fail_set(f, path, "cannot open: %s; check the path", strerror(errno));
    }
    return 0;
}

int frames_open(frames *s, args *a, const char *path, unsigned width, unsigned height, fail *f) {
    if (open_file(s, path, f) != 0) {
        return -1;
    }
    const int first = getc(s->file);
    ungetc(first, s->file);
    switch (first) {
    case EOF:
        return fail_set(f, s->path, "is empty or no file; name a picture, a film or a scene");
    case 'Y':
        return frames_y4m(s, f);
    case 'P':
        /* A scene begins with "PLANELET". */
        getc(s->file);
        const int second = getc(s->file);
        if (second == 'L') {
            return frames_scene(s, a, width, height, f);
        }
        ungetc(second, s->file);
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
    if (s->file != NULL && s->file != stdin) {
        fclose(s->file);
    }
    *s = (frames){.tick = s->tick, .context = s->context};
}
