/* stream - see stream.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/sources/stream.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "host_tools/base/clock.h"

enum { ROOM = 65536, TICK_MS = 4 };

int stream_open(stream *s, const char *path) {
    const int is_input = strcmp(path, "-") == 0;
    s->fd = is_input ? STDIN_FILENO : open(path, O_RDONLY | O_CLOEXEC);
    s->bytes = s->fd < 0 ? NULL : malloc(ROOM);
    return s->bytes == NULL ? -1 : 0;
}

void stream_close(stream *s) {
    if (s->fd >= 0 && s->fd != STDIN_FILENO) { /* fd is 0 when it was never opened */
        close(s->fd);
    }
    free(s->bytes);
    *s = (stream){.fd = -1, .tick = s->tick, .context = s->context};
}

/* Waits for bytes or the end of the stream; 0: the tick wants no more. */
static int wait_for(stream *s) {
    struct pollfd p = {.fd = s->fd, .events = POLLIN};
    if (poll(&p, 1, 0) != 0) { /* an error shows when it is read */
        return 1;
    }
    const double began = clock_seconds();
    int ready = 0, enough = 0;
    while (ready <= 0 && !enough) {
        enough = s->tick != NULL && s->tick(s->context);
        ready = poll(&p, 1, TICK_MS);
    }
    s->waited += clock_seconds() - began;
    return !enough;
}

/* Reads into an empty buffer, after the byte that may be put back. */
static int fill(stream *s) {
    const uint8_t last = s->used > 0 ? s->bytes[s->used - 1] : 0;
    ssize_t got = -1;
    while (wait_for(s)) {
        got = read(s->fd, s->bytes + 1, ROOM - 1);
        if (got >= 0 || (errno != EINTR && errno != EAGAIN)) {
            break;
        }
    }
    if (got <= 0) {
        s->is_wrong |= got < 0;
        return 0;
    }
    s->bytes[0] = last;
    s->used = 1;
    s->filled = 1 + (size_t)got;
    return 1;
}

int stream_byte(stream *s) {
    return s->used < s->filled || fill(s) ? s->bytes[s->used++] : -1;
}

void stream_back(stream *s) {
    s->used--;
}

size_t stream_read(stream *s, void *to, size_t count) {
    size_t done = 0;
    while (done < count && (s->used < s->filled || fill(s))) {
        const size_t there = s->filled - s->used,
                     more = count - done < there ? count - done : there;
        memcpy((uint8_t *)to + done, s->bytes + s->used, more);
        s->used += more;
        done += more;
    }
    return done;
}

int stream_line(stream *s, char *to, size_t room) {
    for (size_t n = 0; n < room; n++) {
        const int c = stream_byte(s);
        if (c < 0) {
            break;
        }
        if (c == '\n') {
            to[n] = '\0';
            return 0;
        }
        to[n] = (char)c;
    }
    return -1;
}
