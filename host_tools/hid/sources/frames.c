/* frames - see frames.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/sources/frames.h"

#include <stdlib.h>

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
