/* stream - bytes of a file or a pipe; a wait for them can be used for other work
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_STREAM_H
#define HID_STREAM_H

#include <stddef.h>
#include <stdint.h>

/* Called every few milliseconds while no bytes come. Not 0: the stream ends here. */
typedef int stream_tick(void *context);

typedef struct stream {
    int fd;              /* owned unless it is standard input; -1: none */
    int is_wrong;        /* reading failed */
    stream_tick *tick;   /* may be NULL */
    void *context;       /* handed to tick */
    double waited;       /* seconds without bytes, since the caller set it to 0 */
    uint8_t *bytes;      /* owned: what was read ahead */
    size_t used, filled; /* of bytes */
} stream;

/* "-" is standard input. `s` holds tick and context, the rest zero. -1: errno
 * says why. */
int stream_open(stream *s, const char *path);
void stream_close(stream *s); /* also after a failed open */

/* The next byte, or -1 at the end. */
int stream_byte(stream *s);

/* Puts back the byte read last, once. */
void stream_back(stream *s);

/* Bytes read: fewer than `count` only at the end. */
size_t stream_read(stream *s, void *to, size_t count);

/* A line of at most room - 1 bytes without its end, as a string; -1: it is
 * longer, or the stream ends before. */
int stream_line(stream *s, char *to, size_t room);

#endif
